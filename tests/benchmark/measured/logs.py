# SPDX-License-Identifier: MIT
"""logs.py TOOL [FOLDER...]: identification from logs of real arms beside the models that those who recorded them published.

FOLDER is a copy of one of these repositories; logs and models are read there, and nothing of them is copied:
    github.com/marcocognetti/FrankaEmikaPandaDynModel   Gaz and others, RA-L 2019: torques of a Franka Panda
    github.com/shamilmamedov/dynamic_calibration        Mamedov and others, 2020: currents of a UR10e, with gains of its drives

Both models predict motions that were not fitted here. Rates and accelerations are the same for both. Needs NumPy; a C++
compiler for the Panda's model, which takes minutes to compile.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np

STANDSTILL = 0.01  # slower rows of a joint, as a share of its greatest rate, are left out, as the tool does
DRIVER = """#include "franka_model.h"
#include <iostream>
int main() {
  Eigen::Vector7d q, qd, qdd;
  const auto read = [](Eigen::Vector7d& v) { for (int i = 0; i < 7; ++i) std::cin >> v[i]; return bool(std::cin); };
  while (read(q) && read(qd) && read(qdd))
    std::cout << (MassMatrix(q) * qdd + CoriolisMatrix(q, qd) * qd + GravityVector(q) + Friction(qd)).transpose() << "\\n";
}
"""
PANDA = """name = "panda"
title = "Franka Panda"
convention = "modified"
inertia = "free"
""" + "".join(f'[[dh]]\nvariable = "q{i + 1}"\ntheta = "q{i + 1}"\nd = {d}\na = {a}\nalpha = "{alpha} deg"\n' for i, (d, a, alpha) in enumerate(
    [(0.333, 0, 0), (0, 0, -90), (0.316, 0, 90), (0, 0.0825, 90), (0.384, -0.0825, -90), (0, 0, 90), (0, 0.088, 90)]))


class Log:
    """Times, positions, rates and torques, a row a sample."""

    def __init__(self, time, q, qd, torque):
        self.time, self.q, self.qd, self.torque = time, q, qd, torque

    def part(self, begin, end):
        rows = slice(int(begin * len(self.time)), int(end * len(self.time)))
        return Log(*(each[rows] for each in (self.time, self.q, self.qd, self.torque)))

    def write(self, path):
        names = ["time [s]"] + [f"{kind}{i + 1} [{unit}]" for kind, unit in (("q", "rad"), ("qd", "rad/s"), ("torque", "Nm"))
                                for i in range(self.q.shape[1])]
        table = np.column_stack([self.time, self.q, self.qd, self.torque])
        np.savetxt(path, table, fmt="%.9g", delimiter=",", header=",".join(names), comments="")

    def accelerations(self, half):
        """Derivatives of local quartics at the times as they are; NaN near the ends."""
        result = np.full_like(self.qd, np.nan)
        for k in range(half, len(self.time) - half):
            t = self.time[k - half:k + half + 1] - self.time[k]
            powers = np.vander(t / t[-1], 5, increasing=True)
            result[k] = np.linalg.lstsq(powers, self.qd[k - half:k + half + 1], rcond=None)[0][1] / t[-1]
        return result


class Panda:
    title = "Franka Panda, torques of its sensors"
    needs = "cpp/panda_dyn_model_example"
    options = ["--drives", "viscous_friction,coulomb_friction,offset"]  # torques are those of the links
    description = "panda.toml"

    def __init__(self, folder, work):
        self.source, self.work = folder / self.needs, work
        (work / self.description).write_text(PANDA)
        recorded = folder / "matlab/data/Exciting_Traj/Trajectory_1/rbt_log"
        read = lambda name: np.loadtxt(recorded / f"exciting_traj_{name}.txt")
        time = read("time")
        log = Log(time, *(read(name).reshape(len(time), 7) for name in ("positions", "velocity", "torques")))
        self.fitted, self.held = log.part(0, 0.7), log.part(0.7, 1)

    def published(self, q, qd, qdd):
        (self.work / "driver.cpp").write_text(DRIVER)
        sources = [str(self.source / "src" / f"{name}.cpp") for name in ("MassMatrix", "CoriolisMatrix", "GravityVector", "FrictionTorque")]
        subprocess.run(["g++", "-O0", "-w", "-I", str(self.source / "include"), "-I", "/usr/include/eigen3", "-o", "driver", "driver.cpp",
                        *sources], cwd=self.work, check=True)
        rows = "\n".join(" ".join(map(repr, map(float, row))) for row in np.column_stack([q, qd, qdd]))
        found = subprocess.run(["./driver"], cwd=self.work, input=rows, text=True, capture_output=True, check=True)
        return np.array([[float(x) for x in line.split()] for line in found.stdout.splitlines()])


def turn(axis, angle):
    x, y, z = axis
    across = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * across @ across


class Ur10e:
    title = "UR10e, currents times the published gains of the drives"
    needs = "dataset_ur10e"
    options = []
    description = "ur10e.urdf"

    def __init__(self, folder, work):
        text = (folder / "UR10E_parameters.txt").read_text()
        numbers = lambda name: np.array([float(x) for x in re.search(name + r"\s*=\s*\[([^\]]*)\]", text)[1].split()])
        self.gains, self.rotors, self.friction, self.bodies = map(numbers, ("drvGains", "pi_drvs", "pi_frcn", "pi_rgd"))
        self.urdf = (folder / "URe/urdf/ur10e.urdf").read_text()
        (work / self.description).write_text(self.urdf)
        self.options = ["--tip", "wrist_3_link"]
        # The rows that the authors take, of the motions that they fit and validate with.
        self.fitted = self.read(folder / "dataset_ur10e/identification_data/ur-20_02_10-30sec_12harm.csv", 635, 3510)
        self.held = self.read(folder / "dataset_ur10e/validation_data/ur-20_01_17-ptp_10_points.csv", 700, 4200)

    def read(self, path, first, last):
        table = np.loadtxt(path, delimiter=",")[first - 1:last]
        rows = np.append(True, np.diff(table[:, 0]) > 0)
        table = table[rows]
        return Log(table[:, 0] - table[0, 0], table[:, 1:7], table[:, 7:13], table[:, 13:19] * self.gains)

    def published(self, q, qd, qdd):
        joints = re.findall(r'<joint name="\w+" type="revolute">.*?</joint>', self.urdf, re.S)
        vector = lambda text, key: np.array([float(x) for x in re.search(key + r'="([^"]*)"', text)[1].split()])
        frames = [(vector(j, "xyz"), vector(j, "rpy"), vector(re.search("<axis[^>]*>", j)[0], "xyz")) for j in joints]
        return np.array([self.torques(frames, *row) for row in zip(q, qd, qdd)])

    def torques(self, frames, q, qd, qdd):
        """Newton and Euler about the links' origins, in the links' frames."""
        w, dw, a, ways, moves = np.zeros(3), np.zeros(3), np.array([0, 0, 9.81]), [], []
        for i, (xyz, rpy, axis) in enumerate(frames):
            way = turn((0, 0, 1), rpy[2]) @ turn((0, 1, 0), rpy[1]) @ turn((1, 0, 0), rpy[0]) @ turn(axis, q[i])
            a = way.T @ (a + np.cross(dw, xyz) + np.cross(w, np.cross(w, xyz)))
            w_before = way.T @ w
            dw = way.T @ dw + axis * qdd[i] + np.cross(w_before, axis * qd[i])
            w = w_before + axis * qd[i]
            ways.append(way)
            moves.append((w, dw, a))
        force, moment, result = np.zeros(3), np.zeros(3), np.zeros(len(frames))
        for i in reversed(range(len(frames))):
            xx, xy, xz, yy, yz, zz, *h, m = self.bodies[10 * i:10 * i + 10]
            inertia, h = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]), np.array(h)
            w, dw, a = moves[i]
            if i + 1 < len(frames):
                carried = ways[i + 1] @ force
                moment = ways[i + 1] @ moment + np.cross(frames[i + 1][0], carried)
                force = carried
            force = force + m * a + np.cross(dw, h) + np.cross(w, np.cross(w, h))
            moment = moment + inertia @ dw + np.cross(w, inertia @ w) + np.cross(h, a)
            viscous, coulomb, offset = self.friction[3 * i:3 * i + 3]
            result[i] = frames[i][2] @ moment + self.rotors[i] * qdd[i] + viscous * qd[i] + coulomb * np.sign(qd[i]) + offset
        return result


def compare(tool, arm, work):
    arm.fitted.write(work / "fitted.csv")
    arm.held.write(work / "held.csv")
    found = subprocess.run([tool, "identify", arm.description, "fitted.csv", "--hold-out", "held.csv", *arm.options], cwd=work, text=True,
                           capture_output=True)
    if found.returncode != 0:
        sys.exit(found.stderr)
    half = int(re.search(r"through (\d+) samples", found.stdout)[1]) // 2
    table = [line.split() for line in found.stdout.splitlines() if re.match(r"\S+ +\d+ +[\d.]+ +[\d.]+ +[\d.]+%", line)]
    acceleration = arm.held.accelerations(half)
    finite = np.isfinite(acceleration).all(axis=1)
    predicted = np.full_like(arm.held.torque, np.nan)
    predicted[finite] = arm.published(arm.held.q[finite], arm.held.qd[finite], acceleration[finite])
    print(f"\n{arm.title}; motions that were not fitted, {finite.sum()} samples")
    print("joint                      torque rms    published        qvgen")
    for i, row in enumerate(table):
        moving = finite & (np.abs(arm.held.qd[:, i]) >= STANDSTILL * np.abs(arm.fitted.qd[:, i]).max())
        rms = lambda values: np.sqrt(np.mean(values[moving] ** 2))
        torque, published = rms(arm.held.torque[:, i]), rms((arm.held.torque - predicted)[:, i])
        print(f"{row[0]:24}{torque:10.3f} Nm{published:10.4f} Nm{float(row[-1]):10.4f} Nm")


def main():
    tool, *folders = sys.argv[1:]
    if not folders:
        sys.exit(__doc__)
    for folder in map(pathlib.Path, folders):
        arm = next((arm for arm in (Panda, Ur10e) if (folder / arm.needs).is_dir()), None)
        if arm is None:
            sys.exit(f"{folder} is none of the repositories:\n{__doc__}")
        with tempfile.TemporaryDirectory() as work:
            compare(pathlib.Path(tool).resolve(), arm(folder, pathlib.Path(work)), pathlib.Path(work))


if __name__ == "__main__":
    main()
