#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# limits_instructions.sh PROGRAM: instructions of a call of inverse kinematics within joint limits, averaged over random poses,
# as valgrind counts them, beside all solutions without limits. PROGRAM is qvgen_limits_instructions, compiled for no more than
# AVX2, beyond which valgrind knows none.
set -euo pipefail

poses=2000
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

printf '%-14s%-14s%14s%14s\n' arm call instructions 'rows a pose'
for arm in irb6640 puma560 ur5 bevel_arm nested_wrist; do
  for call in all seed seed_limits seed_wide nearest near near_limits limits wide turns visits; do
    rows=$(valgrind --tool=callgrind --toggle-collect='*run<*' --callgrind-out-file="$folder/out" \
      --log-file="$folder/log" "$1" "$arm" "$call" "$poses")
    total=$(sed -n 's/.*Collected : //p' "$folder/log")
    printf '%-14s%-14s%14d%14s\n' "$arm" "$call" $((total / poses)) "$rows"
  done
done
