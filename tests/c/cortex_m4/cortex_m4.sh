#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Generated C on an ARM Cortex-M4F.
#   cortex_m4.sh run CC WORK FOLDER ROBOT [PART...]   FOLDER/qvgen_ROBOT*.c under qemu gives what it gives here, by CC;
#                                                     parts beyond kinematics and jacobian: dynamics, inverse
#   cortex_m4.sh sizes TOOL ROBOT...                  a table: bytes of code and of stack of each function; of inverse
#                                                     kinematics those of all functions that it calls, too
# Exit code 77: the cross compiler, picolibc or qemu is missing.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
machine=(-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16)
warnings=(-std=c99 -pedantic -Wall -Wextra -Werror)
memory=(-Wl,--defsym=__flash=0 -Wl,--defsym=__flash_size=0x400000 -Wl,--defsym=__ram=0x20000000
        -Wl,--defsym=__ram_size=0x400000 -Wl,--defsym=__stack_size=0x4000)

need() {
  command -v "$1" >/dev/null || { echo "skipped: there is no $1 ($2)"; exit 77; }
}
need arm-none-eabi-gcc gcc-arm-none-eabi
cross=(arm-none-eabi-gcc --specs=picolibc.specs "${machine[@]}" -O2)
"${cross[@]}" -fsyntax-only -x c - <<<'#include <math.h>' 2>/dev/null ||
  { echo "skipped: there is no picolibc (picolibc-arm-none-eabi)"; exit 77; }

run() {
  local cc=$1 work=$2 folder=$3 robot=$4 parts=" ${*:5} "
  need qemu-system-arm qemu-system-arm
  mkdir -p "$work"
  local source=("$here/cases.c" "$folder/qvgen_$robot.c" "-DROBOT=$robot" -include "$folder/qvgen_$robot.h" "-I$folder")
  [[ $parts != *" dynamics "* ]] || source+=(-DHAS_DYNAMICS)
  [[ $parts != *" inverse "* ]] ||
    source+=("$folder/qvgen_${robot}_inverse.c" -DHAS_INVERSE -include "$folder/qvgen_${robot}_inverse.h")
  "$cc" "${warnings[@]}" -O1 -ffp-contract=off -DWRITE "${source[@]}" -lm -o "$work/write"
  "$work/write" >"$work/expected.h"
  "${cross[@]}" "${warnings[@]}" --oslib=semihost --crt0=hosted "${memory[@]}" "${source[@]}" "-I$work" -lm -o "$work/cases.elf"
  timeout 120 qemu-system-arm -M mps2-an386 -semihosting-config enable=on,target=native -nographic -monitor none -serial none \
    -kernel "$work/cases.elf" </dev/null 2>&1 | tee "$work/output"
  grep -q 'as expected$' "$work/output"
}

# The stack of a public function and the deepest of all that it calls, of GCC's call graph; nothing there calls itself.
deepest() {
  awk -v robot="$1" '
    /^node:/ { split($0, part, "\""); bytes[part[2]] = 0
               if (match(part[4], /[0-9]+ bytes/)) bytes[part[2]] = substr(part[4], RSTART, RLENGTH) + 0 }
    /^edge:/ { split($0, part, "\""); calls[part[2]] = calls[part[2]] SUBSEP part[4] }
    function depth(name,    list, count, i, most, each) {
      if (name in known) return known[name]
      count = split(calls[name], list, SUBSEP); most = 0
      for (i = 2; i <= count; ++i) { each = depth(list[i]); if (each > most) most = each }
      return known[name] = bytes[name] + most
    }
    END { for (name in bytes) if (index(name, robot "_inverse_kinematics") == 1)
            print substr(name, length(robot) + 2), depth(name) }' "$2" | sort
}

sizes() {
  local tool=$1 work
  shift
  work=$(mktemp -d)
  trap "rm -rf '$work'" EXIT
  printf '%-10s %-40s %6s %6s\n' robot function code stack
  for robot in "$@"; do
    "$tool" generate "$robot" --language c --output "$work" --quiet 2>/dev/null
    (cd "$work" && "${cross[@]}" "${warnings[@]}" -fstack-usage -c "c/qvgen_$robot.c" -o "$robot.o")
    join <(arm-none-eabi-nm --defined-only -td -S "$work/$robot.o" | awk 'tolower($3) == "t" { print $4, $2 + 0 }' | sort) \
         <(awk -F'[:\t]' '{ print $4, $5 }' "$work/$robot.su" | sort) |
      awk -v robot="$robot" '{ sub("^" robot "_", "", $1); printf "%-10s %-40s %6d %6d\n", robot, $1, $2, $3 }'
    [[ -f $work/c/qvgen_${robot}_inverse.c ]] || continue
    (cd "$work" && "${cross[@]}" "${warnings[@]}" -fcallgraph-info=su -c "c/qvgen_${robot}_inverse.c" -o inverse.o)
    printf '%-10s %-40s %6d\n' "$robot" 'all of inverse kinematics' "$(arm-none-eabi-size "$work/inverse.o" | awk 'END { print $1 }')"
    deepest "$robot" "$work/inverse.ci" | awk -v robot="$robot" '{ printf "%-10s %-40s %6s %6d\n", robot, $1, "", $2 }'
  done
}

"$@"
