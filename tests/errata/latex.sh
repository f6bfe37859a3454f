#!/usr/bin/env bash
# The judged equations compile, and no line leaves its column by more than a letter or two.
#   latex.sh FILE.tex FOLDER
set -euo pipefail
command -v pdflatex > /dev/null || { echo "skipped: there is no pdflatex (apt-get install texlive-latex-base)"; exit 77; }
mkdir -p "$2" && cd "$2"
for _ in 1 2; do
  pdflatex -interaction=batchmode -halt-on-error "$1" > pdflatex.out || { grep -A5 '^!' ./*.log; exit 1; }
done
widest=$(grep -o 'Overfull .hbox ([0-9]*' ./*.log | grep -o '[0-9]*$' | sort -n | tail -1 || true)
if [ "${widest:-0}" -gt 20 ]; then
  grep -A3 'Overfull .hbox' ./*.log
  exit 1
fi
