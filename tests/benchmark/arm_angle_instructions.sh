#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# arm_angle_instructions.sh PROGRAM [POSES]: instructions a pose of the iiwa14 by its arm angle, as valgrind counts them.
# PROGRAM is qvgen_arm_angle_instructions, compiled for no more than AVX2, beyond which valgrind knows none.
set -euo pipefail

poses=${2:-200}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

printf '%-32s%14s%20s\n' 'iiwa14' 'instructions' 'results a pose'
count() {
  local results total
  results=$(valgrind --tool=callgrind --collect-atstart=no --callgrind-out-file="$folder/out" --log-file="$folder/log" \
    "$2" "$3" "$poses")
  total=$(sed -n 's/.*Collected : //p' "$folder/log")
  printf '%-32s%14d%20s\n' "$1" $((total / poses)) "$results"
}
count 'theta3 given' "$1" given
count 'at an arm angle' "$1" arm_angle
count 'intervals within limits' "$1" intervals
count 'solutions within limits' "$1" within
count 'the same next to a seed' "$1" within_near
