#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# own_arm.sh TOOL SOURCE COMPILER DESCRIPTION OUTPUT: the README's own arm, as its reader would go about it.
set -eu
tool=$1 source=$2 compiler=$3 description=$4 output=$5
rm -rf "$output"
"$tool" check "$description"
"$tool" generate "$description" --output "$output"
"$tool" show "$description" --latex
"$tool" map "$description" --resolution 0.2 -o "$output/map.npz" -o "$output/map.svg"
# All files as one, which read the headers once.
printf '#include "%s"\n' "$output"/source/my_arm/*.cpp >"$output/whole.cpp"
"$compiler" -std=c++17 -Wall -Wextra -Wconversion -Wshadow -Werror -fsyntax-only \
  -I "$output/include" -I "$source/runtime/include" -isystem /usr/include/eigen3 "$output/whole.cpp"
