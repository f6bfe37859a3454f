#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# singular_instructions.sh PROGRAM [POSES]: a table, instructions of a call of inverse kinematics at singular poses and near
# them, as valgrind counts them: median, 99.9 %, worst and mean, and worst and mean as multiples of a random pose's median;
# then the same of the one solution next to a seed. Fails if a pose takes more than the robot's header says.
# PROGRAM is qvgen_singular_instructions, compiled for no more than AVX2, beyond which valgrind knows none.
set -euo pipefail

poses=${2:-200}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

headers=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/generated/include/qvgen/robots

# check_bound ROBOT WORST REGULAR: whether the worst pose adds no more to a regular one than the header says.
check_bound() {
  local bound
  bound=$(sed -n 's/^\/\/\/ \([0-9,]*\) instructions (x86-64, AVX2).*/\1/p' "$headers/$1/inverse.h" | head -n 1)
  (($2 - $3 <= ${bound//,/})) || { echo "$1: $2 instructions, but its header says at most $bound" >&2; exit 1; }
}

# count_sets ROBOT FUNCTION PROGRAM: a line for each set.
count_sets() {
  local robot=$1 function=$2 regular=0 set row
  local label=$robot${function#inverse_kinematics}
  for set in random home 'theta5 = 0' 'theta5 = 10^-u' 'theta3 = 0' 'theta3 = 10^-u' '45 degrees'; do
    rm -f "$folder"/out*
    valgrind --tool=callgrind --toggle-collect="qvgen::robots::${robot}::${function}(*" \
      --callgrind-out-file="$folder/out" --log-file="$folder/log" "$3" "$robot" "$function" "$set" "$poses" >/dev/null
    row=$(for file in "$folder"/out.*; do sed -n 's/^totals: //p' "$file"; done | sort -n | awk -v regular="$regular" '
      { value[NR] = $1; sum += $1 }
      END {
        median = value[int((NR + 1) / 2)]; mean = sum / NR
        if (regular == 0) regular = median
        printf "%10d%10d%10d%10d%12.1f%12.1f\n", median, value[int(NR * 0.999 + 0.999)], value[NR], mean,
               value[NR] / regular, mean / regular
      }')
    [[ $regular != 0 ]] || regular=$(awk '{ print $1 }' <<<"$row")
    printf '%-32s%s\n' "${label/_/ }, $set" "$row"
    [[ $function != inverse_kinematics ]] || check_bound "$robot" "$(awk '{ print $3 }' <<<"$row")" "$regular"
  done
}

printf '%-32s%10s%10s%10s%10s%12s%12s\n' 'singular poses' median '99.9 %' worst mean 'worst/reg.' 'mean/reg.'
for function in inverse_kinematics inverse_kinematics_near; do
  for robot in ur5 irb6640 puma560; do count_sets "$robot" "$function" "$1"; done
done
