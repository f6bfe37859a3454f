#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# freshness.sh TOOL GENERATED SCRATCH: generated/ must be what the tool writes, whatever the address-space layout.
set -u
tool=$1 generated=$2 scratch=$3
rm -rf "$scratch"

# The run that wrote generated/ had another layout, since the system chooses one at random, and a larger environment, which is
# this one's padding, moves the stack where it does not.
PADDING=$(head -c 5000 /dev/zero | tr '\0' x) "$tool" generate --output "$scratch" >/dev/null || exit 1

# Only one file in generated/ is written by hand: its CMakeLists.txt.
if ! diff -r --exclude=CMakeLists.txt --exclude=.qvgen "$generated" "$scratch"; then
  echo "generated/ is not what the generator writes. To update it: ./qvgen generate. If two updates differ, something depends on"
  echo "the order of memory or of GiNaC's terms."
  exit 1
fi
robots=$(find "$scratch/source" -mindepth 1 -maxdepth 1 | wc -l)
((robots > 20)) || { echo "hardly any robots in $scratch"; exit 1; }
echo "generated/ is fresh: $(find "$scratch" -type f | wc -l) files of $robots robots"
