#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# freshness.sh TOOL GENERATED SCRATCH: generated/ must be what the tool writes, whatever the address-space layout.
set -u
tool=$1 generated=$2 scratch=$3
rm -rf "$scratch"

# The second run has a fixed layout where the system allows it, and another environment, so another stack.
"$tool" generate --output "$scratch/first" >/dev/null || exit 1
fixed=()
if command -v setarch >/dev/null && setarch "$(uname -m)" -R true 2>/dev/null; then fixed=(setarch "$(uname -m)" -R); fi
PADDING=$(head -c 5000 /dev/zero | tr '\0' x) "${fixed[@]}" "$tool" generate --output "$scratch/second" >/dev/null || exit 1

if ! diff -r "$scratch/first" "$scratch/second"; then
  echo "Two runs of the generator differ: something depends on the order of memory or of GiNaC's terms."
  exit 1
fi
# What is written by hand in generated/ is its CMakeLists.txt alone.
if ! diff -r --exclude=CMakeLists.txt --exclude=.qvgen "$generated" "$scratch/first"; then
  echo "generated/ is not what the generator writes. To update it: ./qvgen generate"
  exit 1
fi
echo "generated/ is fresh: $(find "$scratch/first" -type f | wc -l) files, two runs identical"
