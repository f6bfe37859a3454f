#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# measured.sh TOOL WRITE_POSES WRITE_LOG README WORK PYTHON_FOLDER: the README's commands on data that are made here. What it
# shows of their output is what they print, but for last digits.
set -euo pipefail
tool=$1 write_poses=$2 write_log=$3 readme=$4 work=$5 python=$6
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work" && mkdir -p "$work" && cd "$work"
printf '#!/bin/sh\nexec "%s" "$@"\n' "$tool" > qvgen && chmod +x qvgen
"$write_poses" ur5 60 > poses.csv
"$write_log" 1 30 0 > log.csv
"$write_log" 2 10 0 > other.csv
"$write_log" 3 30 2 > loaded.csv
QVGEN_TOOL=$tool PYTHONPATH=$python python3 "$here/same_session.py" "$readme" "## From measurements to this very arm"
for file in my_ur5.toml my_ur5.csv my_ur5.html ur5_measured.toml measured.html; do
  [[ -s $file ]] || { echo "no $file"; exit 1; }
done
./qvgen check my_ur5.toml ur5_measured.toml
