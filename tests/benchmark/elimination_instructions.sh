#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# elimination_instructions.sh PROGRAM [POSES]: a table, instructions of all solutions of a pose of arms without structure, as
# valgrind counts them: median and mean of random poses with AVX2 and with SSE2, and median, mean and worst of poses at which
# the arm is singular or nearly so. PROGRAM is qvgen_elimination, the library as it is shipped.
set -euo pipefail

program=$1 poses=${2:-100}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

# count ARM REGISTERS SET: median, mean and worst.
count() {
  rm -f "$folder"/out*
  valgrind --tool=callgrind --toggle-collect='qvgen::inverse::elimination::solve(*' --callgrind-out-file="$folder/out" \
    --log-file="$folder/log" "$program" count "$1" "$2" "$3" "$poses" >/dev/null
  for file in "$folder"/out.*; do sed -n 's/^totals: //p' "$file"; done | sort -n | awk '
    { value[NR] = $1; sum += $1 }
    END { print value[int((NR + 1) / 2)], int(sum / NR), value[NR] }'
}

printf '%-24s |%20s |%20s |%30s\n' 'instructions a pose' 'random, AVX2' 'SSE2' 'singular, AVX2'
printf '%-24s |%10s%10s |%10s%10s |%10s%10s%10s\n' '' median mean median mean median mean worst
for arm in $("$program" names); do
  read -r median mean _ <<<"$(count "$arm" avx2 random)"
  read -r median_two mean_two _ <<<"$(count "$arm" sse2 random)"
  read -r -a singular <<<"$(count "$arm" avx2 singular)"
  printf '%-24s |%10d%10d |%10d%10d |%10d%10d%10d\n' "$arm" "$median" "$mean" "$median_two" "$mean_two" "${singular[@]}"
done
