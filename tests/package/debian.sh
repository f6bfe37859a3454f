#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# debian.sh BUILD WORK: the Debian packages of the runtime and the tool install, run and uninstall, in a root of their own.
set -euo pipefail
build=$1
work=$2

for program in cpack dpkg dpkg-deb dpkg-shlibdeps; do
  command -v "$program" >/dev/null || { echo "skipped: there is no $program"; exit 77; }
done
rm -rf "$work"
mkdir -p "$work"/root/var/lib/dpkg/{info,updates} "$work"/packages
touch "$work"/root/var/lib/dpkg/{status,available}

fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }
# Scripts and dependencies are the system's affair; what is tried is that files come and go.
in_root() {
  dpkg --root="$work/root" --force-not-root --force-script-chrootless --force-depends "$@" >"$work/log" 2>&1 ||
    { cat "$work/log" >&2; fail "dpkg $*"; }
}

(cd "$work/packages" && cpack --config "$build/CPackConfig.cmake" -G DEB -D CPACK_COMPONENTS_ALL="runtime;tool" \
  -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip >"$work/log" 2>&1) || { cat "$work/log" >&2; fail "cpack"; }
for package in "$work"/packages/*.deb; do
  dpkg-deb --field "$package" Package Depends
done | tee "$work/fields"
grep -q '^Depends:.*libeigen3-dev' "$work/fields" || fail "the runtime does not ask for Eigen"
grep -q '^Depends:.*libginac' "$work/fields" || fail "the tool does not ask for GiNaC"

in_root --install "$work"/packages/*.deb
tool=$work/root/usr/bin/qvgen
"$tool" show ns >/dev/null || fail "the installed tool does not run"
cd "$work"
"$tool" new RRP >arm.toml
"$tool" generate arm.toml --only kinematics --output code >/dev/null || fail "the installed tool does not generate"
[[ -n $(find code -name kinematics.cpp) ]] || fail "nothing was generated"

in_root --remove qvgen libqvgen-dev
rest=$(find "$work/root/usr" ! -type d 2>/dev/null || true)
[[ -z $rest ]] || fail "left behind: $rest"
