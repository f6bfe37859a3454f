# SPDX-License-Identifier: MIT
"""Frama-C's value analysis of generated C: forward kinematics, Jacobians, dynamics, whatever the main file has.

    python3 frama_c_test.py QVGEN FOLDER ROBOT...

Every public function is called with any numbers, infinities and NaN among them. No alarm: no read or write out of bounds, none of what
was not written, no overflow of whole numbers, none of a conversion. Skipped without frama-c (Debian: frama-c-base).
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


def alarms(folder, robot):
    """Number of alarms, and of functions that were called."""
    c = folder / "c"
    file = f"qvgen_{robot}.h"
    header = Header(robot, [(c / file).read_text()])
    program = folder / f"{robot}_any.c"
    calls = "".join(call(header, *each) for each in header.functions)
    program.write_text(HEAD.format(file) + "int main(void) {\n" + calls + "  return 0;\n}\n")
    options = ["-eva", "-eva-precision", "1", "-eva-min-loop-unroll", "400", "-eva-no-show-progress", "-warn-special-float", "none"]
    done = subprocess.run(["frama-c", *options, f"-cpp-extra-args=-I{c}", program, c / f"qvgen_{robot}.c"], capture_output=True,
                          text=True, timeout=300)
    found = re.search(r"(\d+) alarms? generated", done.stdout)
    reached = re.search(r"statements reached \(out of \d+\): (\d+)% coverage", done.stdout)
    if found is None or reached is None or reached[1] != "100":
        sys.exit(f"{robot}: the analysis did not end\n{done.stdout[-3000:]}{done.stderr}")
    for line in re.findall(r"\[eva:alarm\].*\n.*", done.stdout)[:5]:
        print(line)
    return int(found[1]), len(header.functions)


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
    failed = 0
    for each in robots:
        subprocess.run([tool, "generate", each, "--language", "c", "--output", folder, "--quiet"], check=True)
        count, functions = alarms(folder, pathlib.Path(each).stem)
        print(f"{pathlib.Path(each).stem}: {count} alarms of {functions} functions")
        failed += count > 0 or not stack_is_bounded(folder, pathlib.Path(each).stem)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
