#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tables.sh TOOL GOLDEN SCRATCH: `compare` writes the committed tables, byte for byte, twice, whatever the address-space
# layout. To accept a change on purpose: tables.sh TOOL GOLDEN GOLDEN
set -euo pipefail
tool=$1 golden=$2 scratch=$3
robots="ns nn puma560 jaco2"
mkdir -p "$scratch"
"$tool" compare $robots --format csv > "$scratch/forward.csv"
[[ $golden != "$scratch" ]] || exit 0

fixed=()
if command -v setarch >/dev/null && setarch "$(uname -m)" -R true 2>/dev/null; then fixed=(setarch "$(uname -m)" -R); fi
PADDING=$(head -c 5000 /dev/zero | tr '\0' x) "${fixed[@]}" "$tool" compare $robots --format csv > "$scratch/again.csv"
cmp "$scratch/forward.csv" "$scratch/again.csv" || { echo "two runs differ"; exit 1; }
diff "$golden/forward.csv" "$scratch/forward.csv" || { echo "not the committed table: see the head of $0"; exit 1; }
