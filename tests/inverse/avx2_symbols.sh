#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# avx2_symbols.sh NM LIBRARIES...: no object for AVX2 defines a shared (weak) function but those of the packs themselves.
set -euo pipefail
nm=$1
shift
symbols=$("$nm" --print-file-name "$@" 2>/dev/null)
objects=$(grep -c 'inverse_avx2.*solve_in_lanes' <<<"$symbols" || true)
shared=$(grep '_avx2' <<<"${symbols}" | awk '$(NF-1) ~ /^[WVu]$/ && $NF !~ /4avx2/' || true)
if [[ -n $shared ]]; then
  printf 'shared functions compiled for AVX2:\n%s\n' "$shared"
  exit 1
fi
echo "$objects vector forms, no shared function"
((objects > 0))
