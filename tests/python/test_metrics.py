# SPDX-License-Identifier: MIT
"""Orders of solutions: against those of C++ where it has the order, else against their definition."""

import numpy as np
import pytest

import qvgen
from qvgen.metrics import FastestTime, LargestJoint, WeightedDistance, best, sort_by

METRICS = [WeightedDistance(np.arange(1.0, 7)), LargestJoint(), LargestJoint(np.arange(1.0, 7)),
           FastestTime(np.arange(1.0, 7), np.arange(7.0, 1, -1)), FastestTime(np.full(6, 2.0))]


def ways(ns, q, seed):
    """Ways of one row, joint by joint."""
    return [np.remainder(a - b + np.pi, 2 * np.pi) - np.pi if turns else a - b
            for a, b, turns in zip(q, seed, ns.is_revolute)]


def test_the_order_of_distances_is_that_of_cxx(ns, rows):
    q, seed = rows(ns), rows(ns, seed=2)
    poses = ns.forward_kinematics(q)
    own = ns.inverse_kinematics(poses, seed)
    found = sort_by(ns.inverse_kinematics(poses), WeightedDistance(np.ones(6)), seed, ns.is_revolute)
    np.testing.assert_array_equal(found.branch, own.branch)
    np.testing.assert_allclose(found.q, own.q, atol=1e-12)
    lower, upper = np.full(6, -7.0), np.full(6, 7.0)
    own = ns.inverse_kinematics(poses, seed, limits=(lower, upper))
    shuffled = sort_by(own, lambda q: np.sin(1e3 * q[..., 0]))
    assert (shuffled.branch != own.branch).any()
    np.testing.assert_array_equal(sort_by(shuffled, WeightedDistance(np.ones(6)), seed).q, own.q)


@pytest.mark.parametrize("metric", METRICS)
def test_the_least_comes_first(ns, rows, metric):
    q, seed = rows(ns, 20), rows(ns, 20, seed=2)
    found = sort_by(ns.inverse_kinematics(ns.forward_kinematics(q)), metric, seed, ns.is_revolute)
    for i in range(20):
        own = [float(metric(np.array(ways(ns, row, seed[i])))) for row in found.q[i, :found.count[i]]]
        np.testing.assert_allclose(own, sorted(own), atol=1e-12)
    np.testing.assert_array_equal(best(found, metric, seed, ns.is_revolute), found.q[:, 0])
    one = sort_by(qvgen.Solutions(*(field[3] for field in found)), metric, seed[3], ns.is_revolute)
    np.testing.assert_array_equal(one.q, found.q[3])


def test_the_time_of_a_trapezoid_is_that_of_its_way():
    random = np.random.default_rng(1)
    speed, acceleration, way = random.uniform(0.1, 3, (3, 1000))
    time = np.array([FastestTime([v], [a])(np.array([-s])) for v, a, s in zip(speed, acceleration, way)])
    ramp = np.minimum(time / 2, speed / acceleration)
    np.testing.assert_allclose(acceleration * ramp * (time - ramp), way, rtol=1e-12)
    assert FastestTime([2, 1])(np.array([1, 0.25])) == 0.5 and FastestTime([2, 1])(np.zeros(2)) == 0
    assert FastestTime([np.inf], [2])(np.array([4.0])) == 2 * np.sqrt(2)


def test_a_score_of_ones_own(ns, rows):
    found = ns.inverse_kinematics(ns.forward_kinematics(rows(ns)))
    highest = sort_by(found, lambda q: -q[..., 2])
    assert (np.diff(highest.q[..., 2], axis=1) <= 0).all()
    nothing = sort_by(found, lambda q: np.full(q.shape[:-1], np.nan))
    np.testing.assert_array_equal(nothing.q, found.q)
    assert np.isnan(best(found, lambda q: np.full(q.shape[:-1], np.nan))).all()


def test_poses_without_solutions_stay_without(ns, rows):
    pose = ns.forward_kinematics(rows(ns, 3))
    pose[1] = np.nan
    found = sort_by(ns.inverse_kinematics(pose), LargestJoint(), np.zeros(6), ns.is_revolute)
    assert np.isnan(found.q[1]).all() and (found.branch[1] == -1).all() and found.count[1] == 0
    chosen = best(found, LargestJoint(), np.zeros(6), ns.is_revolute)
    assert np.isnan(chosen[1]).all() and not np.isnan(chosen[[0, 2]]).any()
