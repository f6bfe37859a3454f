#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# folders.sh FOLDER: FOLDER/README.md, the map of the tests, has one row for each folder that has tests, and no row for others.
set -euo pipefail
cd "$1"
folders=$(for list in */CMakeLists.txt; do dirname "$list"; done | sort)
rows=$(sed -n 's/^| \[\{0,1\}\([a-z_0-9]*\)\(](.*)\)\{0,1\} |.*| \(fast\|slow\|fast, slow\|by hand\) |$/\1/p' README.md | sort)
diff <(echo "$folders") <(echo "$rows") || { echo "folders with tests (<) and rows of $1/README.md (>) differ"; exit 1; }
