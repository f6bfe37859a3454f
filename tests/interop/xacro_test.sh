#!/bin/sh
# SPDX-License-Identifier: MIT
# xacro_test.sh QVGEN: files with macros are given to the machine's xacro with arguments and packages, its words are told,
# and it is ended with its budget. A stand-in takes the place of xacro; where there is a real one, that is tried too.
set -eu
qvgen=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/bin" "$folder/ws/arms_description/urdf"
arm=$folder/ws/arms_description/urdf/arm.urdf.xacro

fail() { echo "FAILED: $*"; exit 1; }
expect() { case "$1" in *"$2"*) ;; *) fail "no '$2' in: $1" ;; esac }

cat > "$arm" <<'END'
<?xml version="1.0"?>
<robot name="ARM" xmlns:xacro="http://ros.org/wiki/xacro">
  <xacro:arg name="length" default="0.5"/>
  <xacro:include filename="$(find parts_description)/link.xacro"/>
  <link name="base"/>
  <xacro:one length="$(arg length)"/>
</robot>
END
mkdir "$folder/ws/parts"
echo '<package><name>parts_description</name></package>' > "$folder/ws/parts/package.xml"
cat > "$folder/ws/parts/link.xacro" <<'END'
<robot xmlns:xacro="http://ros.org/wiki/xacro">
  <xacro:macro name="one" params="length">
    <link name="tip"/>
    <joint name="turn" type="continuous"><parent link="base"/><child link="tip"/><origin xyz="0 0 ${2*length}"/></joint>
  </xacro:macro>
</robot>
END

# A file is read once if that is enough.
said=$(echo '<robot name="piped"><link name="a"/><link name="b"/><joint name="j" type="continuous"><parent link="a"/>
  <child link="b"/></joint></robot>' | "$qvgen" check /dev/stdin 2>&1) || fail "$said"
expect "$said" "piped: piped, a to b (R)"

# Without xacro: where the macro is, and how to install xacro.
said=$(PATH=/usr/bin:/bin "$qvgen" check "$arm" 2>&1) && case "$said" in *"(expanded)"*) ;; *) fail "read without xacro" ;; esac
case "$said" in *"(expanded)"*) ;; *) expect "$said" "arm.urdf.xacro:3:3: error: <xacro:arg> is a macro of xacro; install xacro, which is run then: pip install xacro" ;; esac

# A stand-in: it says what it was given, and does what the arguments ask for.
cat > "$folder/bin/xacro" <<'END'
#!/bin/sh
file=$1 output=$3; shift 3
case "$*" in
  *end:=never*) while :; do :; done ;;
  *end:=badly*) echo "error: undefined substitution argument length" >&2; echo "when processing file: $file" >&2; exit 2 ;;
esac
echo "<robot name='given' ><link name='base'/><link name='tip'/><joint name='j' type='continuous'><parent link='base'/>
<child link='tip'/><origin xyz='0 0 1.5708' rpy='1.5708 0 0'/></joint><!-- $* --></robot>" > "$output"
END
chmod +x "$folder/bin/xacro"
export PATH="$folder/bin:$PATH"
said=$("$qvgen" check "$arm" 2>&1) || fail "$said"
expect "$said" "arm.urdf.xacro (expanded):2:50: note: 1.5708 is read as 90 deg"
expect "$said" "given: given, base to tip (R)"
said=$("$qvgen" check "$arm" --xacro-arg end:=badly 2>&1) && fail "an error of xacro is none"
expect "$said" "arm.urdf.xacro:1:1: error: xacro: error: undefined substitution argument length; when processing file: "
said=$("$qvgen" check "$arm" --xacro-arg length 2>&1) && fail "an argument without a value"
expect "$said" "'length' is not NAME:=VALUE"
said=$(ulimit -t 2 && "$qvgen" check "$arm" --xacro-arg end:=never 2>&1) && fail "an endless xacro ends"
expect "$said" "error: xacro: "
"$qvgen" generate "$arm" --only model --quiet --output "$folder/out" --xacro-arg length:=1 --xacro-arg n:=2
grep -q -e "--xacro-arg length:=1 --xacro-arg n:=2" -r "$folder/out" || fail "the arguments are not in the list of robots"

# A depfile names what the file includes, by another run of xacro that lists it.
cat > "$folder/bin/xacro" <<'END'
#!/bin/sh
output=$3
case "$*" in
  *--deps*) echo "$2/none $1 $(dirname "$1")/part.xacro" > "$output" ;;
  *) echo "<robot name='given'><link name='base'/><link name='tip'/><joint name='j' type='continuous'><parent link='base'/>
<child link='tip'/></joint></robot>" > "$output" ;;
esac
END
: > "$(dirname "$arm")/part.xacro"
"$qvgen" generate "$arm" --only model --quiet --output "$folder/out" --depfile "$folder/arm.d"
grep -q "urdf/part.xacro" "$folder/arm.d" || fail "no included file in the depfile: $(cat "$folder/arm.d")"
grep -q none "$folder/arm.d" && fail "a file that is not there in the depfile"

# A file of a package, by the package's name.
cp "$arm" "$folder/ws/parts/robot.xacro"
said=$("$qvgen" check package://parts_description/robot.xacro --package-path "$folder/ws" 2>&1) || fail "$said"
expect "$said" "given: given, base to tip (R)"
said=$("$qvgen" check package://none/robot.xacro 2>&1) && fail "a package that is not there"
expect "$said" "say where with --package-path FOLDER"

# The real one, if this machine has it.
rm "$folder/bin/xacro"
if command -v xacro > /dev/null; then
  said=$("$qvgen" import "$arm" --xacro-arg length:=0.25 2>&1) || fail "$said"
  expect "$said" "origin = [0, 0, 0.5]"
  expect "$said" 'source = "arm.urdf.xacro"'
  mkdir -p "$folder/far/away"
  mv "$folder/ws/parts" "$folder/far/away/parts"
  said=$("$qvgen" check "$arm" 2>&1) && fail "a package that is not there"
  expect "$said" "there is no package 'parts_description'"
  "$qvgen" check "$arm" --package-path "$folder/far" > /dev/null
  ROS_PACKAGE_PATH=$folder/far/away "$qvgen" check "$arm" > /dev/null
fi
