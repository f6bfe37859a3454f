#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# neon.sh SOURCE TOOL FOLDER: batch forms cross-compiled for AArch64 and run by qemu's user mode, where both are installed
# (Debian's g++-aarch64-linux-gnu and qemu-user). What is not batches is compiled without optimisation, sources together, in a third of the time.
set -euo pipefail

source=$1 tool=$2 folder=$3
for program in aarch64-linux-gnu-g++ aarch64-linux-gnu-objdump qemu-aarch64; do
  command -v "$program" >/dev/null || { echo "skipped: no $program here"; exit 77; }
done

build() {
  cmake -S "$source/tests/batch/neon" -B "$folder" -DQVGEN_FOLDER="$source" -DQVGEN_TOOL="$tool" \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ &&
    cmake --build "$folder" --parallel 2
}
rm -rf "$folder"
build >"$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }

# The lanes are NEON's, two doubles in a register.
code=$(find "$folder" -path '*batch_NEON*' -name '*.o' -exec aarch64-linux-gnu-objdump -d {} +)
for instruction in fmul fadd fmla; do
  grep -qE "\b$instruction\b.*\.2d" <<<"$code" || { echo "no $instruction on two doubles"; exit 1; }
done
qemu-aarch64 -L /usr/aarch64-linux-gnu "$folder/neon"
