# SPDX-License-Identifier: MIT
"""Uses the wheels of a folder on a machine without a compiler: first without the extra `compiler`, then with it."""

import os
import pathlib
import subprocess
import sys
import venv

WORK = pathlib.Path(sys.argv[1])
PYTHON = WORK / "venv/bin/python"

REFUSED = """
import qvgen
try:
    qvgen.robots.puma560
    raise SystemExit("compiled without a compiler")
except qvgen.BuildError as error:
    assert "pip install qvgen[compiler]" in str(error), error
"""

LOADED = """
import time
begin = time.perf_counter()
import numpy
with_numpy = time.perf_counter()
import qvgen
imported = time.perf_counter()
arm = qvgen.robots.puma560
end = time.perf_counter()
q = numpy.random.default_rng(1).uniform(-1, 1, (1000, arm.dof))
found = arm.inverse_kinematics(arm.forward_kinematics(q), seed=q)
assert numpy.allclose(found.q[:, 0], q, atol=1e-7)
qd, qdd = q[::-1], q + 1
assert numpy.allclose(arm.forward_dynamics(q, qd, arm.inverse_dynamics(q, qd, qdd)), qdd, atol=1e-6)
load = open("/proc/loadavg").read().split()[0]
print(f"qvgen imported in {imported - with_numpy:.2f} s (NumPy in {with_numpy - begin:.2f} s), a PUMA 560 loaded in {end - imported:.2f} s, load {load}")
"""


def run(*command):
    return subprocess.run([str(each) for each in command], check=True, stdout=subprocess.PIPE, text=True, cwd=WORK).stdout


def install(what):
    run(PYTHON, "-m", "pip", "--disable-pip-version-check", "install", "--no-index", "--find-links", WORK / "wheels", what)


os.environ["QVGEN_CACHE"] = str(WORK / "cache")
venv.create(WORK / "venv", with_pip=True)
install("qvgen")
assert "rust" in run(WORK / "venv/bin/qvgen", "languages")
run(PYTHON, "-c", REFUSED)
install("qvgen[compiler]")
before = os.times()
print("cold:", run(PYTHON, "-c", LOADED), end="")
after = os.times()
print(f"cold: {after.children_user + after.children_system - before.children_user - before.children_system:.1f} s of processor time")
print("warm:", run(PYTHON, "-c", LOADED), end="")
