# SPDX-License-Identifier: MIT
"""Makes the vectors of a robot: inputs and outputs of every public function of its C, as JSON that every language reads.

    python3 vectors.py QVGEN_OUTPUT ROBOT CC FOLDER [ROUNDS]

writes FOLDER/ROBOT.json. Numbers are the sixteen hexadecimal digits of their bits, whole numbers are "#" and digits:

    {"robot": "ur5", "library": {"sin": {"3ff0...": "3fea..."}},
     "calls": [{"function": "jacobian", "arguments": [["3ff0...", ...], "geometry"], "result": ["bfe0...", ...]}]}
"""
import json
import pathlib
import subprocess
import sys

from c_driver import Driver, shim
from c_header import Header


PARTS = ("", "_inverse", "_velocity")
ALL_PARTS = (*PARTS, "_metrics")  # whose functions take functions: the vectors called "metrics" go through them


def compiled(cc, folder, c_files, driver, robot):
    """Runs the program and returns its lines, and what it called of the library in double."""
    program = folder / f"{robot}_vectors"
    options = ["-std=c99", "-ffp-contract=off", f"-I{c_files}", "-w"]
    objects, first = [], folder / "recorded.h"
    first.write_text(shim())
    for source in [c_files / f"qvgen_{robot}{part}.c" for part in ALL_PARTS if (c_files / f"qvgen_{robot}{part}.c").exists()]:
        objects.append(folder / (source.name + ".o"))
        subprocess.run([cc, "-O1", *options, "-include", first, "-c", source, "-o", objects[-1]], check=True)
    # The driver is thousands of calls in one function, which is run once.
    subprocess.run([cc, "-O0", *options, driver, *objects, "-lm", "-o", program], check=True)
    done = subprocess.run([program], check=True, capture_output=True, text=True)
    return done.stdout.splitlines(), done.stderr.splitlines()


def call_of(line):
    name, *arguments, result = line.split("|")
    return {"function": name, "arguments": [a.split(",") if len(a) >= 16 else a for a in arguments],
            "result": result[1:].split(",") if len(result) > 1 else []}


def make(output, robot, cc, folder, rounds, scalar="double"):
    """Vectors of the robot's C in double or in float, whose numbers are written as the doubles that they are."""
    c_files = pathlib.Path(output) / "c"
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    names = [f"qvgen_{robot}{part}.h" for part in PARTS if (c_files / f"qvgen_{robot}{part}.h").exists()]
    header = Header(robot, [(c_files / name).read_text() for name in names])
    driver = folder / f"{robot}_vectors.c"
    others = [f"qvgen_{robot}_metrics.h"] if (c_files / f"qvgen_{robot}_metrics.h").exists() else []
    driver.write_text(Driver(header, rounds, scalar).text(names + others))
    lines, library = compiled(cc, folder, c_files, driver, robot)
    calls = [call_of(line) for line in lines]
    numbers = {name: [i for i, kind in enumerate(kinds) if kind[0] == "number"] for name, kinds, _ in header.functions}
    for call in calls:
        call["numbers"] = numbers.get(call["function"], [])  # arguments that are no arrays
    known = {}
    for line in library:
        name, *inputs, value = line.split()
        known.setdefault(name, {})[" ".join(inputs)] = value
    result = {"robot": robot, "left_out": header.left_out, "library": known, "calls": calls}
    (folder / f"{robot}.json").write_text(json.dumps(result))
    return header, result


if __name__ == "__main__":
    made = make(*sys.argv[1:5], int(sys.argv[5]) if len(sys.argv) > 5 else 6)[1]
    functions = {call["function"] for call in made["calls"]}
    print(f"{made['robot']}: {len(made['calls'])} vectors of {len(functions)} functions; not {made['left_out']}")
