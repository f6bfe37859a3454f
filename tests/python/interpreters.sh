#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# interpreters.sh VERSION SOURCE WORK TOOL: runs the tests of this folder with CPython VERSION against the installed wheel.
#
# The interpreter is python3.x on the path, of pyenv, of manylinux images (/opt/python), or in a folder of $QVGEN_PYTHONS; else that of
# a Debian which has this version. The wheel goes into a fresh environment, with packages of PyPI that its tests need. Skipped, and said
# so, where one of these is not to be had.
set -euo pipefail
version=$1 source=$2 work=$3 tool=$4

skip() { echo "skipped: $*"; exit 77; }

candidates() {
  local folder
  for folder in $(tr : ' ' <<<"${QVGEN_PYTHONS-}") "${PYENV_ROOT:-$HOME/.pyenv}/versions/$version".*/bin "/opt/python/cp${version/./}-cp${version/./}/bin"; do
    echo "$folder/python$version"
  done
  type -ap "python$version" || true
}

is_usable() { "$1" -c "import ctypes, ensurepip, sys, venv; sys.exit('%d.%d' % sys.version_info[:2] != '$version')" 2>/dev/null; }

find_interpreter() {
  local each
  while read -r each; do
    if is_usable "$each"; then
      echo "$each"
      return
    fi
  done < <(candidates)
}

declare -A debian=([3.11]=bookworm [3.13]=trixie [3.14]=forky)
python=$(find_interpreter)
for packer in python3 /usr/bin/python3; do
  ! "$packer" -c 'import pip' 2>/dev/null || break
done
rm -rf "$work" && mkdir -p "$work/wheels"
try=("$source/tests/python/try_wheel.sh" "$version" "$source/tests/python" "$work")
if [[ -n $python ]]; then
  "$python" -m venv "$work/packer"  # only a Python itself knows what packages ask of its version
  download=("$work/packer/bin/pip" download)
else
  suite=${debian[$version]-}
  [[ -n $suite ]] || skip "no CPython $version on the path, of pyenv, or in a folder of QVGEN_PYTHONS"
  root=$work-$suite
  "$source/tests/package/debian_root.sh" make "$suite" "$root" "python$version-venv" g++ libeigen3-dev
  python=/usr/bin/python$version
  download=("$packer" -m pip download --python-version "$version")
  IFS=: read -ra folders <<<"${QVGEN_LIBRARIES:-$source}"
  cache=${QVGEN_CACHE:-$work-cache}-$suite  # of another compiler
  mkdir -p "$cache"
  try=("$source/tests/package/debian_root.sh" in "$root" "$source" "$work" "$cache" "${folders[@]}" --
       env "QVGEN_CACHE=$cache" "QVGEN_LIBRARIES=${QVGEN_LIBRARIES-}" PYTHONDONTWRITEBYTECODE=1 "${try[@]}")
fi

QVGEN_TOOL=$tool "$packer" -c "import sys; sys.path.insert(0, '$source/runtime/python/build')
import qvgen_wheel; qvgen_wheel.build_wheel('$work/wheels')"
download() { "${download[@]}" --quiet --disable-pip-version-check --dest "$work/wheels" --only-binary :all: "$@"; }
download numpy pytest || skip "no NumPy and pytest of PyPI for CPython $version"
for extra in scipy matplotlib casadi; do
  download "$extra" 2>/dev/null || echo "not tested with $extra, which PyPI does not give for CPython $version"
done
exec env -u PYTHONPATH "${try[@]}" "$python"
