#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""paths_toppra.py QVGEN_PATHS: the least time along one way of 1,000 points by toppra beside this project's, in processor
time, under the same speeds and accelerations. Skipped, and said so, where PyPI's toppra is not installed."""
import subprocess
import sys
import time

try:
    import numpy as np
    import toppra
    from toppra import algorithm, constraint
except ImportError:
    print("skipped: no toppra (pip install toppra)")
    sys.exit(0)

text = subprocess.run([sys.argv[1], "way"], capture_output=True, text=True, check=True).stdout.splitlines()
milliseconds, seconds = (float(word) for word in text[0].split())
way = np.array([[float(word) for word in line.split(",")] for line in text[1:]])
toppra.setup_logging("ERROR")
along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(way, axis=0), axis=1))]
path = toppra.SplineInterpolator(along, way, bc_type="natural")


def planned(scheme):
    limits = [constraint.JointVelocityConstraint(np.full((7, 1), 2) * [-1, 1]),
              constraint.JointAccelerationConstraint(np.full((7, 1), 10) * [-1, 1], discretization_scheme=scheme)]
    planner = algorithm.TOPPRA(limits, path, gridpoints=along, solver_wrapper="seidel")
    speeds = planner.compute_parameterization(0, 0)[1]
    return float(np.sum(2 * np.diff(along) / (speeds[1:] + speeds[:-1])))


def fastest(call, times=5):
    least = float("inf")
    for _ in range(times):
        start = time.process_time()
        result = call()
        least = min(least, 1e3 * (time.process_time() - start))
    return least, result


print(f"{'one way, 7 joints':<24}{'ms':>10}{'least time, s':>18}")
print(f"{'qvgen':<24}{milliseconds:10.2f}{seconds:18.5f}")
for name, scheme in (("toppra, at the points", constraint.DiscretizationType.Collocation),
                     ("toppra, interpolated", constraint.DiscretizationType.Interpolation)):
    print("{:<24}{:10.2f}{:18.5f}".format(name, *fastest(lambda: planned(scheme))))
