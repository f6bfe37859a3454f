#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tables.sh TOOL GOLDEN SCRATCH: `compare` writes the committed tables, byte for byte, twice, whatever the address-space
# layout. To accept a change on purpose: tables.sh TOOL GOLDEN GOLDEN
set -euo pipefail
tool=$1 golden=$2 scratch=$3
robots="ns_arm nn puma560 jaco2"
mkdir -p "$scratch"
write() {  # FOLDER: all tables
  "${@:2}" "$tool" compare $robots --format csv > "$1/forward.csv"
  "${@:2}" "$tool" compare $robots --what jacobian --format csv > "$1/jacobian.csv"
  "${@:2}" "$tool" compare ns_arm rx90 --what dynamics --format csv > "$1/dynamics.csv"
}
write "$scratch"
[[ $golden != "$scratch" ]] || exit 0

fixed=()
if command -v setarch >/dev/null && setarch "$(uname -m)" -R true 2>/dev/null; then fixed=(setarch "$(uname -m)" -R); fi
mkdir -p "$scratch/again"
write "$scratch/again" env PADDING="$(head -c 5000 /dev/zero | tr '\0' x)" "${fixed[@]}"
for table in forward jacobian dynamics; do
  cmp "$scratch/$table.csv" "$scratch/again/$table.csv" || { echo "two runs differ"; exit 1; }
  diff "$golden/$table.csv" "$scratch/$table.csv" || { echo "not the committed table: see the head of $0"; exit 1; }
done
