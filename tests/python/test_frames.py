# SPDX-License-Identifier: MIT
"""Parts that are made on request: frames, masses and the regressor with drives."""

import os
import pathlib

import numpy as np
import pytest

import qvgen

COUPLED = pathlib.Path(__file__).resolve().parents[1] / "frames/robots/coupled.toml"
INERTIA = {"m1": 2, "m3": 1, "c3x": 0.2}
STEP = 1e-6


@pytest.fixture(scope="module")
def coupled():
    if not os.environ.get("QVGEN_PYTHON_ROBOTS"):
        pytest.skip("QVGEN_PYTHON_ROBOTS=1 compiles more robots")
    return qvgen.load(COUPLED, "--only", "frames,geometry_jacobian,mass,regressor_with_drives")


def differences(function, q):
    """The derivatives of a function by the joints, a column each."""
    return np.stack([(function(q + STEP * e) - function(q - STEP * e)) / (2 * STEP) for e in np.eye(len(q))], 1)


def test_frames(coupled, rows):
    assert coupled.frame_names == ["link1", "link2", "link3", "link4", "link5", "palm", "tip"]
    for q in rows(coupled, 5):
        moved = differences(lambda at: coupled.homogeneous_transform_of_palm(at)[:3, 3], q)
        assert np.allclose(coupled.jacobian_of_palm(q)[:3], moved, atol=1e-8)
        assert np.allclose(coupled.frame_poses(q)[5], coupled.homogeneous_transform_of_palm(q), atol=1e-12)
        palm = coupled.link_poses(q)[1] @ [0.1, 0, 0.02, 1]
        assert np.allclose(coupled.forward_kinematics_of_palm(q)[4:], palm[:3], atol=1e-12)
    assert coupled.frame_poses(rows(coupled, 4)).shape == (4, 7, 4, 4)


def test_geometry_jacobian(coupled, rows):
    q = rows(coupled, 4)
    found = coupled.geometry_jacobian(q)
    assert found.shape == (4, 6, 6 * (5 + 1))
    assert all(np.array_equal(found[k], coupled.geometry_jacobian(q[k])) for k in range(4))
    tool = coupled.forward_kinematics(rows(coupled, 4)[0])
    assert np.allclose(found[0, :3, -6:-3] @ found[0, :3, -6:-3].T, np.eye(3)) and tool.shape == (7,)


def test_mass(coupled, rows):
    assert coupled.total_mass(inertia=INERTIA) == 3
    for q in rows(coupled, 5):
        moved = differences(lambda at: coupled.centre_of_mass(at, inertia=INERTIA), q)
        assert np.allclose(coupled.centre_of_mass_jacobian(q, inertia=INERTIA), moved, atol=1e-8)


def test_regressor(coupled, rows):
    q, qd, qdd = rows(coupled, 3)
    found = coupled.regressor_with_drives(q, qd, qdd)
    assert found.shape == (coupled.dof, len(coupled.identifiable_parameter_names))
    assert coupled.identifiable_parameter_names[-1] == "off3"
    assert np.allclose(found[:, -1], [0, 1, 0])  # of `reach`, the second of three values
