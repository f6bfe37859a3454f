#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# urdf.sh TOOL WRITE_ARMS COMMANDS PLUGIN FOLDER: the README's commands for a URDF, in a folder with nothing but arm.urdf. The
# description that import writes gives the same files as the URDF and as the MJCF, but for the names of their sources.
set -euo pipefail
tool=$1 write_arms=$2 commands=$3 plugin=$4 folder=$5
rm -rf "$folder"
"$write_arms" "$folder/arms" 5
cd "$folder"
cp arms/palletiser_cylinder.urdf arm.urdf
ln -s "$tool" qvgen
bash -eu "$commands"

cp arms/irb140.urdf arm.urdf
bash -eu "$plugin"
grep -q inverse_kinematics_near my_code/moveit/arm/src/plugin.cpp

cp -r arms/gantry.urdf from_urdf.urdf
./qvgen import from_urdf.urdf > from_toml.toml
./qvgen generate from_urdf.urdf --only kinematics --output from_urdf
./qvgen generate from_toml.toml --only kinematics --output from_toml
diff -r -x .qvgen -x qvgen_manifest.json from_urdf from_toml  # these two name the description
./qvgen check new_arm.toml
./qvgen new ns | diff - "$(dirname "$0")/../../generator/robots/ns.toml"

expect() {  # expect STATUS TEXT COMMAND...: the exit status, and a line of the messages
  local status=$1 text=$2 result=0
  shift 2
  "$@" > output 2>&1 || result=$?
  [[ $result == "$status" ]] && grep -qF -- "$text" output || { cat output; echo "not $status: $text"; exit 1; }
}
cp arms/palletiser_cylinder.urdf arm.urdf
expect 3 "--tip tool1: there is no link of that name; did you mean 'tool0'?" ./qvgen check arm.urdf --tip tool1
expect 0 'other: palletiser_cylinder' ./qvgen check arm.urdf --name other
expect 2 "neither a tolerance" ./qvgen check arm.urdf --snap never
expect 2 "neither a known robot nor letters" ./qvgen new RXP
