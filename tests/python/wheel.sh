#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# wheel.sh SOURCE WORK TOOL: packs the sources, installs them with one robot compiled into a fresh environment, without
# network, and uses that from another folder.
set -euo pipefail
source=$1 work=$2 tool=$3
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import sys, numpy, venv, ensurepip; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
    headers=$("$python" -c 'import sysconfig; print(sysconfig.get_paths()["include"])')
    [[ -e $headers/Python.h && -e /usr/include/pybind11/pybind11.h ]] && break
  fi
  python=
done
if [[ -z $python ]]; then
  echo "skipped: no Python 3.11 with numpy, venv, its headers and pybind11 (python3-dev python3-numpy python3-venv pybind11-dev)"
  exit 77
fi

rm -rf "$work" && mkdir -p "$work/packed"
build="import sys; sys.path.insert(0, '$source/runtime/python/build'); import qvgen_wheel as wheel"
"$python" -c "$build; wheel.build_sdist('$work/packed')" >/dev/null
"$python" -c "$build; first = wheel.build_wheel('$work'); second = wheel.build_wheel('$work/packed'); assert first == second"
cmp "$work"/*-py3-none-any.whl "$work"/packed/*-py3-none-any.whl
rm "$work"/packed/*.whl
[[ -z $(tar tf "$work"/packed/qvgen-*.tar.gz | grep -E '__pycache__|\.so$') ]]

"$python" -m venv --system-site-packages "$work/venv"
"$work/venv/bin/pip" --quiet --disable-pip-version-check install --no-index --config-settings=robots=ns "$work"/packed/qvgen-*.tar.gz
cat >"$work/use.py" <<'EOF'
import os, pathlib, sys
import numpy, qvgen
work, tool, urdf = sys.argv[1:]
assert pathlib.Path(qvgen.__file__).is_relative_to(work), qvgen.__file__
os.environ["QVGEN_CACHE"] = work + "/cache"

compiler = os.environ.pop("CXX", "c++")
os.environ["CXX"] = "false"  # the robot that was asked for needs no compiler
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

os.environ["CXX"] = compiler  # and others are compiled from the sources that the package has
os.environ["QVGEN_TOOL"] = tool
own = qvgen.load(urdf, "--only", "kinematics")
assert own.forward_kinematics(numpy.zeros(own.dof)).shape == (7,)
assert own.functions.keys() == {"forward_kinematics", "homogeneous_transform"}, own.functions
EOF
cd "$work"
env -u PYTHONPATH "$work/venv/bin/python" "$work/use.py" "$work" "$tool" "$source/tests/c/robots/urdf_arm.urdf"
"$work/venv/bin/pip" --quiet --disable-pip-version-check uninstall --yes qvgen
left=$(cd "$work/venv/lib" && find . -path '*qvgen*' -type f)
[[ -z $left ]] || { echo "not uninstalled: $left"; exit 1; }
