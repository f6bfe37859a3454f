#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""wasm_test.py TOOL SOURCE PAGES WORK CC: the functions in pages give what the same C gives, compiled for this machine.

That C gives the bits of the C++ functions is tested by the folder c. 10,000 poses a robot; QVGEN_REPORT_ALL=1 for all
robots. Exit 77: clang, wasm-ld or node are missing.
"""
import array
import ctypes
import json
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import unittest

tool, compiler = sys.argv[1], sys.argv[5].split()
source, pages, work = map(pathlib.Path, sys.argv[2:5])
lacking = [name for name in ("clang", "wasm-ld", "node") if shutil.which(name) is None]
if lacking:
    print("skipped: no", ", ".join(lacking))
    sys.exit(77)
some = ["puma560", "iiwa14"]
robots = sorted(p.stem for p in (source / "generator/robots").glob("*.toml")) if os.environ.get("QVGEN_REPORT_ALL") else some
poses = 10000
tolerance = 1e-12


class Native:
    """The robot's C functions as a library of this machine, called in the way of the page's own C."""

    def __init__(self, folder, robot):
        files = sorted((folder / "c").glob(f"qvgen_{robot}*.c"))
        header = "".join(p.read_text() for p in (folder / "c").glob(f"qvgen_{robot}*.h"))
        library = folder / f"lib{robot}.so"
        subprocess.run([*compiler, "-std=gnu99", "-O1", "-ffp-contract=off", "-shared", "-fPIC", "-o", str(library),
                        *map(str, files), "-lm"], check=True)
        self.calls = ctypes.CDLL(str(library))
        self.robot = robot
        self.dof = int(re.search(robot + r"_dof = (\d+)", header)[1])
        self.measures = int(m[1]) if (m := re.search(r"_singularity_measures\([^;]*result\[(\d+)\]", header)) else 0
        capacity = re.search(robot + r"_solutions_capacity = (\d+)", header)
        self.capacity = int(capacity[1]) if capacity else 0
        inverse = re.findall(r"int \w+?_(inverse_kinematics\w*)\(([^;]*)\);", header)
        whole = [(n, p) for n, p in inverse if "orientation[4]" in p and not re.search("_within_limits|_near", n)]
        part = [(n, p) for n, p in inverse if "position[3]" in p and not re.search("_within_limits|_near|_yaw", n)]
        self.inverse = (whole or part or [None])[0]
        symbols = re.search(r"typedef struct %s_geometry \{(.*?)\}" % robot, header, re.S)[1]
        self.symbols = re.findall(r"double (\w+);", symbols)

    def at(self, q, geometry, given):
        numbers = (ctypes.c_double * self.dof)(*q)
        shape = (ctypes.c_double * (len(geometry) + 1))(*geometry)
        results = []
        pose = (ctypes.c_double * 7)()
        self.call("forward_kinematics")(numbers, shape, pose)
        jacobian = (ctypes.c_double * (6 * self.dof))()
        self.call("jacobian")(numbers, shape, jacobian)
        measures = (ctypes.c_double * max(self.measures, 1))()
        if self.measures:
            self.call("singularity_measures")(numbers, shape, measures)
        results = [*pose, *jacobian, *measures[: self.measures]]
        rows = self.rows(pose, numbers, shape, q[given] if given >= 0 else None)
        return results, rows

    def rows(self, pose, seed, shape, given):
        if self.inverse is None:
            return []
        name, parameters = self.inverse
        dof = self.dof

        class Row(ctypes.Structure):
            _fields_ = [("q", ctypes.c_double * dof), ("branch", ctypes.c_int), ("free", ctypes.c_int)]

        class Solutions(ctypes.Structure):
            _fields_ = [("status", ctypes.c_int), ("count", ctypes.c_int), ("effort", ctypes.c_int * 3),
                        ("rows", Row * self.capacity)]

        found = Solutions()
        arguments = [(ctypes.c_double * 4)(*pose[:4])] if "orientation[4]" in parameters else []
        arguments.append((ctypes.c_double * 3)(*pose[4:]))
        if given is not None:
            arguments.append(ctypes.c_double(given))
        tolerance_of = ctypes.c_double.in_dll(self.calls, f"{self.robot}_default_tolerance")
        self.call(name)(*arguments, seed, shape, tolerance_of, ctypes.byref(found))
        return [[*row.q, row.branch, row.free] for row in found.rows[: found.count]]

    def call(self, name):
        return getattr(self.calls, f"{self.robot}_{name}")


class Wasm(unittest.TestCase):
    def test_equal_to_native(self):
        for robot in robots:
            with self.subTest(robot=robot):
                self.compare(robot)

    def compare(self, robot):
        folder = work / robot
        folder.mkdir(parents=True, exist_ok=True)
        parts = ["--only", "kinematics,jacobian,inverse", "--language", "c", "--quiet"]
        subprocess.run([tool, "generate", robot, *parts, "--output", str(folder)], capture_output=True)
        page = pages / f"{robot}.html"
        data = json.loads(re.search(r'id="live-data">(.*?)</script>', page.read_text(), re.S)[1])
        native = Native(folder, robot)
        self.assertEqual(len(native.symbols), len(data["geometry"]))
        self.assertEqual(native.inverse is not None, data["inverse"])
        numbers = random.Random(3)
        q = array.array("d", (numbers.uniform(-3, 3) for _ in range(poses * native.dof)))
        (folder / "points").write_bytes(q.tobytes())
        here, templates = pathlib.Path(__file__).parent, source / "templates/report"
        subprocess.run(["node", str(here / "wasm_run.mjs"), str(page),
                        str(templates / "live_motion.js"), str(templates / "live_arm.js"), str(folder / "points"),
                        str(folder / "results")], check=True)
        results = array.array("d", (folder / "results").read_bytes())
        at, worst, gaps = 0, 0.0, []
        for i in range(poses):
            joints = q[i * native.dof : (i + 1) * native.dof]
            values, rows = native.at(joints, data["geometry"], data["given"])
            size = len(values)
            worst = max(worst, max(abs(a - b) for a, b in zip(values, results[at : at + size])))
            count = int(results[at + size])
            at += size + 1
            theirs = [results[at + k * (native.dof + 2) : at + (k + 1) * (native.dof + 2)] for k in range(count)]
            at += count * (native.dof + 2)
            gaps.append(row_difference(rows, theirs))
        self.assertEqual(at, len(results))
        self.assertLess(worst, tolerance)
        near = sum(gap > tolerance for gap in gaps)
        print(f"{robot}: {poses} poses; pose, Jacobian, measures differ by {worst:.1e} at most, solutions by {max(gaps):.1e}, "
              f"at {near} poses by more than {tolerance:.0e}")
        self.assertLess(max(gaps), 1e-9)
        self.assertLess(near, poses / 1000, "away from singular poses they are equal")


def row_difference(ours, theirs):
    """The largest of rows with the same branch, whole turns apart or not; infinite if there are others."""
    if sorted(row[-2] for row in ours) != sorted(row[-2] for row in theirs):
        return math.inf
    worst = 0.0
    for row in ours:
        same = [other for other in theirs if other[-2] == row[-2]]
        gap = lambda other: max(abs(math.remainder(x - y, 2 * math.pi)) for x, y in zip(row[:-2], other[:-2]))
        worst = max(worst, min(map(gap, same)))
    return worst


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
