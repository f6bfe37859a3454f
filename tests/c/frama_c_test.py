# SPDX-License-Identifier: MIT
"""Frama-C's value analysis of generated C: forward kinematics, Jacobians, dynamics, whatever the main file has.

    python3 frama_c_test.py QVGEN FOLDER [--solutions] ROBOT...

Every public function is called with any numbers, infinities and NaN among them. No alarm: no read or write out of bounds, none of what
was not written, no overflow of whole numbers, none of a conversion. With --solutions it is all solutions of a pose that are called, a
minute or two a robot. Skipped without frama-c (Debian: frama-c-base).
"""
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "languages"))
from c_header import Header  # noqa: E402

SKIPPED = 77
HEAD = """#include "{}"
volatile double anything;
static void fill(double* x, int count) {{ for (int i = 0; i < count; ++i) x[i] = anything; }}
"""


def call(header, name, kinds, result):
    """A block of C that calls a function with any numbers."""
    lines, given = [], []
    for i, (kind, own, size) in enumerate(kinds):
        if kind in ("geometry", "inertia"):
            lines.append(f"{header.robot}_{kind} a{i}; fill((double*)&a{i}, sizeof a{i} / sizeof(double));")
            given.append(f"&a{i}")
        elif kind == "number":
            given.append("anything")
        elif kind == "result":
            declared = "double result" + "".join(f"[{n}]" for n in size) if isinstance(size, list) else f"{size} result"
            lines.append(declared + ";")
            given.append("result" if isinstance(size, list) else "&result")
        else:
            assert kind == "array", (name, kind, own)
            lines.append(f"double a{i}[{size}]; fill(a{i}, {size});")
            given.append(f"a{i}")
    return "  { " + " ".join(lines) + f" (void){header.robot}_{name}({', '.join(given)}); }}\n"


# Places where the ranges of counters are first widened to: they speed the analysis up and assume nothing.
SOLUTIONS = """volatile int choice;
int main(void) {{
  //@ widen_hints global:"all", 0, 1, 8, 60, 72, 80, 132, 204;
  double orientation[4], position[3], seed[{robot}_dof];
  {robot}_geometry g;
  {robot}_solutions found;
  fill(orientation, 4); fill(position, 3); fill(seed, {robot}_dof); fill((double*)&g, sizeof g / sizeof(double));
  (void){robot}_inverse_kinematics(orientation, position, choice ? seed : NULL, choice ? &g : NULL, anything, &found);
  return 0;
}}
"""


def alarms(folder, robot, text, sources, unrolled, least_reached):
    """Number of alarms of a program, which reaches that share of its statements at least."""
    program = folder / f"{robot}_any.c"
    program.write_text(text)
    options = ["-eva", "-eva-precision", "1", "-eva-min-loop-unroll", str(unrolled), "-eva-no-show-progress", "-warn-special-float", "none"]
    done = subprocess.run(["frama-c", *options, f"-cpp-extra-args=-I{folder / 'c'}", program, *sources], capture_output=True,
                          text=True, timeout=1200)
    found = re.search(r"(\d+) alarms? generated", done.stdout)
    reached = re.search(r"statements reached \(out of \d+\): (\d+)% coverage", done.stdout)
    if found is None or reached is None or int(reached[1]) < least_reached:
        sys.exit(f"{robot}: the analysis did not end\n{done.stdout[-3000:]}{done.stderr}")
    for line in re.findall(r"\[eva:alarm\].*\n.*", done.stdout)[:5]:
        print(line)
    return int(found[1])


def alarms_of_functions(folder, robot):
    header = Header(robot, [(folder / "c" / f"qvgen_{robot}.h").read_text()])
    calls = "".join(call(header, *each) for each in header.functions)
    text = HEAD.format(f"qvgen_{robot}.h") + "int main(void) {\n" + calls + "  return 0;\n}\n"
    return alarms(folder, robot, text, [folder / "c" / f"qvgen_{robot}.c"], 400, 100)


def alarms_of_solutions(folder, robot):
    """Statements for arms of other structures are not reached."""
    sources = [folder / "c" / f"qvgen_{robot}{part}.c" for part in ("_inverse", "")]
    text = HEAD.format(f"qvgen_{robot}_inverse.h") + SOLUTIONS.format(robot=robot)
    return alarms(folder, robot, text, sources, 9, 90)


def stack_is_bounded(folder, robot):
    """True if GCC knows the stack of every function of all files."""
    for source in sorted((folder / "c").glob(f"qvgen_{robot}*.c")):
        made = folder / f"{source.stem}.o"
        done = subprocess.run(["gcc", "-std=c99", "-O2", "-fstack-usage", "-Wvla", "-Werror", "-c", source, "-o", made],
                              capture_output=True, text=True)
        usage = made.with_suffix(".su")
        if done.returncode != 0 or any(line.split("\t")[2] not in ("static", "dynamic,bounded") for line in usage.read_text().splitlines()):
            print(done.stderr)
            return False
    return True


def main(tool, folder, *robots):
    if shutil.which("frama-c") is None:
        print("skipped: there is no frama-c; Debian has it in the package frama-c-base")
        sys.exit(SKIPPED)
    folder = pathlib.Path(folder)
    analyse = alarms_of_functions
    if robots[0] == "--solutions":
        analyse, robots = alarms_of_solutions, robots[1:]
    failed = 0
    for each in robots:
        subprocess.run([tool, "generate", each, "--language", "c", "--output", folder, "--quiet"], check=True)
        count = analyse(folder, pathlib.Path(each).stem)
        print(f"{pathlib.Path(each).stem}: {count} alarms")
        failed += count > 0 or not stack_is_bounded(folder, pathlib.Path(each).stem)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
