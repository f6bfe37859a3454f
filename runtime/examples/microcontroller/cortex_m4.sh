#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# cortex_m4.sh FOLDER: firmware.c with the generated C in FOLDER for a Cortex-M4F, and run in an emulator. Needs
# gcc-arm-none-eabi, picolibc-arm-none-eabi and qemu-system-arm; exit code 77: one of them is missing.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for program in arm-none-eabi-gcc qemu-system-arm; do
  command -v "$program" >/dev/null || { echo "skipped: there is no $program"; exit 77; }
done
compiler=(arm-none-eabi-gcc --specs=picolibc.specs -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -O2 -std=c99)
memory=(-Wl,--defsym=__flash=0 -Wl,--defsym=__flash_size=0x400000 -Wl,--defsym=__ram=0x20000000
        -Wl,--defsym=__ram_size=0x400000 -Wl,--defsym=__stack_size=0x4000)
"${compiler[@]}" -fsyntax-only -x c - <<<'#include <math.h>' 2>/dev/null || { echo "skipped: there is no picolibc"; exit 77; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A board of your own has its linker script and start-up code in place of picolibc's.
"${compiler[@]}" --oslib=semihost --crt0=hosted "${memory[@]}" "-I$1" "$here/firmware.c" "$1"/qvgen_*.c -lm -o "$work/firmware.elf"
arm-none-eabi-size "$work/firmware.elf"
timeout 60 qemu-system-arm -M mps2-an386 -semihosting-config enable=on,target=native -nographic -monitor none -serial none \
  -kernel "$work/firmware.elf" </dev/null 2>&1 | tee "$work/output"
grep -q '^50 steps, the tool is 0.100 m further' "$work/output"
