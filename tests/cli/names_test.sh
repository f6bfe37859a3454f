#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# names_test.sh TOOL CXX RUNTIME EIGEN SCRATCH: names that derivations, macros and compilers know too. Either the
# description is refused, or everything is derived, certified and compiles, in the compiler's own dialect too.
set -euo pipefail
tool=$1 cxx=$2 runtime=$3 eigen=$4 scratch=$5
rm -rf "$scratch"
mkdir -p "$scratch"

fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }

# arm NAME VARIABLES(6) SYMBOLS(4): an arm with a spherical wrist.
arm() {
  local -n v=$2 s=$3
  printf 'name = "%s"\ntitle = "names"\n' "$1"
  printf '[[joint]]\ntype = "revolute"\naxis = "+z"\nvariable = "%s"\nlink = [0, 0, "%s"]\n' "${v[0]}" "${s[0]}"
  printf '[[joint]]\ntype = "revolute"\naxis = "-y"\nvariable = "%s"\nlink = ["%s", "%s", 0]\n' "${v[1]}" "${s[1]}" "${s[2]}"
  printf '[[joint]]\ntype = "prismatic"\naxis = "+x"\nvariable = "%s"\n' "${v[2]}"
  printf '[[joint]]\ntype = "revolute"\naxis = "+x"\nvariable = "%s"\n' "${v[3]}"
  printf '[[joint]]\ntype = "revolute"\naxis = "+y"\nvariable = "%s"\n' "${v[4]}"
  printf '[[joint]]\ntype = "revolute"\naxis = "+x"\nvariable = "%s"\nlink = ["%s", 0, 0]\n' "${v[5]}" "${s[3]}"
}

plain_variables=(theta1 theta2 d3 theta4 theta5 theta6)
plain_symbols=(h1 l2 d2 l6)
variables=(a half_a result locked cos_a branch)
symbols=(goal_x pose_s pose_r_w target_q_w)
more_symbols=(turn_11 result angle pose_p_x)
more_variables=(x y z pose seed limits)
locals=(t w p t0)
arm plain plain_variables plain_symbols >"$scratch/plain.toml"
arm first variables symbols >"$scratch/first.toml"
arm second plain_variables more_symbols >"$scratch/second.toml"
arm third more_variables locals >"$scratch/third.toml"

"$tool" generate "$scratch"/*.toml --only kinematics,inverse --require inverse -o "$scratch/out" >/dev/null 2>"$scratch/messages" \
  || { cat "$scratch/messages"; fail "generate"; }
counts() { "$tool" counts --format csv -o "$scratch/out" | sed -n "s/^$1,inverse_kinematics,//p"; }
[[ -n $(counts plain) ]] || fail "no counts"
# The compiler's own dialect knows more words than the standard's; that this is enough, one robot shows. Robots that are compiled
# as one read the headers once.
for robot in first second third; do
  # Other names give the arm the same derivation.
  [[ $(counts "$robot") == "$(counts plain)" ]] || fail "counts of $robot"
  echo "#include \"out/source/$robot/inverse.cpp\"" >>"$scratch/gnu++20.cpp"
done
head -1 "$scratch/gnu++20.cpp" >"$scratch/c++17.cpp"
for dialect in gnu++20 c++17; do
  "$cxx" -std=$dialect -O0 -fsyntax-only -Wall -Wextra -Wconversion -Wshadow -Werror -isystem "$eigen" -I"$runtime" \
    -I"$scratch/out/include" "$scratch/$dialect.cpp" || fail "in $dialect"
done
