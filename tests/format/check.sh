#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check.sh FOLDER: whether every source file is as clang-format leaves it, but for generated ones. 77 means not checked:
# other versions than .clang-format was written for break lines elsewhere.
set -euo pipefail
cd "$1"
version=14
tool=$(command -v "clang-format-$version" || command -v clang-format) || { echo "skipped: no clang-format"; exit 77; }
[[ $("$tool" --version) == *"version $version."* ]] || { echo "skipped: $("$tool" --version) is not version $version"; exit 77; }

files=$(find generator runtime tests \( -name '*.h' -o -name '*.cpp' \))
[[ -n $files ]] || { echo "no files in $1"; exit 1; }
if ! xargs "$tool" --dry-run --Werror <<<"$files"; then
  echo "to repair: $tool -i FILE"
  exit 1
fi
