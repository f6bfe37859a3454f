#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# same_output.sh PROGRAM README: the README's indented block below "PROGRAM prints" is what the program prints.
set -eu
program=$1 readme=$2
shown=$(awk -v line="\`$(basename "$program")\` prints" 'index($0, line) {on = 1; next} on && /^[^ ]/ {exit} on && /^    / {print substr($0, 5)}' "$readme")
if [ -z "$shown" ]; then echo "$readme shows no output of $program"; exit 1; fi
diff <(printf '%s\n' "$shown") <("$program")
