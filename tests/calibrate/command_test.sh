#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# command_test.sh TOOL WRITE_POSES WORK PYTHON_FOLDER: the worked example, from a table of poses to the generated arm; and mistakes, which
# leave nothing behind.
set -euo pipefail
tool=$1 write_poses=$2 work=$3 python=$4
fail() { echo "$*" >&2; exit 1; }
rm -rf "$work" && mkdir -p "$work" && cd "$work"

"$write_poses" ur5 60 > poses.csv
"$tool" calibrate ur5 poses.csv -o my_ur5.toml > report.txt
grep -q '^the zero of joint 3 ' report.txt || fail "no zero of joint 3: $(cat report.txt)"
grep -q 'the offset of link 2 and the offset of link 3 only together with the offset of link 1' report.txt || fail "$(cat report.txt)"
awk '/^position/ { exit !($3 > 1 && $4 < 0.12) }' report.txt || fail "residuals: $(grep ^position report.txt)"
grep -q '^ideal = "ur5"' my_ur5.toml || fail "the ideal arm is not named"
"$tool" check my_ur5.toml
"$tool" generate ur5 my_ur5.toml --only model,kinematics,from_ideal -o code --quiet
[[ -f code/include/qvgen/robots/my_ur5/from_ideal.h ]] || fail "no from_ideal.h"
"$tool" calibrate ur5 poses.csv -o again.toml --name my_ur5 > /dev/null
cmp my_ur5.toml again.toml || fail "two runs differ"

"$write_poses" scara 60 > scara.csv
"$tool" calibrate scara scara.csv --errors lengths -o my_scara.toml > /dev/null
"$tool" generate my_scara.toml --only model,kinematics -o code --quiet

sed '5s/^[^,]*/nan/; 7s/,[^,]*$//' poses.csv > wrong.csv
if "$tool" calibrate ur5 wrong.csv -o wrong.toml 2> errors.txt; then fail "wrong data were taken"; fi
grep -q "wrong.csv:5:1: error: 'q1' is nan" errors.txt && grep -q 'wrong.csv:7:1: error: 12 cells' errors.txt || fail "$(cat errors.txt)"
[[ ! -e wrong.toml && ! -e wrong.toml.unfinished ]] || fail "something was written"

# Planned postures tell more than random ones: what is expected after them is better, and it falls with their number.
"$tool" calibrate ur5 --plan 30 > plan.csv 2> plan30.txt
"$tool" calibrate ur5 --plan 10 > ten.csv 2> plan10.txt
head -11 plan.csv | cmp - ten.csv || fail "a longer plan begins in another way"
[[ $(wc -l < plan.csv) -eq 31 ]] || fail "not 30 postures"
awk '/^expected/ { print $6 }' plan30.txt plan10.txt | paste -sd' ' | awk '{ exit !($1 < $2 && $1 < 0.2) }' || fail "$(cat plan30.txt plan10.txt)"
"$tool" calibrate ur5 poses.csv --plan 5 > more.csv
[[ $(wc -l < more.csv) -eq 6 ]] || fail "not 5 postures"
if "$tool" calibrate ur5 2> errors.txt; then fail "no data were taken"; fi

# Spheres that are kept apart.
printf 'link, x [mm], y [mm], z [mm], radius [mm]\n0, 50, 0, -250, 200\n2, 425, 0, 136, 60\n5, 0, 0, 0, 50\n6, 0, 0, 0, 45\n' > spheres.csv
"$tool" calibrate ur5 --plan 10 --spheres spheres.csv > apart.csv 2> apart.txt
[[ $(wc -l < apart.csv) -eq 11 ]] && grep -q '^4 spheres: those of links that are not neighbours keep 10 mm' apart.txt || fail "$(cat apart.txt)"
cmp -s apart.csv ten.csv && fail "spheres changed nothing"
grep -q 'links may meet' plan10.txt || fail "$(cat plan10.txt)"
sed 's/^6/7/' spheres.csv > wrong_spheres.csv
if "$tool" calibrate ur5 --plan 10 --spheres wrong_spheres.csv > /dev/null 2> errors.txt; then fail "link 7 was taken"; fi
grep -q 'wrong_spheres.csv:5:1: error: there is no link 7' errors.txt || fail "$(cat errors.txt)"

# Other forms of the result.
"$tool" calibrate ur5 poses.csv --format hayati -o table.csv --page page.html > /dev/null
[[ $(grep -c '^[1-6], ' table.csv) -eq 6 ]] || fail "no table: $(cat table.csv)"
for text in '<svg' 'Rows that were not fitted are predicted to' 'the zero of joint 3' 'No data of this kind can tell'; do
  grep -q "$text" page.html || fail "the page lacks $text"
done
if "$tool" calibrate ur5 poses.csv --format urdf -o arm.urdf 2> errors.txt; then fail "TOML became a URDF"; fi
grep -q 'only a URDF can be changed' errors.txt && [[ ! -e arm.urdf ]] || fail "$(cat errors.txt)"
if "$tool" calibrate ur5 poses.csv --format urdf 2> errors.txt; then fail "a format without output"; fi
if "$tool" calibrate ur5 poses.csv --bending 2> errors.txt; then fail "joints bend without masses"; fi
grep -q 'm1 of ur5 has no value' errors.txt || fail "$(cat errors.txt)"

QVGEN_TOOL=$tool PYTHONPATH=$python python3 - <<'PY'
import pathlib, qvgen
report = qvgen.calibrate("ur5", "poses.csv", "from_python.toml", "--name", "my_ur5")
assert "the zero of joint 3" in report
assert pathlib.Path("from_python.toml").read_text() == pathlib.Path("my_ur5.toml").read_text()
try:
    qvgen.calibrate("ur5", "wrong.csv", "wrong.toml")
    raise SystemExit("wrong data were taken")
except qvgen.BuildError as error:
    assert "wrong.csv:5:1" in str(error)
PY
