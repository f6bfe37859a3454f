# SPDX-License-Identifier: MIT
"""goals.py TOOL: time of an identification from 100,000 samples of seven joints, and of a calibration from 60 poses.

The data are made here, with noise that is known: what the tool leaves must be that noise. Needs NumPy and a C compiler.
"""
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "runtime/python"))
import qvgen

NOISE = np.array([0.5, 0.5, 0.3, 0.3, 0.1, 0.1, 0.05])  # Nm
POSE_NOISE = 5e-5  # m and rad
RANDOM = np.random.default_rng(1)


def timed(*command):
    """Runs a command; returns its output, seconds on the clock and seconds of processors."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    found = subprocess.run(command, text=True, capture_output=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return found.stdout, time.perf_counter() - start, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def write(path, names, *parts):
    np.savetxt(path, np.column_stack(parts), fmt="%.9g", delimiter=",", header=",".join(names), comments="")


def named(pattern, count):
    return [pattern.format(i + 1) for i in range(count)]


def log(path, uneven):
    """Writes 100 s of sines at 1 kHz, with friction and noise of torques; `uneven`: times jitter by a tenth of a step."""
    t = np.arange(100_000) * 1e-3
    if uneven:
        t = t + RANDOM.uniform(-1e-4, 1e-4, len(t))
    q, qd, qdd = (np.zeros((len(t), 7)) for _ in range(3))
    for i in range(7):
        for w, p, a in zip(RANDOM.uniform(0.5, 3, 4), RANDOM.uniform(-3, 3, 4), RANDOM.uniform(0.2, 0.6, 4)):
            q[:, i] += a * np.sin(w * t + p)
            qd[:, i] += a * w * np.cos(w * t + p)
            qdd[:, i] -= a * w * w * np.sin(w * t + p)
    torque = qvgen.robots.iiwa14.inverse_dynamics(q, qd, qdd) + 2 * qd + 3 * np.sign(qd) + NOISE * RANDOM.normal(size=q.shape)
    write(path, ["time [s]", *named("q{} [rad]", 7), *named("torque{} [Nm]", 7)], t, q, torque)


def identification(tool, folder):
    print("identification, 100,000 samples of seven joints          s    processor s    residual / noise")
    for uneven in (False, True):
        log(folder / "log.csv", uneven)
        text, seconds, used = timed(tool, "identify", "iiwa14", str(folder / "log.csv"))
        left = [float(line.split()[3]) for line in text.splitlines() if re.match(r"\S+ +\d+ +[\d.]+ +[\d.]+ +[\d.]+%", line)]
        share = np.array(left) / NOISE
        print(f"  times {'that jitter' if uneven else 'in equal steps':40}{seconds:8.2f}{used:15.2f}{share.min():12.3f} to {share.max():.3f}")


def calibration(tool, folder):
    print("calibration, 60 poses                                    s    processor s    hold-out, expected [mm]")
    for name in ("ur5", "scara"):
        arm = getattr(qvgen.robots, name)
        q = RANDOM.uniform(-3, 3, (60, arm.dof)) * np.where([name == "scara" and i == 2 for i in range(arm.dof)], 0.05, 1)
        poses = arm.forward_kinematics(q + RANDOM.uniform(-5e-3, 5e-3, arm.dof))
        poses[:, 4:] += POSE_NOISE * RANDOM.normal(size=(60, 3))
        poses[:, 1:4] += POSE_NOISE / 2 * RANDOM.normal(size=(60, 3))
        poses[:, :4] /= np.linalg.norm(poses[:, :4], axis=1, keepdims=True)
        write(folder / "poses.csv", [*named("q{}", arm.dof), "qw", "qx", "qy", "qz", "x", "y", "z"], q, poses)
        text, seconds, used = timed(tool, "calibrate", name, str(folder / "poses.csv"))
        row = next(line.split() for line in text.splitlines() if line.startswith("position"))
        print(f"  {name:46}{seconds:8.2f}{used:15.2f}{row[-2]:>14}, {row[-1]}")


def main():
    tool = os.environ["QVGEN_TOOL"] = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder:
        identification(tool, pathlib.Path(folder))
        calibration(tool, pathlib.Path(folder))


if __name__ == "__main__":
    main()
