# SPDX-License-Identifier: MIT
"""Inverse kinematics: all solutions, within limits, next to a seed, of less than a pose, with a joint given."""

import pathlib

import numpy as np
import pytest

import qvgen

TURN = 2 * np.pi


def solved(found):
    return (found.status == qvgen.Status.solved).all()


def rows_of(found, pose):
    return found.q[pose, :found.count[pose]]


def assert_poses(arm, found, poses):
    """Every row of every pose reaches it; what is behind the last is NaN."""
    for i, pose in enumerate(poses):
        again = arm.forward_kinematics(rows_of(found, i))
        same = np.sign(again[:, :4] @ pose[:4])
        np.testing.assert_allclose(same[:, None] * again[:, :4], np.tile(pose[:4], (len(again), 1)), atol=1e-11)
        np.testing.assert_allclose(again[:, 4:], np.tile(pose[4:], (len(again), 1)), atol=1e-11)
        assert np.isnan(found.q[i, found.count[i]:]).all()


def test_all_solutions(ns, rows):
    q = rows(ns)
    poses = ns.forward_kinematics(q)
    found = ns.inverse_kinematics(poses)
    assert found.q.shape == (50, 8, 6) and found.branch.shape == found.continuum.shape == (50, 8)
    assert solved(found) and (found.count == 8).all() and not found.continuum.any()
    assert (np.sort(found.branch, axis=1) == np.arange(8)).all()
    assert_poses(ns, found, poses)
    np.testing.assert_allclose(ns.inverse_kinematics(poses, q).q[:, 0], q, atol=1e-9)
    one = ns.inverse_kinematics(poses[3])
    np.testing.assert_array_equal(one.q, found.q[3])
    assert one.count == 8 and one.status == qvgen.Status.solved


def test_poses_as_matrices(ns, planar, rows):
    q = rows(ns)
    matrices = ns.homogeneous_transform(q)
    np.testing.assert_allclose(ns.inverse_kinematics(matrices, q).q[:, 0], q, atol=1e-9)
    np.testing.assert_allclose(ns.inverse_kinematics_near(matrices[3], q[3]).q, q[3], atol=1e-9)
    assert planar.inverse_kinematics(planar.homogeneous_transform([0.1, 0.2, 0.3])).status == qvgen.Status.solved
    with pytest.raises(ValueError, match=r"pose has the shape \(3, 3\)"):
        ns.inverse_kinematics(np.eye(3))


def test_poses_of_single_precision_are_taken(ns, rows):
    poses = ns.forward_kinematics(rows(ns).astype(np.float32))
    found = ns.inverse_kinematics(poses)
    assert poses.dtype == np.float32 and found.q.dtype == np.float64 and solved(found)


def test_poses_without_solutions(ns):
    pose = ns.forward_kinematics(np.full(6, 0.4))
    found = ns.inverse_kinematics(np.stack([pose, pose * np.nan]))
    assert found.count[0] > 0 and found.count[1] == 0
    assert found.status[1] == qvgen.Status.invalid and np.isnan(found.q[1]).all() and (found.branch[1] == -1).all()


def test_singular_poses_are_marked(ns):
    q = np.array([0.3, 0.5, 0.7, 0.2, 0.0, 0.4])  # theta5 = 0: only theta4 + theta6 matters
    found = ns.inverse_kinematics(ns.forward_kinematics(q), q)
    assert found.status == qvgen.Status.singular and found.continuum[0]
    np.testing.assert_allclose(found.q[0], q, atol=1e-9)


def test_own_limits(planar, rows):
    q = rows(planar)
    poses = planar.forward_kinematics(q)
    lower, upper = np.array([-7.0, -1.0, -4.0]), np.array([7.0, 2.0, 4.0])
    free = planar.inverse_kinematics(poses)
    found = planar.inverse_kinematics(poses, limits=(lower, upper))
    assert found.q.shape == (50, found.count.max(), 3)
    assert_poses(planar, found, poses)
    for i in range(len(q)):
        turns = TURN * np.stack(np.meshgrid(*[np.arange(-2, 3)] * 3, indexing="ij"), -1).reshape(-1, 3)
        every = (rows_of(free, i)[:, None] + turns).reshape(-1, 3)
        inside = every[((every >= lower) & (every <= upper)).all(axis=1)]
        own = rows_of(found, i)
        assert len(own) == len(inside)
        order = [np.lexsort(np.round(each, 6).T) for each in (own, inside)]
        np.testing.assert_allclose(own[order[0]], inside[order[1]], atol=1e-12)


def test_no_solution_is_left_out_for_want_of_room(planar):
    pose = planar.forward_kinematics([0.1, 0.5, 0.2])
    wide = np.full(3, 100.0)
    found = planar.inverse_kinematics(pose, limits=(-wide, wide))
    assert 2 * 31**3 <= found.count == len(found.q) <= 2 * 32**3
    assert (np.abs(found.q) <= 100).all() and len(np.unique(np.round(found.q, 6), axis=0)) == found.count
    with pytest.raises(ValueError, match="limits: a pose has .* narrow the limits"):
        planar.inverse_kinematics(pose, limits=(-100 * wide, 100 * wide))


def test_a_joint_on_its_limit_is_inside(planar, rows):
    for q in rows(planar):
        found = planar.inverse_kinematics(planar.forward_kinematics(q), q, limits=(q, q + 1))
        assert found.count >= 1 and (found.q[0] >= q).all()
        np.testing.assert_allclose(found.q[0], q, atol=1e-11)


def test_limits_next_to_a_seed(planar, rows):
    q = rows(planar) + [TURN, 0, 0]
    found = planar.inverse_kinematics(planar.forward_kinematics(q), q, limits=([0, -9, -9], [9, 9, 9]))
    assert found.q.shape == (50, 2, 3)
    np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)


def test_limits_of_the_description(arm, rows):
    poses = arm.forward_kinematics(2 * rows(arm, 200))
    found = arm.inverse_kinematics(poses, limits="description")
    own = arm.inverse_kinematics(poses, limits=(arm.lower_limits, arm.upper_limits))
    for one, other in zip(found, own):
        np.testing.assert_array_equal(one, other)
    inside = (found.q >= arm.lower_limits) & (found.q <= arm.upper_limits)
    assert (inside | np.isnan(found.q)).all()
    counts = {(int(had), int(has)) for had, has in zip(arm.inverse_kinematics(poses).count, found.count)}
    assert any(had > has for had, has in counts) and any(had == has > 0 for had, has in counts)


def test_limits_that_make_no_sense(planar):
    pose = planar.forward_kinematics(np.zeros(3))
    for wrong in ("elbow", 3, ([0, 0, 0],)):
        with pytest.raises(ValueError, match="limits: neither None"):
            planar.inverse_kinematics(pose, limits=wrong)
    with pytest.raises(ValueError, match=r"upper limits has the shape \(2,\)"):
        planar.inverse_kinematics(pose, limits=([0, 0, 0], [1, 1]))
    with pytest.raises(ValueError, match="the same for all poses"):
        planar.inverse_kinematics(pose, limits=(np.zeros((4, 3)), [1, 1, 1]))


def test_the_solution_near_a_seed(ns, rows):
    q = rows(ns)
    near = ns.inverse_kinematics_near(ns.forward_kinematics(q), q + 0.01 + [TURN, 0, 0, 0, 0, 0])
    assert solved(near) and near.q.shape == (50, 6)
    np.testing.assert_allclose(near.q, q + [TURN, 0, 0, 0, 0, 0], atol=1e-9)
    one = ns.inverse_kinematics_near(ns.forward_kinematics(q[0]), q[0])
    assert one.q.shape == (6,) and one.status == qvgen.Status.solved
    far = ns.inverse_kinematics_near(np.array([1, 0, 0, 0, np.inf, 0, 0]), q[0])
    assert far.status == qvgen.Status.invalid and np.isnan(far.q).all()


def test_a_path_is_followed(planar):
    time = np.linspace(0, 1, 400)[:, None]
    q = np.array([0.2, 0.8, -0.5]) + np.array([9, 0.5, -7]) * time  # more than a turn
    poses = planar.forward_kinematics(q)
    poses[200, 4] = np.nan  # the seed of the next is the last one found
    found = planar.inverse_kinematics_near(poses, q[0], path=True)
    assert np.isnan(found.q[200]).all()
    np.testing.assert_allclose(np.delete(found.q, 200, 0), np.delete(q, 200, 0), atol=1e-9)
    alone = planar.inverse_kinematics_near(poses, q[0])
    assert np.abs(alone.q[-1] - q[-1]).max() > 1  # without `path` every row has the same seed
    with pytest.raises(ValueError, match="one seed"):
        planar.inverse_kinematics_near(poses, q, path=True)
    assert planar.inverse_kinematics_near(poses[:0], q[:0]).q.shape == (0, 3)


def test_limits_near_a_seed(ns, rows):
    q = rows(ns)
    poses = ns.forward_kinematics(q)
    free = ns.inverse_kinematics_near(poses, q + 0.01)
    lower, upper = np.full(6, -1.0), np.full(6, 1.3)
    inside = ((free.q >= lower) & (free.q <= upper)).all(axis=1)
    assert 0 < inside.sum() < 50
    found = ns.inverse_kinematics_near(poses, q + 0.01, limits=(lower, upper))
    np.testing.assert_array_equal(found.q[inside], free.q[inside])
    assert np.isnan(found.q[~inside]).all() and (found.status[~inside] == qvgen.Status.unreachable).all()
    with pytest.raises(ValueError, match="limits: neither None"):
        ns.inverse_kinematics_near(poses, q, limits=3)


def test_less_than_a_pose(arm, rows):
    q = rows(arm)
    poses = arm.forward_kinematics(q)
    axis = arm.homogeneous_transform(q)[:, :3, :3] @ axis_of(arm)
    for target in (axis, poses):
        found = arm.inverse_kinematics(target, q)
        assert found.q.shape == (50, found.branch.shape[1], 2) and solved(found)
        np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)
    away = arm.inverse_kinematics(poses[0] + [0, 0, 0, 0, 0, 0, 0.1])
    assert away.status == qvgen.Status.unreachable and away.count == 0
    with pytest.raises(ValueError, match=r"target has the shape \(6,\)"):
        arm.inverse_kinematics(np.zeros(6))
    for target in (axis, poses):
        near = arm.inverse_kinematics_near(target, q + 0.01)
        assert solved(near)
        np.testing.assert_allclose(near.q, q, atol=1e-9)


def axis_of(arm):
    """The axis of the tool whose direction is asked for: the one whose solution is the robot's own joints."""
    q = np.full(arm.dof, 0.3)
    turned = arm.homogeneous_transform(q)[:3, :3]
    distance = [np.abs(arm.inverse_kinematics(turned @ axis, q).q[0] - q).max() for axis in np.eye(3)]
    return np.eye(3)[np.argmin(distance)]


def test_position_and_turn(scara, rows):
    q = rows(scara)
    poses = scara.forward_kinematics(q)
    at_zero = scara.homogeneous_transform(np.zeros(4))[:3, :3]
    turned = scara.homogeneous_transform(q)[:, :3, :3] @ at_zero.T
    yaw = np.arctan2(turned[:, 1, 0], turned[:, 0, 0])
    for target in (np.column_stack([poses[:, 4:], yaw]), poses):
        np.testing.assert_allclose(scara.inverse_kinematics(target, q).q[:, 0], q, atol=1e-9)


def test_position_and_pitch(desk_arm, rows):
    q = rows(desk_arm)
    poses = desk_arm.forward_kinematics(q)
    pitch = np.pi / 2 + q[:, 1] + q[:, 2] + q[:, 3]
    for target in (np.column_stack([poses[:, 4:], pitch]), poses):
        found = desk_arm.inverse_kinematics_given_roll(target, q[:, 4], q)
        assert solved(found)
        np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)
    down = desk_arm.inverse_kinematics_given_roll([0.2, 0.1, 0, np.pi], 0.3)
    assert down.count == 4
    approach = desk_arm.homogeneous_transform(down.q[:4])[:, :3, 0]
    np.testing.assert_allclose(approach, np.tile([0, 0, -1], (4, 1)), atol=1e-12)


def test_position_and_inclination(tmp_path, rows):
    keys = ("position_and_pitch", "position_and_inclination"), ('given = "roll"', ""), ('name = "desk_arm"', 'name = "level_arm"')
    text = pathlib.Path(__file__).with_name("desk_arm.toml").read_text()
    for old, new in keys:
        text = text.replace(old, new)
    file = tmp_path / "level_arm.toml"
    file.write_text(text)
    arm = qvgen.load(file, "--only", "kinematics,inverse")
    q = rows(arm)
    up = arm.homogeneous_transform(q)[:, 2, :3]
    poses = arm.forward_kinematics(q)
    for target in (np.column_stack([poses[:, 4:], up]), poses):
        found = arm.inverse_kinematics(target, q)
        assert solved(found)
        np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)


def test_position_and_direction_with_a_given_joint(tmp_path, rows):
    file = tmp_path / "torch_arm.toml"
    text = (pathlib.Path(__file__).parents[2] / "generator/robots/puma560.toml").read_text()
    keys = 'task = "position_and_direction"\ntool_axis = "+z"\n'
    file.write_text(keys + text.replace('"puma560"', '"torch_arm"', 1))
    arm = qvgen.load(file, "--only", "kinematics,inverse")
    q = rows(arm)
    transforms = arm.homogeneous_transform(q)
    target = np.hstack([transforms[:, :3, 3], transforms[:, :3, 2]])
    found = arm.inverse_kinematics_given_theta6(target, q[:, 5], q)
    assert solved(found)
    np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)
    others = arm.inverse_kinematics_given_theta6(target, q[:, 5] + 0.5, q)   # the last joint turns about the axis
    np.testing.assert_allclose(others.q[:, 0, :5], q[:, :5], atol=1e-9)
    none = arm.inverse_kinematics_given_theta6(target[0], np.nan)
    assert none.count == 0 and none.status == qvgen.Status.invalid


def test_seven_joints(iiwa14, rows):
    q = rows(iiwa14)
    poses = iiwa14.forward_kinematics(q)
    found = iiwa14.inverse_kinematics_given_theta3(poses, q[:, 2], q)
    assert found.q.shape == (50, 8, 7) and solved(found)
    np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)
    near = iiwa14.inverse_kinematics_near_given_theta3(poses, q[:, 2], q + 0.01)
    np.testing.assert_allclose(near.q, q, atol=1e-9)


def test_arm_angle(iiwa14, rows):
    q = rows(iiwa14)
    poses = iiwa14.forward_kinematics(q)
    for reference in ("conventional", "stereographic"):
        psi = iiwa14.arm_angle(q, reference=reference)
        assert psi.shape == (50,) and (np.abs(psi) <= np.pi).all()
        found = iiwa14.inverse_kinematics_arm_angle(poses, psi, q, reference=reference)
        assert solved(found) and (found.count == 8).all()
        np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)
        unsorted = iiwa14.inverse_kinematics_arm_angle(poses[0], psi[0], reference=reference)
        assert_poses(iiwa14, qvgen.Solutions(*(field[None] for field in unsorted)), poses[:1])
    with pytest.raises(ValueError, match="reference: neither"):
        iiwa14.arm_angle(q, reference="elbow")


def test_seven_joints_within_limits(iiwa14, rows):
    lower, upper = np.full(7, -2.0), np.full(7, 2.0)
    q = rows(iiwa14)
    poses = iiwa14.forward_kinematics(q)
    for found in (iiwa14.inverse_kinematics(poses, limits=(lower, upper)),
                  iiwa14.inverse_kinematics(poses, q, limits=(lower, upper))):
        assert (found.count > 0).all()
        assert_poses(iiwa14, found, poses)
        assert (((found.q >= lower) & (found.q <= upper)) | np.isnan(found.q)).all()
    np.testing.assert_allclose(found.q[:, 0], q, atol=1e-7)
    with pytest.raises(ValueError, match="limits"):
        iiwa14.inverse_kinematics(poses, limits=None)


def test_elimination(crx10ia, rows):
    q = rows(crx10ia)
    found = crx10ia.inverse_kinematics(crx10ia.forward_kinematics(q), q)
    assert found.q.shape == (50, 16, 6)
    np.testing.assert_allclose(found.q[:, 0], q, atol=1e-7)


def test_with_a_joint_given(planar, rows):
    q = rows(planar)
    poses = planar.forward_kinematics(q)
    for target in (poses, poses[:, 4:]):  # the orientation follows
        found = planar.inverse_kinematics_given_theta3(target, q[:, 2], q)
        assert solved(found)
        np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)
    same = planar.inverse_kinematics_given_theta3(poses, q[7, 2])
    for i in range(50):
        np.testing.assert_array_equal(rows_of(same, i)[:, 2], np.full(same.count[i], q[7, 2]))
    near = planar.inverse_kinematics_near_given_theta3(poses, q[:, 2], q + 0.01)
    np.testing.assert_allclose(near.q, q, atol=1e-9)
    limited = planar.inverse_kinematics_given_theta3(poses[0], q[0, 2], q[0], limits=(q[0] - 0.1, q[0] + 0.1))
    assert limited.count == 1
    with pytest.raises(ValueError, match="batches of 50 and of 3 rows"):
        planar.inverse_kinematics_given_theta3(poses, [1, 2, 3])


def test_in_motors(bevel_arm, rows):
    q = rows(bevel_arm)
    poses = bevel_arm.forward_kinematics(q)
    found = bevel_arm.inverse_kinematics(poses, q)
    assert solved(found)
    np.testing.assert_allclose(found.q[:, 0], q, atol=1e-8)
    near = bevel_arm.inverse_kinematics_near(poses, q + 0.01)
    np.testing.assert_allclose(near.q, q, atol=1e-8)
    # Orders go by ways whose whole turns are those of joints.
    seeds = q + rows(bevel_arm)
    best = qvgen.metrics.best(bevel_arm.inverse_kinematics(poses), qvgen.metrics.LargestJoint(), seeds, bevel_arm.turns_of_motors)
    matrix = np.array(bevel_arm.turns_of_motors.joints_by_motors)
    for row, seed, all_rows in zip(best, seeds, bevel_arm.inverse_kinematics(poses).q):
        ways = [np.linalg.solve(matrix, np.remainder(matrix @ (each - seed) + np.pi, 2 * np.pi) - np.pi)
                for each in (row, *all_rows[np.isfinite(all_rows[:, 0])])]
        assert np.abs(ways[0]).max() <= np.abs(ways[1:]).max(axis=1).min() + 1e-12
    # Turns of joints move two motors: their representatives stand whole turns of the tilt and the roll apart.
    lower, upper = q[0] - 13, q[0] + 13
    turns = bevel_arm.inverse_kinematics(poses[0], limits=(lower, upper))
    assert turns.count > 1000 and ((turns.q >= lower) & (turns.q <= upper)).all()
    reached = bevel_arm.forward_kinematics(turns.q)
    np.testing.assert_allclose(np.abs(reached[:, :4] @ poses[0, :4]), 1, atol=1e-9)
    np.testing.assert_allclose(reached[:, 4:], np.tile(poses[0, 4:], (turns.count, 1)), atol=1e-9)
    assert len(np.unique(turns.q.round(6), axis=0)) == turns.count


def test_with_several_joints_given(gantry, rows):
    q = rows(gantry)
    poses = gantry.forward_kinematics(q)
    found = gantry.inverse_kinematics_given_gx_gz_flange(poses, q[:, [0, 1, 8]], q)
    assert solved(found)
    np.testing.assert_allclose(found.q[:, 0], q, atol=1e-8)
    near = gantry.inverse_kinematics_near_given_gx_gz_flange(poses, q[:, [0, 1, 8]], q + 0.01)
    np.testing.assert_allclose(near.q, q, atol=1e-8)


def test_joints_within_limits_have_a_row_where_one_is_free(ns, rows):
    q = rows(ns)
    q[:, 4] = 0  # axes 4 and 6 are one line
    poses = ns.forward_kinematics(q)
    for n in range(len(q)):
        limits = (q[n] - 0.05, q[n] + 0.05)
        for seed in (None, np.zeros(6)):
            found = ns.inverse_kinematics(poses[n], seed, limits=limits)
            assert found.status == qvgen.Status.singular and found.count > 0
            inside = found.q[:found.count]
            assert ((inside >= limits[0]) & (inside <= limits[1])).all()
            reached = ns.forward_kinematics(inside)
            np.testing.assert_allclose(np.abs(reached[:, :4] @ poses[n, :4]), 1, atol=1e-9)
            np.testing.assert_allclose(reached[:, 4:], np.tile(poses[n, 4:], (found.count, 1)), atol=1e-9)


def test_nearest_pose(scara, rows):
    q = rows(scara)
    poses = scara.forward_kinematics(q)
    found = scara.nearest_pose(poses, q + 0.01)
    assert found.q.shape == (50, 16, scara.dof) and (found.status == qvgen.Status.solved).all()
    np.testing.assert_allclose(scara.forward_kinematics(found.q[:, 0]), poses, atol=1e-9)
    # A tilt, which a SCARA cannot follow, stays; the position does not suffer if it comes first.
    tilt = np.array([np.cos(0.1), np.sin(0.1), 0, 0])
    tilted = poses[0].copy()
    w, x, y, z = tilted[:4]
    tilted[:4] = [tilt[0] * w - tilt[1] * x, tilt[0] * x + tilt[1] * w, tilt[0] * y - tilt[1] * z, tilt[0] * z + tilt[1] * y]
    one = scara.nearest_pose(tilted, prefer="position", limits=(q[0] - 0.1, q[0] + 0.1))
    assert one.status == qvgen.Status.unreachable
    np.testing.assert_allclose(one.q[0], q[0], atol=1e-6)
    np.testing.assert_allclose([one.position_error[0], one.orientation_error[0]], [0, 0.2], atol=1e-8)
    assert np.isnan(one.q[one.count:]).all() and np.isnan(one.position_error[one.count:]).all()
    bad = poses.copy()
    bad[3, 5] = np.nan
    assert (scara.nearest_pose(bad, q, starts=0).status == qvgen.Status.invalid).nonzero()[0].tolist() == [3]
    with pytest.raises(ValueError, match="prefer: neither"):
        scara.nearest_pose(poses, prefer="speed")
