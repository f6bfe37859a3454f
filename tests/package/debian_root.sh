#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fresh machines for tests: minimal roots of Debian, made once by debootstrap, in which a command sees the folders it is given.
#
# debian_root.sh make SUITE ROOT PACKAGE...     makes the root; exit code 77, and why, where that is not possible
# debian_root.sh in ROOT FOLDER... -- COMMAND   runs the command there, with these folders at their own paths and no network
set -euo pipefail

skip() { echo "skipped: $*"; exit 77; }

make_root() {
  local suite=$1 root=$2 script=$1 packages
  packages=$(IFS=,; echo "${*:3}")
  [[ ! -e $root/.made ]] || return 0
  ((EUID == 0)) || skip "a root of Debian $suite is made by root alone"
  command -v debootstrap >/dev/null || skip "debootstrap is not installed"
  [[ -e /usr/share/debootstrap/scripts/$suite ]] || script=sid  # of suites that are younger than debootstrap
  rm -rf "$root" && mkdir -p "$root"
  debootstrap --variant=minbase --include="$packages" "$suite" "$root" "${QVGEN_DEBIAN-http://deb.debian.org/debian}" \
    "/usr/share/debootstrap/scripts/$script" >"$root.log" 2>&1 || { tail -3 "$root.log"; skip "Debian $suite cannot be had"; }
  touch "$root/.made"
}

# Called in a mount namespace of its own: in_root ROOT FOLDER... -- COMMAND
in_root() {
  local root=$1
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  shift
  while [[ $1 != -- ]]; do
    mkdir -p "$root/$1"
    mount --bind "$1" "$root/$1"
    shift
  done
  shift
  exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 HOME=/root chroot "$root" "$@"
}

case $1 in
  make) make_root "${@:2}" ;;
  in) exec unshare --mount --net --propagation private "$0" inside "${@:2}" ;;
  inside) in_root "${@:2}" ;;
esac
