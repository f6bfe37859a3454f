# SPDX-License-Identifier: MIT
"""arm.paths: every motion reaches the poses, the one that was made is among them, and bad input gets a sentence."""

import os

import numpy as np
import pytest

import qvgen

compiles = pytest.mark.skipif(not os.environ.get("QVGEN_PYTHON_ROBOTS"),
                              reason="QVGEN_PYTHON_ROBOTS=1 compiles the program of paths")

START, END = np.array([0.3, -0.4, 0.6, 0.4, 0.8, -0.3]), np.array([0.6, -0.2, 0.5, 0.7, 0.5, 0.1])


def poses_of(arm, count=30):
    return arm.forward_kinematics(START + np.linspace(0, 1, count)[:, None] * (END - START))


@compiles
def test_motions_reach_the_poses(ns):
    poses = poses_of(ns)
    poses[::2, :4] *= -1  # quaternions of either sign
    found = ns.paths(poses, limits=None, times=np.linspace(0, 3, 30))
    assert isinstance(found, qvgen.Paths) and found.whole
    for motion in found.motions:
        at_poses = motion.s == np.round(motion.s)
        reached, wanted = ns.forward_kinematics(motion.q[at_poses]), poses[motion.s[at_poses].astype(int)]
        np.testing.assert_allclose(reached[:, 4:], wanted[:, 4:], atol=1e-9)
        np.testing.assert_allclose(np.abs(np.sum(reached[:, :4] * wanted[:, :4], axis=1)), 1, atol=1e-12)
    assert any(np.allclose(found.motions[i].q[0], START) and np.allclose(found.motions[i].q[-1], END) for i in found.whole)


@compiles
def test_bent_ways_pass_the_same_poses(ns):
    straight, spline = ns.paths(poses_of(ns), limits=None), ns.paths(poses_of(ns), limits=None, spline=True)
    assert len(spline.whole) == len(straight.whole)
    np.testing.assert_allclose(spline.motions[spline.whole[0]].q, straight.motions[straight.whole[0]].q, atol=1e-9)
    assert ns.paths(poses_of(ns), limits=None, blend=0.001).whole


@compiles
def test_limits_cut_motions(ns):
    poses = poses_of(ns)
    bound = START[0] + 0.4 * (END[0] - START[0])
    found = ns.paths(poses, limits=(-3.0, [bound, 3, 3, 3, 3, 3]))
    cut = [motion for motion in found.motions if np.allclose(motion.q[0], START)]
    assert [motion.ends for motion in cut] == ["limit"]
    assert abs(cut[0].q[-1, 0] - bound) < 1e-9 and cut[0].s[-1] < 29


@compiles
def test_least_times_keep_speeds_and_the_fastest_motion_is_named(ns):
    found = ns.paths(poses_of(ns), limits=None, time=6, joint_speeds=[1, 1, 1, 2, 2, 2])
    ends = {i: found.motions[i].t[-1] for i in found.whole}
    assert found.fastest == min(ends, key=ends.get)
    for motion in found.motions:
        assert motion.t[0] == 0 and np.all(np.diff(motion.t) > 0)
        speeds = np.abs(np.diff(motion.q, axis=0)) / np.diff(motion.t)[:, None]
        assert np.all(speeds <= np.array([1, 1, 1, 2, 2, 2]) * (1 + 1e-9))
    assert ns.paths(poses_of(ns), limits=None).fastest is None


@compiles
def test_tolerances_are_kept(ns):
    poses = poses_of(ns)
    found = ns.paths(poses, limits=None, free={"cone_z": 0.1, "tool_z": None, "shift_x": (-0.001, 0.002)})
    assert found.whole == [0]
    motion, reached = found.motions[0], ns.forward_kinematics(found.motions[0].q)
    assert motion.values.shape == (30, 4) and np.all(np.hypot(motion.values[:, 0], motion.values[:, 1]) <= 0.1)
    rotations = [qvgen.orientation.matrix(each[:, :4]) for each in (poses, reached)]
    angles = np.arccos(np.clip(np.sum(rotations[0][:, :, 2] * rotations[1][:, :, 2], axis=1), -1, 1))
    assert np.max(angles) <= 0.1 + 1e-7
    ways = np.einsum("nij,ni->nj", rotations[0], reached[:, 4:] - poses[:, 4:])
    np.testing.assert_allclose(ways, motion.values[:, [3]] * [1, 0, 0], atol=1e-9)
    assert np.all(motion.values[:, 3] >= -0.001) and np.all(motion.values[:, 3] <= 0.002)


def test_bad_tolerances_get_a_sentence(ns):
    poses = poses_of(ns, 5)
    for free, words in (({"cone_z": None}, "tolerance is missing"), ({"shift_x": (1e-3, -1e-3)}, "above the upper"),
                        ({"shift_x": np.nan}, "no number"), ({"cone_z": 15}, "degrees"), ({"shift_x": (0, 1, 2)}, "a range has two")):
        with pytest.raises(ValueError, match=words):
            ns.paths(poses, free=free)


def test_bad_input_gets_a_sentence(ns, arm):
    poses = poses_of(ns, 5)
    for bad, words in ((poses[:, :6], "shape"), (poses[:0], "shape"), (poses * 2, "quaternion")):
        with pytest.raises(ValueError, match=words):
            ns.paths(bad)
    poses[2, 5] = np.nan
    with pytest.raises(ValueError, match="poses.csv:4"):
        ns.paths(poses)
    with pytest.raises(ValueError, match="times"):
        ns.paths(poses, times=[0, 1])
    with pytest.raises(ValueError, match="--time"):
        ns.paths(poses_of(ns, 5), time=-1)
    with pytest.raises(ValueError, match="no effort limits|no value"):
        ns.paths(poses_of(ns, 5), time=6, joint_torques="description")
    with pytest.raises(ValueError, match="6|six"):
        arm.paths(poses_of(ns, 5))
