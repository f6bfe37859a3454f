#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh FOLDER: the folder's tests, by a Python that has what they need.
set -euo pipefail
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import numpy, pytest' 2>/dev/null; then
    exec "$python" -m pytest -q -p no:cacheprovider "$1"
  fi
done
echo "skipped: no Python with numpy and pytest (python3-numpy python3-pytest)"
exit 77
