#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tables.sh TOOL GOLDEN SCRATCH: `compare` writes the committed tables of what no search has a part in, and all levels
# byte for byte twice, whatever the address-space layout. To accept a change on purpose: tables.sh TOOL GOLDEN GOLDEN
set -euo pipefail
tool=$1 golden=$2 scratch=$3
mkdir -p "$scratch"
write() {  # FOLDER LEVELS [environment...]: all tables
  local folder=$1 levels=$2
  shift 2
  "$@" "$tool" compare ns_arm nn puma560 jaco2 --level "$levels" --format csv > "$folder/forward.csv"
  "$@" "$tool" compare ns_arm nn puma560 jaco2 --what jacobian --level "$levels" --format csv > "$folder/jacobian.csv"
  "$@" "$tool" compare ns_arm rx90 --what dynamics --level "$levels" --format csv > "$folder/dynamics.csv"
}
write "$scratch" textbook,specialised
[[ $golden != "$scratch" ]] || exit 0

fixed=()
if command -v setarch >/dev/null && setarch "$(uname -m)" -R true 2>/dev/null; then fixed=(setarch "$(uname -m)" -R); fi
mkdir -p "$scratch/once" "$scratch/again"
write "$scratch/once" textbook,specialised,optimised
write "$scratch/again" textbook,specialised,optimised env PADDING="$(head -c 5000 /dev/zero | tr '\0' x)" "${fixed[@]}"
for table in forward jacobian dynamics; do
  cmp "$scratch/once/$table.csv" "$scratch/again/$table.csv" || { echo "two runs differ"; exit 1; }
  diff "$golden/$table.csv" "$scratch/$table.csv" || { echo "not the committed table: see the head of $0"; exit 1; }
done
