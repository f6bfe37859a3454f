#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# inverse_instructions.sh PROGRAM: instructions of a call of inverse kinematics, averaged over random poses of the irb6640, as
# valgrind counts them. PROGRAM is qvgen_inverse_instructions, compiled for no more than AVX2, beyond which valgrind knows none.
set -euo pipefail

poses=10000
counted='qvgen::robots::irb6640::inverse_kinematics(qvgen::Pose<double> const&, qvgen::robots::*'
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

printf '%-32s%14s%20s\n' 'irb6640' 'instructions' 'solutions a pose'
count() {
  local name=$1 solutions total
  solutions=$(valgrind --tool=callgrind --toggle-collect="$counted" --callgrind-out-file="$folder/out" \
    --log-file="$folder/log" "$2" "$3" "$poses")
  total=$(sed -n 's/.*Collected : //p' "$folder/log")
  printf '%-32s%14d%20s\n' "$name" $((total / poses)) "$solutions"
}
count 'all solutions, four lanes' "$1" lanes
count 'all solutions, one by one' "$1" scalar
count 'out of reach, four lanes' "$1" unreachable
count 'out of reach, one by one' "$1" scalar_unreachable
