#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# freshness.sh TOOL GENERATED SCRATCH: generated/ must be what the tool writes, whatever the address-space layout.
set -u
tool=$1 generated=$2 scratch=$3
rm -rf "$scratch"

# All robots in a fixed layout where the system allows it, compared with what another run has written; every twelfth once more
# in another layout and another environment, so another stack.
fixed=()
if command -v setarch >/dev/null && setarch "$(uname -m)" -R true 2>/dev/null; then fixed=(setarch "$(uname -m)" -R); fi
"${fixed[@]}" "$tool" generate --output "$scratch/first" >/dev/null || exit 1
mapfile -t again < <(cd "$scratch/first/source" && ls | awk 'NR % 12 == 1')
((${#again[@]} > 2)) || { echo "hardly any robots in $scratch/first"; exit 1; }
PADDING=$(head -c 5000 /dev/zero | tr '\0' x) "$tool" generate "${again[@]}" --output "$scratch/second" >/dev/null || exit 1

for robot in "${again[@]}"; do
  for folder in source/$robot include/qvgen/robots/$robot; do
    diff -r "$scratch/first/$folder" "$scratch/second/$folder" && continue
    echo "Two runs of the generator differ: something depends on the order of memory or of GiNaC's terms."
    exit 1
  done
done
# Only one file in generated/ is written by hand: its CMakeLists.txt.
if ! diff -r --exclude=CMakeLists.txt --exclude=.qvgen "$generated" "$scratch/first"; then
  echo "generated/ is not what the generator writes. To update it: ./qvgen generate"
  exit 1
fi
echo "generated/ is fresh: $(find "$scratch/first" -type f | wc -l) files, two runs of ${#again[@]} robots identical"
