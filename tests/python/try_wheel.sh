#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# try_wheel.sh VERSION TESTS WORK PYTHON: installs all of WORK/wheels into a fresh environment, and runs the tests.
set -euo pipefail
version=$1 tests=$2 work=$3 python=$4
"$python" -m venv "$work/venv"
"$work/venv/bin/pip" --quiet --disable-pip-version-check install --no-index "$work"/wheels/*.whl
cd "$work"
"$work/venv/bin/python" -c "import pathlib, qvgen, sys; assert '%d.%d' % sys.version_info[:2] == '$version'
assert pathlib.Path(qvgen.__file__).is_relative_to('$work'), qvgen.__file__"
exec "$work/venv/bin/python" -m pytest -q -rs -p no:cacheprovider "$tests"
