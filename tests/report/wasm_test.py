#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""wasm_test.py TOOL SOURCE PAGES WORK CC: the functions in pages give what the same C gives, compiled for this machine.

That C gives the bits of the C++ functions is tested by the folder c. 1,000 poses of some robots; QVGEN_REPORT_ALL=1: 10,000 of
all robots, and what is generated in C++ alone beside the same C++ of this machine. Exit 77: clang, wasm-ld or node are missing.
"""
import array
import ctypes
import json
import math
import os
import pathlib
import platform
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
everything = bool(os.environ.get("QVGEN_REPORT_ALL"))
robots = sorted(p.stem for p in (source / "generator/robots").glob("*.toml")) if everything else some
poses = 10000 if everything else 1000
tolerance = 1e-12
# Tolerance of poses, in metres and parts of a quaternion: the last bits of sines differ by the C library, and elimination iterates.
rounding = {"closed form": 1e-14, "elimination": 1e-13}


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
        self.fixes_orientation = self.dof >= 6 or not part
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

    def pose(self, q, geometry):
        pose = (ctypes.c_double * 7)()
        shape = (ctypes.c_double * (len(geometry) + 1))(*geometry)
        self.call("forward_kinematics")((ctypes.c_double * self.dof)(*q), shape, pose)
        return list(pose)

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


class NativeCpp:
    """The arm angle or the elimination of a robot as a library of this machine, from the committed code."""

    def __init__(self, folder, robot, part):
        runtime = source / "runtime/source"
        parts = {"arm_angle": ("arm_angle", "HAS_ARM_ANGLE"), "inverse": ("elimination", "HAS_INVERSE")}
        sources, defined = parts[part]
        files = [runtime / "core/sine_cosine.cpp", runtime / "inverse/requested_pose.cpp", *sorted((runtime / sources).glob("*.cpp"))]
        text = "".join(f'#include "{path}"\n' for path in files)
        everything_in_one = folder / f"{part}.cpp"
        everything_in_one.write_text(text + f'#include "{pathlib.Path(__file__).parent / "native_calls.cpp"}"\n')
        library = folder / f"lib{robot}_{part}.so"
        generated = source / f"generated/source/{robot}/{part}.cpp"
        vectors = ["-mavx2", "-mfma"] if platform.machine() == "x86_64" else []
        subprocess.run(["c++", *vectors, "-std=c++17", "-O1", "-DNDEBUG", "-Wno-psabi", "-ffp-contract=off", "-DQVGEN_NO_CONTRACTION", "-shared", "-fPIC",
                        f"-DROBOT={robot}", f'-DSOURCE="{generated}"', f"-D{defined}", f"-I{source}/runtime/include",
                        f"-I{source}/generated/include", "-isystem", "/usr/include/eigen3", "-o", str(library),
                        str(everything_in_one)], check=True)
        self.calls = ctypes.CDLL(str(library))
        if part == "arm_angle":
            self.calls.arm_angle.restype = ctypes.c_double

    def arm_angle(self, q, geometry):
        numbers = lambda values: (ctypes.c_double * max(len(values), 1))(*values)
        return self.calls.arm_angle(numbers(q), numbers(geometry))

    def rows(self, function, size, pose, q, geometry, *psi):
        numbers = lambda values: (ctypes.c_double * max(len(values), 1))(*values)
        out = (ctypes.c_double * (64 * size))()
        extra = [ctypes.c_double(value) for value in psi]
        count = getattr(self.calls, function)(numbers(pose), numbers(q), *extra, numbers(geometry), out)
        return [list(out[k * size : (k + 1) * size]) for k in range(count)]


class Results:
    """Reads a file of doubles piece by piece."""

    def __init__(self, path):
        self.values, self.at = array.array("d", path.read_bytes()), 0

    def take(self, count):
        self.at += count
        return self.values[self.at - count : self.at]

    def rows(self, size):
        return [self.take(size) for _ in range(int(self.take(1)[0]))]


def generated_c(robot, folder):
    folder.mkdir(parents=True, exist_ok=True)
    parts = ["--only", "kinematics,jacobian,inverse", "--language", "c", "--quiet"]
    subprocess.run([tool, "generate", robot, *parts, "--output", str(folder)], capture_output=True)
    return Native(folder, robot)


def results_of_page(page, q, folder):
    (folder / "points").write_bytes(q.tobytes())
    here, templates = pathlib.Path(__file__).parent, source / "templates/report"
    subprocess.run(["node", str(here / "wasm_run.mjs"), str(page), str(templates / "live_motion.js"),
                    str(templates / "live_arm.js"), str(folder / "points"), str(folder / "results")], check=True)
    return Results(folder / "results")


class Wasm(unittest.TestCase):
    def test_equal_to_native(self):
        for robot in robots:
            with self.subTest(robot=robot):
                self.compare(robot)

    def compare(self, robot):
        folder, page = work / robot, pages / f"{robot}.html"
        native = generated_c(robot, folder)
        data = json.loads(re.search(r'id="live-data">(.*?)</script>', page.read_text(), re.S)[1])
        self.assertEqual(len(native.symbols), len(data["geometry"]))
        eliminated = data["inverse"] and native.inverse is None
        has_arm_angle = "cpp" in data and not eliminated
        cpp = NativeCpp(folder, robot, "arm_angle" if has_arm_angle else "inverse") if everything and "cpp" in data else None
        numbers = random.Random(3)
        q = array.array("d", (numbers.uniform(-3, 3) for _ in range(poses * native.dof)))
        results = results_of_page(page, q, folder)
        worst, gaps, angles, size = 0.0, [], [], native.dof + 2
        for i in range(poses):
            joints = q[i * native.dof : (i + 1) * native.dof]
            values, rows = native.at(joints, data["geometry"], data["given"])
            worst = max(worst, max(abs(a - b) for a, b in zip(values, results.take(len(values)))))
            theirs = results.rows(size)
            if eliminated and cpp:
                rows = cpp.rows("solutions", size, values[:7], joints, data["geometry"])
            if not eliminated or cpp:
                gaps.append(farthest(rows, theirs))
            if has_arm_angle:
                angles.append(self.at_arm_angle(cpp, values[:7], joints, data["geometry"], results))
        self.assertEqual(results.at, len(results.values))
        self.assertLess(worst, tolerance)
        print(f"{robot}: {poses} poses; pose, Jacobian, measures differ by {worst:.1e} at most")
        for what, differences, given in (("solutions", gaps, None), ("solutions by arm angle", angles, cpp)):
            self.assert_near(robot, what, differences, 0.004 if eliminated else 0.001)
            bound = rounding["elimination" if eliminated else "closed form"]
            self.assert_same_pose(differences, lambda row: told(native, given, row, data["geometry"]), bound)

    def at_arm_angle(self, cpp, pose, joints, geometry, results):
        """The difference to the same C++ of this machine, if it is there; else of the row that the joints must be."""
        psi, theirs = results.take(1)[0], results.rows(len(joints) + 2)
        if cpp is None:
            own = [*joints, 0, 0]
            return min(((joint_difference(row, own), own, row) for row in theirs), key=lambda found: found[0])
        return farthest(cpp.rows("solutions_at_arm_angle", len(joints) + 2, pose, joints, geometry, psi), theirs)

    def assert_same_pose(self, differences, told_by, bound):
        """Joints may differ only where the pose does not tell them apart: there it is singular but for its last bits."""
        for gap, row, other in differences:
            if gap > tolerance:
                self.assertLess(pose_difference(told_by(row), told_by(other)), bound, (gap, row, other))

    def assert_near(self, robot, what, differences, share):
        """Near a singular pose the last bits of sines, which differ by the C library, come back larger."""
        gaps = [gap for gap, _, _ in differences]
        if not gaps:
            return
        near = sum(gap > tolerance for gap in gaps)
        print(f"{robot}: {what} differ by {max(gaps):.1e} at most, at {near} poses by more than {tolerance:.0e}")
        self.assertLess(max(gaps), 1e-9, what)
        self.assertLessEqual(near, poses * share, f"{what}: away from singular poses they are equal")


def joint_difference(row, other):
    return max(abs(math.remainder(x - y, 2 * math.pi)) for x, y in zip(row[:-2], other[:-2]))


def told(native, cpp, row, geometry):
    """Returns the solver's arguments for a row's joints: their pose, and the arm angle. An arm with few joints takes a position;
    an orientation it meets within the tolerance of whole poses, not to rounding."""
    pose = native.pose(row[:-2], geometry)
    turn = pose[:4] if native.fixes_orientation else [1, 0, 0, 0]
    return [*turn, *pose[4:]], cpp.arm_angle(row[:-2], geometry) if cpp else 0.0


def pose_difference(a, b):
    """Compares poses, w x y z and metres, and of arm angles; a quaternion's sign means nothing."""
    (p, psi), (r, phi) = a, b
    sign = math.copysign(1, sum(x * y for x, y in zip(p[:4], r[:4])))
    apart = [x - sign * y for x, y in zip(p[:4], r[:4])] + [x - y for x, y in zip(p[4:], r[4:])]
    return max(map(abs, [*apart, math.remainder(psi - phi, 2 * math.pi)]))


def farthest(ours, theirs):
    """The rows of one branch, whole turns apart or not, that differ most, and by how much; infinitely if there are others."""
    if sorted(row[-2] for row in ours) != sorted(row[-2] for row in theirs):
        return math.inf, ours, theirs
    worst = (0.0, [], [])
    for row in ours:
        same = ((joint_difference(row, other), row, other) for other in theirs if other[-2] == row[-2])
        worst = max(worst, min(same, key=lambda found: found[0]), key=lambda found: found[0])
    return worst


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
