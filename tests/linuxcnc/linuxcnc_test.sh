#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# linuxcnc_test.sh SOURCE WORK TOOL CC: makes components of robots, compiles them as C99 without a warning against stand-ins for
# LinuxCNC's headers, and against its own where they are installed, and runs them.
set -euo pipefail
source=$1 work=$2 tool=$3 cc=$4
here=$source/tests/linuxcnc
mkdir -p "$work"
declare -A direction=([five_axes]=-1) given=([gantry]=0,1,8)
for description in puma560 ns "$source"/tests/motors/{bevel_arm,gantry}.toml "$here/five_axes.toml"; do
  robot=$(basename "$description" .toml)
  "$tool" generate "$description" --only kinematics,inverse,linuxcnc --require linuxcnc --language c --output "$work" --quiet
  component=$work/c/qvgen_${robot}_kins.c
  warnings=(-std=c99 -Wall -Wextra -Wshadow -Wconversion -Werror -Wno-unused-function)
  if [[ -e /usr/include/linuxcnc/kinematics.h ]]; then
    "$cc" "${warnings[@]}" -Wno-unused-parameter -I/usr/include/linuxcnc -DRTAPI -fsyntax-only "$component"
  else
    echo "not compiled against LinuxCNC's own headers: linuxcnc-uspace-dev is not installed"
  fi
  # Its functions under other names: the component has those of the robot in itself.
  cat >"$work/$robot.c" <<EOF
#include "qvgen_$robot.c"
const int test_dof_is = ${robot}_dof;
void test_matrix(const double* q, double result[4][4]) { ${robot}_homogeneous_transform(q, &${robot}_default_geometry, result); }
EOF
  "$cc" "${warnings[@]}" -O1 -I"$here/interface" -I"$work/c" -c "$component" -o "$work/kins.o"
  "$cc" -std=c99 -O0 -I"$work/c" -c "$work/$robot.c" -o "$work/robot.o"
  objcopy --keep-global-symbol=test_dof_is --keep-global-symbol=test_matrix --keep-global-symbol=test_is_revolute \
    --redefine-sym "${robot}_is_revolute=test_is_revolute" "$work/robot.o"
  "$cc" -std=c99 -O0 -I"$here/interface" "-DROBOT(name)=test_##name" -DROBOT_REVOLUTE=test_is_revolute "-DDIRECTION=${direction[$robot]-0}" "-DGIVEN=${given[$robot]--1}" \
    "$here/module_test.c" "$work/kins.o" "$work/robot.o" -lm -o "$work/${robot}_test"
  echo "$robot: $("$work/${robot}_test")"
done
if "$tool" generate crx10ia --only kinematics,inverse,linuxcnc --require linuxcnc --language c --output "$work" --quiet 2>"$work/said"; then
  echo "crx10ia has a component" && exit 1
fi
grep -q "it is for arms with inverse kinematics for a pose" "$work/said" || { cat "$work/said"; exit 1; }
grep -v tool_axis "$here/five_axes.toml" >"$work/any_axis.toml"
"$tool" generate "$work/any_axis.toml" --only kinematics,inverse,linuxcnc --language c --output "$work" --quiet 2>"$work/said" || true
grep -q 'name the axis of their tool, z or -z: tool_axis = "-z"' "$work/said" || { cat "$work/said"; exit 1; }
