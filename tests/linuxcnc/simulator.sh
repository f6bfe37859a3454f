#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# simulator.sh SOURCE WORK TOOL: builds components by halcompile and lets LinuxCNC drive simulated machines with them, without a display.
#
# LinuxCNC loads modules from its own folder alone: a copy of it is mounted there, for this test. It does not run as root.
set -euo pipefail
source=$1 work=$2 tool=$3
here=$source/tests/linuxcnc

for program in linuxcnc halcompile halcmd unshare setpriv; do
  command -v "$program" >/dev/null || { echo "skipped: there is no $program (linuxcnc-uspace linuxcnc-uspace-dev)"; exit 77; }
done
modules=/usr/lib/linuxcnc/modules
((EUID == 0)) || { echo "skipped: mounting a folder of modules takes root"; exit 77; }
unshare --mount true 2>/dev/null || { echo "skipped: no mounts of one's own here"; exit 77; }

rm -rf "$work" && mkdir -p "$work/modules"
cp "$modules"/*.so "$work/modules"
for description in puma560 "$source/tests/motors/gantry.toml" "$here/five_axes.toml"; do
  machine=$(basename "$description" .toml)
  folder=$work/$machine
  "$tool" generate "$description" --only kinematics,inverse,linuxcnc --require linuxcnc --language c --output "$folder" --quiet
  (cd "$folder/c" && halcompile --compile "qvgen_${machine}_kins.c" && cp "qvgen_${machine}_kins.so" "$work/modules" &&
   cc -shared -fPIC -O1 "qvgen_$machine.c" -lm -o "$folder/robot.so") >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  /usr/bin/python3 "$here/simulated_machine.py" "$machine" "$folder"
  cp "$here/drive.py" "$folder"
  chmod -R a+rwX "$folder"
  # shellcheck disable=SC2016  # expanded by the inner shell
  timeout 240 unshare --mount --propagation private bash -c 'mount --bind "$1" "$2" && cd "$3" &&
    exec setpriv --reuid=65534 --regid=65534 --clear-groups env "HOME=$3" linuxcnc -r simulation.ini' \
    bash "$work/modules" "$modules" "$folder" >"$folder/log" 2>&1 || true
  cat "$folder/result" 2>/dev/null || { tail -30 "$folder/log"; echo "$machine: no result"; exit 1; }
  grep -qx "$machine: passed" "$folder/result" || { tail -30 "$folder/log"; exit 1; }
done
