#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# instructions.sh LOOPS_BENCHMARK: instructions a call of functions of closed loops, counted by callgrind.
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
valgrind --tool=callgrind --callgrind-out-file="$folder/out" "$program" --instructions >&2
columns='assemble follow inverse rates dynamics'
{
  printf '%-22s' 'instructions'
  printf ' %9s' $columns
  printf '\n'
  for file in $(ls -v "$folder"/out.*); do
    awk '/^desc: Trigger: Client Request: / { name = substr($0, 32) } /^totals: / { if (name != "") print name, $2 }' "$file"
  done | awk -v columns="$columns" '
    function row(  i) {
      if (mechanism == "") return
      printf "%-22s", mechanism
      for (i = 1; i <= count; ++i) { printf " %9s", found[names[i]]; found[names[i]] = "" }
      printf "\n"
    }
    BEGIN { count = split(columns, names, " ") }
    $1 != mechanism { row(); mechanism = $1 }
    { found[$2] = int($4 / $3 + 0.5) }
    END { row() }'
} | sed 's/ *$//'
