#!/bin/sh
# SPDX-License-Identifier: MIT
# in_c.sh TOOL COMPILER ROBOT FOLDER: every function of a robot in C, under both sanitizers. ROBOT is the name of a committed
# one or the file of any. All its headers are included in one program.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tool=$1 compiler=$2 robot=$3 folder=$4
rm -rf "$folder/c"
"$tool" generate "$robot" --language c --output "$folder" --quiet
python3 "$here/calls_in_c.py" "$folder"/c/*.h > "$folder/calls.c"
"$compiler" -std=c99 -pedantic -Wall -Wextra -Werror -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined \
  -fno-sanitize-recover=all -I "$folder/c" "$folder"/calls.c "$folder"/c/*.c -lm -o "$folder/calls"
"$folder/calls"
