#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# instructions.sh PROGRAM [TEXT]: instructions a call of every variant whose name contains the text, counted by
# callgrind. The program must be compiled for x86-64-v3 at most: valgrind knows no wider vectors.
set -euo pipefail
program=$1 text=${2:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
valgrind --tool=callgrind --callgrind-out-file="$folder/out" "$program" --instructions "$text" >&2
for file in $(ls -v "$folder"/out.*); do
  awk '/^desc: Trigger: Client Request: / { name = substr($0, 32) } /^totals: / { if (name != "") printf "%-50s %8d\n", name, $2 / 256 }' "$file"
done
