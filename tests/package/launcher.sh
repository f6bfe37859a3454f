#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# launcher.sh REPOSITORY: ./qvgen on a machine that misses one package. The tools that would look for it and install
# it are stand-ins that only write down what they are asked, so nothing is installed.
set -euo pipefail
repository=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { printf 'FAILED: %s\n' "$*" >&2; cat "$work/output" >&2; exit 1; }
stand_in() { printf '#!/bin/sh\n%s\n' "$2" >"$work/$1"; chmod +x "$work/$1"; }

# shellcheck disable=SC2016  # the stand-in expands it
stand_in dpkg-query 'for last; do :; done; test "$last" = libcln-dev || echo "install ok installed"'
stand_in apt-get "echo \"\$@\" >>$work/asked; test \"\$1\" = update"
stand_in sudo 'exit 1'

status=0
PATH=$work:$PATH "$repository/qvgen" generate </dev/null >"$work/output" 2>&1 || status=$?
((status != 0)) || fail "succeeded without the package"

if ((EUID == 0)); then
  grep -q '^install.* libcln-dev$' "$work/asked" || fail "did not install libcln-dev, or more than that"
else
  grep -q '^ *apt-get install libcln-dev$' "$work/output" || fail "did not say how to install libcln-dev"
fi

# `test --everything` asks for what the tests that may be skipped need.
for package in gcc-arm-none-eabi picolibc-arm-none-eabi qemu-system-arm g++-aarch64-linux-gnu qemu-user texlive-latex-base openmpi-bin \
               clang-format chromium python3-pytest; do
  stand_in dpkg-query "for last; do :; done; test \"\$last\" = $package || echo 'install ok installed'"
  rm -f "$work/asked"
  status=0
  PATH=$work:$PATH "$repository/qvgen" test --everything </dev/null >"$work/output" 2>&1 || status=$?
  ((status != 0)) || fail "test --everything succeeded without $package"
  if ((EUID == 0)); then
    grep -q "^install.* $package\$" "$work/asked" || fail "test --everything did not install $package"
  else
    grep -q "^ *apt-get install $package\$" "$work/output" || fail "test --everything did not say how to install $package"
  fi
done

# Without arguments: how to use it, and exit code 2.
status=0
"$repository/qvgen" >"$work/output" 2>&1 || status=$?
((status == 2)) || fail "exit code $status without arguments"
grep -q '^usage: ./qvgen generate' "$work/output" || fail "no usage without arguments"
