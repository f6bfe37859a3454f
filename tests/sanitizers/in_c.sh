#!/bin/sh
# SPDX-License-Identifier: MIT
# in_c.sh TOOL COMPILER ROBOT FOLDER: every function of a robot in C, under both sanitizers.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tool=$1 compiler=$2 robot=$3 folder=$4
"$tool" generate "$robot" --language c --output "$folder" --quiet
program=$folder/call_$robot
set -- "$folder/c/qvgen_$robot"
for part in inverse metrics velocity; do
  if [ -f "$1_$part.c" ]; then set -- "$@" "$1_$part"; fi
done
python3 "$here/calls_in_c.py" $(printf '%s.h ' "$@") > "$program.c"
"$compiler" -std=c99 -pedantic -Wall -Wextra -Werror -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined \
  -fno-sanitize-recover=all "$program.c" $(printf '%s.c ' "$@") -lm -o "$program"
"$program"
