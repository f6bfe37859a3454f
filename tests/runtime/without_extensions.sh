#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# without_extensions.sh COMPILER EIGEN FOLDER WORK [BUT]: compiles every header of the runtime and of the robots in FOLDER, but
# those whose paths the expression BUT matches, and the sources of two of them, as by a compiler that knows no extension of GCC.
# A stand-in for cl.exe: the standard library and Eigen are included first; then __GNUC__ and __clang__ are undefined, and every
# keyword and built-in that only GCC and clang have is an error. Attributes such as [[gnu::always_inline]] are left: C++17 wants
# unknown ones ignored.
set -euo pipefail
compiler=$1 eigen=$2 generated=$3 work=$4 but=${5:-^$}
source=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$work"
file=$work/without_extensions.cpp
standard=$(grep -rhoE '^#include <[a-z_0-9]+>' "$source/runtime/include" "$generated/include" | sort -u)
words="vector_size may_alias __attribute__ __attribute __builtin_expect __builtin_memcpy __builtin_cpu_supports
__builtin_cpu_init __builtin_shuffle __builtin_shufflevector __builtin_convertvector __builtin_unreachable __builtin_clz
__builtin_ctz __builtin_popcount __int128 __float128 __extension__ __typeof__ typeof __restrict__"
{
  echo "$standard"
  echo "#include <Eigen/Dense>"
  echo "#undef __GNUC__"
  echo "#undef __clang__"
  for word in $words; do echo "#pragma GCC poison $word"; done
  # Headers for one instruction set are included only where the compiler has it, GCC or clang that is; batches want their
  # vector types, and say so. Of simd what the other headers include is compiled.
  for folder in "$source/runtime/include" "$generated/include"; do
    (cd "$folder" && find qvgen -name '*.h' ! -name '*_avx2.h' ! -path '*/batch/*' ! -path '*/simd/*' ! -name batch.h ! -path '*/map/*' |
      grep -vE "$but" | sort | sed 's/.*/#include <&>/')
  done
  for robot in ur5 iiwa14; do
    [[ robots/$robot/ =~ $but ]] && continue
    find "$generated/source/$robot" -name "*.cpp" ! -name "*_avx2.cpp" | sort | sed "s/.*/#include \"&\"/"
  done
} > "$file"
# The head includes no vector header of the processor, whose built-ins the words above are.
"$compiler" -std=c++17 -fsyntax-only -Wall -Wno-unknown-pragmas -Werror -I "$source/runtime/include" -I "$generated/include" \
  -isystem "$eigen" "$file"
grep -c 'qvgen/' "$file"
