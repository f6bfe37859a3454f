#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# wheel.sh SOURCE WORK TOOL: packs the sources, makes a wheel of them with the tool and one compiled robot, installs it into a
# fresh environment, without network, and uses it from another folder, without the source tree, Eigen or headers of Python.
set -euo pipefail
source=$1 work=$2 tool=$3
for python in python3 /usr/bin/python3; do
  "$python" -c 'import sys, numpy, venv, ensurepip; sys.exit(sys.version_info < (3, 9))' 2>/dev/null && break
  python=
done
if [[ -z $python ]]; then
  echo "skipped: no Python 3.9 with numpy and venv (python3-numpy python3-venv)"
  exit 77
fi

rm -rf "$work" && mkdir -p "$work/packed"
build="import sys; sys.path.insert(0, '$source/runtime/python/build'); import qvgen_wheel as wheel"
export QVGEN_TOOL=/no/tool
"$python" -c "$build; wheel.build_sdist('$work/packed')" >/dev/null
"$python" -c "$build; first = wheel.build_wheel('$work'); second = wheel.build_wheel('$work/packed'); assert first == second" >/dev/null
cmp "$work"/*-py3-none-any.whl "$work"/packed/*-py3-none-any.whl
rm "$work"/*.whl "$work"/packed/*.whl
[[ -z $(tar tf "$work"/packed/qvgen-*.tar.gz | grep -E '__pycache__|\.so$') ]]

"$python" -m venv --system-site-packages "$work/venv"
export QVGEN_TOOL=$tool
"$work/venv/bin/pip" --quiet --disable-pip-version-check install --no-index --config-settings=robots=ns "$work"/packed/qvgen-*.tar.gz
unset QVGEN_TOOL
cat >"$work/use.py" <<'EOF'
import os, pathlib, subprocess, sys
import numpy, qvgen
work, urdf = sys.argv[1:]
assert pathlib.Path(qvgen.__file__).is_relative_to(work), qvgen.__file__
os.environ["QVGEN_CACHE"] = work + "/cache"
os.environ["QVGEN_EIGEN"] = work + "/no_eigen"

os.environ["CC"] = "false"  # the robot that was asked for needs no compiler
arm = qvgen.robots.ns
assert pathlib.Path(arm.__file__).parent == pathlib.Path(qvgen.__file__).parent / "robots", arm.__file__
q = numpy.random.default_rng(1).uniform(-1, 1, (20, arm.dof))
found = arm.inverse_kinematics(arm.forward_kinematics(q), seed=q)
assert numpy.allclose(found.q[:, 0], q)
assert "puma560" in dir(qvgen.robots) and not os.path.exists(work + "/cache")
try:
    qvgen.robots.puma560
    raise SystemExit("compiled by `false`")
except qvgen.BuildError:
    pass

del os.environ["CC"]  # others are made by the tool that the package has, and compiled
own = qvgen.load(urdf, "--only", "kinematics,inverse")
assert own.forward_kinematics(numpy.zeros(own.dof)).shape == (7,)
assert {"forward_kinematics", "inverse_kinematics"} <= own.functions.keys() and not hasattr(own, "jacobian"), own.functions
assert qvgen.robots.rr_planar.dof == 2
said = subprocess.run([work + "/venv/bin/qvgen", "languages"], check=True, capture_output=True, text=True).stdout
assert "rust" in said, said
licences = {each.name for each in pathlib.Path(qvgen.__file__).parents[1].glob("qvgen-*.dist-info/licenses/*")}
assert {"LICENSE", "GPL-2", "libginac11"} <= licences, licences
EOF
cd "$work"
env -u PYTHONPATH "$work/venv/bin/python" "$work/use.py" "$work" "$source/tests/c/robots/urdf_arm.urdf"
"$work/venv/bin/pip" --quiet --disable-pip-version-check uninstall --yes qvgen
left=$(cd "$work/venv/lib" && find . -path '*qvgen*' -type f)
[[ -z $left ]] || { echo "not uninstalled: $left"; exit 1; }
