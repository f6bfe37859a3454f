# SPDX-License-Identifier: MIT
"""qvgen.identify: the arm that it writes has the dynamics of the one that made the log; the tool's messages come as BuildError."""

import numpy as np
import pytest

import qvgen
from conftest import URDF


@pytest.fixture(scope="module")
def log(arm, tmp_path_factory):
    """Table of a motion of the arm and of its torques."""
    time = np.linspace(0, 20, 4000)[:, None]
    frequencies, amplitudes = np.array([[0.7, 1.1], [1.9, 2.3], [3.1, 4.3]]), np.array([[0.9, 0.7], [0.3, 0.4], [0.2, 0.1]])
    waves = [(k, a, k * time + [0.3, 1.2]) for k, a in zip(frequencies, amplitudes)]
    q = sum(a * np.sin(at) for _, a, at in waves)
    qd = sum(a * k * np.cos(at) for k, a, at in waves)
    qdd = sum(-a * k**2 * np.sin(at) for k, a, at in waves)
    columns = ["time [s]", *(f"{name}{joint} [{unit}]" for name, unit in
                             (("q", "rad"), ("qd", "rad/s"), ("qdd", "rad/s^2"), ("torque", "Nm")) for joint in (1, 2))]
    file = tmp_path_factory.mktemp("log") / "log.csv"
    np.savetxt(file, np.hstack([time, q, qd, qdd, arm.inverse_dynamics(q, qd, qdd)]), "%.17g", ",", header=",".join(columns), comments="")
    return file


def test_the_written_arm_has_the_torques_of_the_log(arm, rows, log):
    file = log.with_name("identified.toml")
    report = qvgen.identify(URDF, log, file, "--name", "identified")
    assert "viscous" in report
    found = qvgen.load(file, "--only", "dynamics")
    motion = [rows(arm, seed=seed) for seed in (1, 2, 3)]
    np.testing.assert_allclose(found.inverse_dynamics(*motion), arm.inverse_dynamics(*motion), atol=1e-6)
    files = sorted(log.parent.iterdir())
    held_out = qvgen.identify(URDF, [log], None, "--hold-out", log)
    assert held_out != report and files == sorted(log.parent.iterdir())


def test_the_tools_messages(log, tmp_path):
    with pytest.raises(qvgen.BuildError, match="none.csv"):
        qvgen.identify(URDF, tmp_path / "none.csv", tmp_path / "out.toml")
    with pytest.raises(qvgen.BuildError, match="none.csv"):
        qvgen.calibrate("ur5", tmp_path / "none.csv", tmp_path / "out.toml")
    assert not (tmp_path / "out.toml").exists()
