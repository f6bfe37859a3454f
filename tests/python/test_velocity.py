# SPDX-License-Identifier: MIT
"""Joint rates for twists, with and without limits."""

import numpy as np
import pytest

import qvgen


def test_rates_give_the_twist(ns, arm, rows):
    for robot in (ns, arm):
        q, qd = rows(robot), rows(robot, seed=2)
        twist = robot.velocity(q, qd)
        found = robot.inverse_velocity(q, twist)
        regular = found.status == qvgen.VelocityStatus.solved
        assert regular.sum() > 20 and (found.factor == 1).all() and not found.limited.any()
        np.testing.assert_allclose(found.qd[regular], qd[regular], atol=1e-9)
        np.testing.assert_allclose(found.residual[regular], 0, atol=1e-9)
        one = robot.inverse_velocity(q[3], twist[3])
        assert one.qd.shape == (robot.dof,) and one.status == found.status[3]
        np.testing.assert_array_equal(one.qd, found.qd[3])


def test_scaled_rates_keep_the_direction(arm, rows):
    q, qd = rows(arm), 6 * rows(arm, seed=2)
    twist = arm.velocity(q, qd)
    free, found = arm.inverse_velocity(q, twist), arm.inverse_velocity_scaled(q, twist)
    greatest = np.asarray(arm.velocity_limits)
    factor = np.minimum(1, (greatest / np.abs(free.qd)).min(axis=1))
    np.testing.assert_allclose(found.factor, factor, rtol=1e-15)
    np.testing.assert_allclose(found.qd, factor[:, None] * free.qd, rtol=1e-15)
    assert (np.abs(found.qd) <= greatest).all()
    np.testing.assert_array_equal(found.limited, factor < 1)
    assert 10 < found.limited.sum() < 50


def test_the_nearest_rates_within_limits(arm, rows):
    """No other rates within limits come nearer."""
    q, twist = rows(arm), 4 * np.random.default_rng(3).uniform(-1, 1, (50, 6))
    limits = ([-1.0, 0.25], [2.0, 0.75])
    found = arm.inverse_velocity_within(q, twist, limits=limits)
    assert ((found.qd >= limits[0]) & (found.qd <= limits[1])).all() and found.limited.sum() > 20
    left = np.linalg.norm(np.einsum("nij,nj->ni", arm.jacobian(q), found.qd) - twist, axis=1)
    np.testing.assert_allclose(found.residual, left, atol=1e-12)
    regular = found.status == qvgen.VelocityStatus.solved
    assert regular.sum() > 40
    for other in np.random.default_rng(4).uniform(*limits, (200, 2)):
        against = np.linalg.norm(arm.jacobian(q) @ other - twist, axis=1)
        assert (against >= left - 1e-12)[regular].all()
    free = arm.inverse_velocity_within(q, twist, limits=([-np.inf] * 2, [np.inf] * 2))
    np.testing.assert_allclose(free.qd, arm.inverse_velocity(q, twist).qd, atol=1e-12)


def test_single_precision(arm, rows):
    q, twist = rows(arm).astype(np.float32), np.ones((50, 6), np.float32)
    single, double = arm.inverse_velocity_within(q, twist), arm.inverse_velocity_within(q.astype(float), twist)
    assert single.qd.dtype == single.residual.dtype == np.float32 and double.qd.dtype == np.float64
    np.testing.assert_allclose(single.qd, double.qd, atol=1e-3)


def test_bad_input(arm, rows):
    twist = np.ones((3, 6))
    twist[1, 2] = np.nan
    for function in (arm.inverse_velocity, arm.inverse_velocity_scaled, arm.inverse_velocity_within):
        found = function(rows(arm, 3), twist)
        assert (found.status == qvgen.VelocityStatus.invalid_input).tolist() == [False, True, False]
        assert (found.qd[1] == 0).all()
    assert (arm.inverse_velocity_scaled([0, 0], twist[0], limits=([1, 1], [2, 2])).status
            == qvgen.VelocityStatus.invalid_input)  # which does not admit rest
    for wrong in (None, "elbow", 3, ([0, 0],)):
        with pytest.raises(ValueError, match="limits: neither"):
            arm.inverse_velocity_within([0, 0], twist[0], limits=wrong)
    with pytest.raises(ValueError, match=r"upper limits has the shape \(3,\)"):
        arm.inverse_velocity_scaled([0, 0], twist[0], limits=([0, 0], [1, 1, 1]))
