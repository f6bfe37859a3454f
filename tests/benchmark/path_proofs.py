#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""path_proofs.py TOOL [N]: time of the proofs of `qvgen path --prove`, N paths of 1,000 poses an arm and way between poses.

Paths are bent ways of half a metre in front of the arm, made here. Processor time of the tubes of all motions, of the proof that
no other motion follows the path, and the share of the path on which that is not proven, next to singular poses.
"""
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

# Robot, options, the middle of its paths (m).
ARMS = [("ur5", [], (0.45, 0.1, 0.3)), ("irb6640", [], (1.6, 0.2, 1.2)), ("iiwa14", ["--hold", "theta3=0.3"], (0.5, 0.1, 0.4))]
WAYS = [("straight", []), ("spline", ["--spline"]), ("blend", ["--blend", "0.0001"])]
POSES, LENGTH = 1000, 0.5


def path_through(middle, seed):
    """Rows of x, y, z and a rotation vector: a line with a bend, the tool pointing down and turning."""
    numbers = random.Random(seed)
    along, bend, turn = ([numbers.uniform(-1, 1) for _ in range(3)] for _ in range(3))
    length = math.hypot(*along)
    for i in range(POSES):
        t = LENGTH * (i / (POSES - 1) - 0.5)
        place = [m + t * a / length + t * t * b for m, a, b in zip(middle, along, bend)]
        yield [*place, math.pi * 0.9 + 0.3 * t * turn[0], 0.3 * t * turn[1], 0.3 * t * turn[2]]


def proof_of(tool, arm, options, rows):
    """Runs the tool on one path; returns its JSON."""
    with tempfile.TemporaryDirectory() as folder:
        poses, found = pathlib.Path(folder) / "poses.csv", pathlib.Path(folder) / "found.json"
        lines = [",".join(repr(each) for each in row) for row in rows]
        poses.write_text("\n".join(["x,y,z,rx,ry,rz", *lines]) + "\n")
        subprocess.run([tool, "path", arm, poses, "--prove", "-o", found, *options], check=True, capture_output=True)
        return json.loads(found.read_text())


def row_of(tool, arm, options, middle, count):
    tubes, others, motions, share = [], [], 0, 0
    for seed in range(count):
        found = proof_of(tool, arm, options, path_through(middle, seed))
        times = [motion["proof"]["seconds"] for motion in found["motions"]]
        motions += len(times)
        tubes += times
        others.append(found["complete"]["seconds"])
        share += sum(end - start for start, end in found["complete"]["gaps"]) / (POSES - 1)
    mean = sum(tubes) / max(1, len(tubes))
    return (f"{motions / count:10.1f}{mean:12.3f}{max(tubes, default=0):10.3f}{sorted(others)[count // 2]:14.2f}"
            f"{max(others):10.2f}{100 * share / count:13.2f} %")


def main():
    tool, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print(f"{'proofs, s':22}{'motions':>10}{'one tube':>12}{'slowest':>10}{'no other one':>14}{'slowest':>10}{'not proven':>15}")
    for arm, options, middle in ARMS:
        for way, between in WAYS:
            print(f"{arm + ', ' + way:22}" + row_of(tool, arm, [*options, *between], middle, count), flush=True)


if __name__ == "__main__":
    main()
