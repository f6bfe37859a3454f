#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# cluster_test.sh TOOL ROBOT WORK: a map by three processes that Open MPI starts, each with its share of the blocks, is the
# map of one process.
set -euo pipefail
tool=$1 robot=$2 work=$3
command -v mpirun >/dev/null || { echo "skipped: no mpirun here (Debian: apt-get install openmpi-bin)"; exit 77; }
rm -rf "$work" && mkdir -p "$work" && cd "$work"
options=(--resolution 0.2 --orientations 7 --threads 1)
"$tool" map "$robot" "${options[@]}" -o one.npz
# Command of a scheduler's job, by the number that it gives to each process.
cat > share.sh <<'TEXT'
set -e
rank=$OMPI_COMM_WORLD_RANK count=$OMPI_COMM_WORLD_SIZE
exec "$@" --blocks $((1000 * rank / count)):$((1000 * (rank + 1) / count - 1)) -o "$rank.part"
TEXT
root=()
((EUID != 0)) || root=(--allow-run-as-root)
mpirun "${root[@]}" --oversubscribe -n 3 sh share.sh "$tool" map "$robot" "${options[@]}"
"$tool" map --merge ./*.part -o merged.npz
cmp one.npz merged.npz
