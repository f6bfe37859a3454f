#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# limits_in_c.sh FOLDER [POSES] ROBOT...: instructions a call of inverse kinematics in C at -O2 (callgrind), as ratios to all solutions.
# FOLDER has what `qvgen generate --language c` made. Seeds are off by up to 0.1 rad a joint, or as a column says.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
made=$1
poses=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
columns='seed limits wide near_3mrad near_0.1 near_1 near_3 near_limits turns'
{
  printf '%-14s %8s' 'ratios' all
  printf ' %11s' $columns 'wide, a row'
  printf '\n'
} | sed 's/ *$//'
for robot in "$@"; do
  given=()
  [[ $robot != iiwa14 ]] || given=(-DQVGEN_GIVEN=_given_theta3 -DQVGEN_GIVEN_JOINT=2)
  [[ ${#given[@]} != 0 ]] || given=(-DQVGEN_GIVEN=)
  "${CC:-cc}" -std=c11 -O2 -Wall -Wextra -I "$made" -DQVGEN_ROBOT="$robot" -DQVGEN_HEADER="\"qvgen_${robot}_inverse.h\"" "${given[@]}" \
    "$here/limits_in_c.c" "$made/qvgen_$robot.c" "$made/qvgen_${robot}_inverse.c" -lm -o "$folder/program"
  if [[ -n ${QVGEN_HASH-} ]]; then
    "$folder/program" "$poses" hash
    continue
  fi
  rm -f "$folder"/out*
  valgrind --tool=callgrind --callgrind-out-file="$folder/out" "$folder/program" "$poses" 2> "$folder/log"
  awk -v robot="$robot" -v columns="$columns" '
    /^desc: Trigger: Client Request: / { split(substr($0, 32), call, " "); name = call[1] }
    /^totals: / { if (name != "") { sum[name] = $2; poses = call[2]; rows[name] = call[3] } }
    END {
      count = split(columns, names, " ")
      printf "%-14s %8d", robot, sum["all"] / poses
      for (i = 1; i <= count; ++i) printf " %11.2f", sum[names[i]] / sum["all"]
      printf " %11.0f\n", (sum["wide_turns"] - sum["all"]) / rows["wide_turns"]
    }' $(ls -v "$folder"/out.*)
done
