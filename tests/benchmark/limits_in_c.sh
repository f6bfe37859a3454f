#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# limits_in_c.sh QVGEN POSES [ROBOT...]: instructions a call of inverse kinematics in C at -O2, as callgrind counts them: of all
# solutions, and the other calls as ratios to these. Seeds are off by up to 0.1 rad a joint, or as a column says. Limits are 170
# degrees to either side, wide ones a turn; of arms with motors the description's, and twice as wide. `turns`: all solutions, and
# every representative; the last column has instructions a row of these within wide limits. With QVGEN_HASH=1 hashes of all rows
# are printed instead.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
qvgen=$1
poses=$2
shift 2
robots=("$@")
(($# > 0)) || robots=(puma560 stanford rx90 irb6640 nr ns ur5 cc cn bevel_arm nested_wrist)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sources=()
for robot in "${robots[@]}"; do
  source=$here/../motors/$robot.toml
  [[ -f $source ]] || source=$here/../../generator/robots/$robot.toml
  sources+=("$source")
done
"$qvgen" generate "${sources[@]}" --language c --only kinematics,inverse --output "$folder/made" --quiet >&2
made=$folder/made/c
columns='seed limits wide near_3mrad near_0.1 near_1 near_3 near_limits turns'
[[ -n ${QVGEN_HASH-} ]] || {
  printf '%-14s %8s' 'ratios' all
  printf ' %11s' $columns 'wide, a row'
  printf '\n'
}
for robot in "${robots[@]}"; do
  "${CC:-cc}" -std=c11 -O2 -Wall -Wextra -I "$made" -DQVGEN_ROBOT="$robot" -DQVGEN_HEADER="\"qvgen_${robot}_inverse.h\"" \
    "$here/limits_in_c.c" "$made/qvgen_$robot.c" "$made/qvgen_${robot}_inverse.c" -lm -o "$folder/program"
  if [[ -n ${QVGEN_HASH-} ]]; then
    "$folder/program" "$poses" hash
    continue
  fi
  rm -f "$folder"/out*
  valgrind --tool=callgrind --callgrind-out-file="$folder/out" "$folder/program" "$poses" 2> "$folder/log"
  awk -v robot="$robot" -v columns="$columns" '
    /^desc: Trigger: Client Request: / { split(substr($0, 32), call, " "); name = call[1] }
    /^totals: / { if (name != "") { sum[name] = $2; poses = call[2]; rows[name] = call[3] } }
    END {
      count = split(columns, names, " ")
      printf "%-14s %8d", robot, sum["all"] / poses
      for (i = 1; i <= count; ++i) printf " %11.2f", sum[names[i]] / sum["all"]
      printf " %11.0f\n", (sum["wide_turns"] - sum["all"]) / rows["wide_turns"]
    }' $(ls -v "$folder"/out.*)
done
