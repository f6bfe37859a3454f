#!/usr/bin/env bash
# All views of some robots in one LaTeX document: it compiles, and no line leaves the page by more than a letter or two.
#   latex.sh TOOL FOLDER
set -euo pipefail
command -v pdflatex > /dev/null || { echo "skipped: there is no pdflatex (apt-get install texlive-latex-base)"; exit 77; }
tool=$1
mkdir -p "$2" && cd "$2"
{
  printf '\\documentclass{article}\\usepackage[a4paper,margin=20mm]{geometry}\\usepackage{amsmath}\\begin{document}\n'
  for robot in iiwa14 poe_6r puma560 ur5 scara; do
    for view in "" --inverse --singularities --jacobian --transform --class; do
      printf '\\section*{%s %s}\n' "${robot//_/ }" "$view"
      # shellcheck disable=SC2086
      "$tool" show $robot $view --latex
    done
  done
  printf '\\section*{workspace}\n'
  "$tool" show puma560 --workspace --latex
  printf '\\section*{dynamics}\n'
  "$tool" show nn --dynamics --joints 3 --masses middle --latex
  printf '\\end{document}\n'
} > views.tex
pdflatex -interaction=batchmode -halt-on-error views.tex > pdflatex.out || { grep -A5 '^!' views.log; exit 1; }
widest=$(grep -o 'Overfull .hbox ([0-9]*' views.log | grep -o '[0-9]*$' | sort -n | tail -1 || true)
if [ "${widest:-0}" -gt 20 ]; then
  grep -A3 'Overfull .hbox' views.log
  exit 1
fi
