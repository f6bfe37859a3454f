#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# matlab_test.sh WORK TOOL ROBOT...: the .m files of robots are MATLAB's language, too, by the parser of MISS_HIT (pip install miss_hit).
#
# It refuses comments and operators that only Octave has, which is tried first, so that silence says something.
set -euo pipefail
work=$1 tool=$2
command -v mh_lint >/dev/null || { echo "skipped: there is no mh_lint (pip install miss_hit)"; exit 77; }
rm -rf "$work" && mkdir -p "$work/octave_alone"
for line in '# a comment' 'y = !x;' 'x++;'; do
  printf 'function y = f(x)\n  y = 0;\n  %s\nend\n' "$line" >"$work/octave_alone/f.m"
  ! mh_lint "$work/octave_alone" >/dev/null 2>&1 || { echo "mh_lint takes $line"; exit 1; }
done
for robot in "${@:3}"; do
  "$tool" generate "$robot" --language octave --output "$work/robots" --quiet
done
mh_lint "$work/robots"
