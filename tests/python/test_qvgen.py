# SPDX-License-Identifier: MIT
"""Shared parts of the modules of robots: forward kinematics, Jacobians and dynamics."""

import pathlib
import types

import numpy as np
import pytest

import qvgen
from qvgen import _show

HERE = pathlib.Path(__file__).resolve().parent
POINTS = 50


def rotation(quaternion):
    w, x, y, z = quaternion
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def test_pose_and_transform_agree(ns, arm, rows):
    for robot in (ns, arm):
        q = rows(robot)
        for pose, matrix in zip(robot.forward_kinematics(q), robot.homogeneous_transform(q)):
            np.testing.assert_allclose(rotation(pose[:4]), matrix[:3, :3], atol=1e-14)
            np.testing.assert_allclose(pose[4:], matrix[:3, 3], atol=1e-14)
            np.testing.assert_array_equal(matrix[3], [0, 0, 0, 1])


def test_a_batch_is_its_rows(ns, arm, rows):
    for robot in (ns, arm):
        q, qd = rows(robot), rows(robot, seed=2)
        np.testing.assert_array_equal(robot.jacobian(q), [robot.jacobian(row) for row in q])
        np.testing.assert_array_equal(robot.velocity(q, qd[0]), [robot.velocity(row, qd[0]) for row in q])
        assert robot.jacobian(q[:0]).shape == (0, 6, robot.dof)


def test_jacobian_is_the_derivative(ns, rows):
    step = 1e-6
    q = rows(ns, 5)
    for k in range(ns.dof):
        dq = step * np.eye(ns.dof)[k]
        slope = (ns.forward_kinematics(q + dq) - ns.forward_kinematics(q - dq))[:, 4:] / (2 * step)
        np.testing.assert_allclose(ns.jacobian(q)[:, :3, k], slope, atol=1e-8)


def test_dynamics(arm, rows):
    q, qd, qdd = rows(arm), rows(arm, seed=2), rows(arm, seed=3)
    torque = arm.inverse_dynamics(q, qd, qdd)
    np.testing.assert_allclose(arm.forward_dynamics(q, qd, torque), qdd, atol=1e-9)
    still = arm.inverse_dynamics(q, qd * 0, qdd, gravity=0)
    np.testing.assert_allclose(still, np.einsum("nik,nk->ni", arm.mass_matrix(q), qdd), atol=1e-12)
    energy = 0.5 * np.einsum("ni,nik,nk->n", qd, arm.mass_matrix(q), qd)
    np.testing.assert_allclose(arm.kinetic_energy(q, qd), energy, atol=1e-12)


def test_functions_of_several_results(ns, arm, rows):
    for robot in (ns, arm):
        q = rows(robot)
        both = robot.forward_kinematics_and_jacobian(q)
        np.testing.assert_allclose(both.transform, robot.homogeneous_transform(q), atol=1e-14)
        np.testing.assert_allclose(both.jacobian, robot.jacobian(q), atol=1e-14)
        one = robot.forward_kinematics_and_jacobian(q[3])
        np.testing.assert_array_equal(one.jacobian, both.jacobian[3])
    single = ns.forward_kinematics_and_jacobian(rows(ns).astype(np.float32))
    assert single.transform.dtype == single.jacobian.dtype == np.float32


def test_derivatives_of_dynamics(arm, rows):
    q, qd, qdd = rows(arm), rows(arm, seed=2), rows(arm, seed=3)
    torque, by_position, by_rate = arm.inverse_dynamics_derivatives(q, qd, qdd, gravity=3.7)
    np.testing.assert_allclose(torque, arm.inverse_dynamics(q, qd, qdd, gravity=3.7), atol=1e-12)
    for k, step in enumerate(1e-6 * np.eye(arm.dof)):
        slope = (arm.inverse_dynamics(q + step, qd, qdd, gravity=3.7) - arm.inverse_dynamics(q - step, qd, qdd, gravity=3.7)) / 2e-6
        np.testing.assert_allclose(by_position[:, :, k], slope, atol=1e-7)
        slope = (arm.inverse_dynamics(q, qd + step, qdd) - arm.inverse_dynamics(q, qd - step, qdd)) / 2e-6
        np.testing.assert_allclose(by_rate[:, :, k], slope, atol=1e-7)


def test_gravity_and_loads_of_any_direction(arm, rows):
    q, qd, qdd = rows(arm), rows(arm, seed=2), rows(arm, seed=3)
    fall = [0, 0, -1.62]
    np.testing.assert_allclose(arm.inverse_dynamics_with_gravity_vector(q, qd, qdd, fall),
                               arm.inverse_dynamics(q, qd, qdd, gravity=1.62), atol=1e-12)
    np.testing.assert_allclose(arm.gravity_torque_with_gravity_vector(q, fall), arm.gravity_torque(q, gravity=1.62),
                               atol=1e-12)
    np.testing.assert_allclose(arm.potential_energy_with_gravity_vector(q, fall),
                               arm.potential_energy(q, gravity=1.62), atol=1e-12)
    fall, wrench = [0.3, -2, 5], np.arange(6.0)
    loaded = arm.inverse_dynamics_with_wrench(q, qd, qdd, fall, wrench)
    carried = np.einsum("nji,j->ni", arm.jacobian(q), wrench)
    np.testing.assert_allclose(loaded, arm.inverse_dynamics_with_gravity_vector(q, qd, qdd, fall) - carried, atol=1e-12)
    np.testing.assert_allclose(arm.forward_dynamics_with_wrench(q, qd, loaded, fall, wrench), qdd, atol=1e-9)
    np.testing.assert_allclose(arm.forward_dynamics_with_gravity_vector(q, qd, loaded + carried, fall), qdd, atol=1e-9)


def test_regressor(arm, rows):
    """Rows of Y at other places tell the same base parameters, without drives: those of the friction are taken off."""
    q, qd, qdd = rows(arm), rows(arm, seed=2), rows(arm, seed=3)
    y = arm.regressor(q, qd, qdd)
    assert y.shape == (50, 2, len(arm.base_parameter_names))
    still = arm.inverse_dynamics(q, qd * 0, qdd)  # no rates: no friction
    b, *_ = np.linalg.lstsq(arm.regressor(q, qd * 0, qdd).reshape(100, -1), still.ravel(), rcond=None)
    np.testing.assert_allclose(arm.regressor(q, qd * 0, qdd) @ b, still, atol=1e-9)
    np.testing.assert_allclose(arm.regressor(q, qd, qdd * 0, gravity=0) @ b, arm.coriolis_torque(q, qd), atol=1e-9)


def test_points_and_singular_places(ns, rows):
    q = rows(ns)
    np.testing.assert_allclose(ns.jacobian_at(q, [0, 0, 0]), ns.jacobian(q), atol=1e-14)
    point = np.array([0.1, -0.2, 0.3])
    arm_of_point = ns.homogeneous_transform(q)[:, :3, :3] @ point
    jacobian = ns.jacobian(q)
    moved = jacobian[:, :3] + np.cross(jacobian[:, 3:], arm_of_point[:, :, None], axisa=1, axisb=1, axisc=1)
    np.testing.assert_allclose(ns.jacobian_at(q, point)[:, :3], moved, atol=1e-12)
    measures = ns.singularity_measures(q)
    assert measures.shape == (50, len(ns.singularity_names)) and "wrist" in ns.singularity_names
    assert (np.abs(measures) > 1e-6).all() and (np.abs(np.linalg.det(jacobian)) > 1e-9).all()
    q[:, 4] = 0
    np.testing.assert_allclose(ns.singularity_measures(q)[:, ns.singularity_names.index("wrist")], 0, atol=1e-15)
    np.testing.assert_allclose(np.linalg.det(ns.jacobian(q)), 0, atol=1e-14)


def test_limits_of_the_description(ns, arm):
    assert arm.velocity_limits == [2, 3] and arm.effort_limits == [10, 7.5]
    assert ns.velocity_limits == ns.effort_limits == [float("inf")] * 6  # it has none


def test_constants_by_name(ns, rows):
    assert set(ns.default_geometry) == {"h1", "d2"}
    q = rows(ns, 1)[0]
    higher = ns.default_geometry["h1"] + 1
    difference = ns.forward_kinematics(q, geometry={"h1": higher}) - ns.forward_kinematics(q)
    np.testing.assert_allclose(difference, [0, 0, 0, 0, 0, 0, 1], atol=1e-14)
    with pytest.raises(ValueError, match="geometry has no l9"):
        ns.forward_kinematics(q, geometry={"l9": 1})


def test_out(ns, rows):
    q = rows(ns)
    out = np.empty((POINTS, 6, 6))
    assert ns.jacobian(q, out=out) is out
    np.testing.assert_array_equal(out, ns.jacobian(q))
    for wrong in (np.empty((POINTS, 6, 5)), np.empty((6, 6, POINTS)).T, np.empty((POINTS, 6, 6), order="F")):
        with pytest.raises(ValueError, match="out must be"):
            ns.jacobian(q, out=wrong)
    with pytest.raises(TypeError, match="not an array of float64"):
        ns.jacobian(q, out=np.empty((POINTS, 6, 6), dtype=np.float32))
    with pytest.raises(TypeError, match="not an array of float32"):
        ns.jacobian(q.astype(np.float32), out=out)


def test_single_precision(ns, arm, rows):
    q, qd = rows(ns).astype(np.float32), rows(ns, seed=2).astype(np.float32)
    for single, double in ((ns.forward_kinematics(q), ns.forward_kinematics(q.astype(float))),
                           (ns.homogeneous_transform(q), ns.homogeneous_transform(q.astype(float))),
                           (ns.velocity(q, qd), ns.velocity(q.astype(float), qd.astype(float)))):
        assert single.dtype == np.float32 and double.dtype == np.float64
        np.testing.assert_allclose(single, double, atol=1e-5)
        assert (single != double).any()  # it was computed in float32
    assert ns.velocity(q, qd.astype(float)).dtype == np.float64
    out = np.empty((POINTS, 7), dtype=np.float32)
    assert ns.forward_kinematics(q, geometry={"h1": 3}, out=out) is out
    np.testing.assert_allclose(out, ns.forward_kinematics(q.astype(float), geometry={"h1": 3}), atol=1e-5)
    q = rows(arm).astype(np.float32)
    torque = arm.gravity_torque(q, gravity=1.5)
    assert torque.dtype == np.float32 and arm.potential_energy(q).dtype == np.float32
    np.testing.assert_allclose(torque, arm.gravity_torque(q.astype(float), gravity=1.5), atol=1e-4)


def test_wrong_shapes_are_named(ns):
    with pytest.raises(ValueError, match=r"q has the shape \(5,\); it must be \(6,\)"):
        ns.jacobian(np.zeros(5))
    with pytest.raises(ValueError, match="batches of 2 and of 3 rows"):
        ns.velocity(np.zeros((2, 6)), np.zeros((3, 6)))
    with pytest.raises(TypeError, match="not an array of numbers"):
        ns.jacobian("elbow")


def test_what_is_there_and_what_is_not(ns, arm, planar):
    for robot in (ns, arm):
        for name, place in robot.functions.items():
            assert hasattr(robot, name) == (place == "here"), name
    assert "inverse_dynamics" in dir(arm) and "inverse_dynamics" not in dir(planar)
    assert "no mass" in planar.functions["dynamics"]
    with pytest.raises(AttributeError, match="planar_3r has no inverse_dynamics; .*no dynamics: .* no mass"):
        planar.inverse_dynamics
    with pytest.raises(AttributeError, match="ns has no forward_kinematic; it has forward_kinematics"):
        ns.forward_kinematic
    assert "puma560" in dir(qvgen.robots)
    with pytest.raises(AttributeError, match="there is no robot"):
        qvgen.robots.elbow
    with pytest.raises(qvgen.BuildError, match="nowhere.toml"):
        qvgen.load("nowhere.toml")


def test_the_same_description_is_compiled_once(arm):
    assert qvgen.load(HERE.parent / "c/robots/urdf_arm.urdf").__file__ == arm.__file__


def test_limbs_of_joints_that_branch(tmp_path):
    joint = '[[joint]]\ntype = "revolute"\naxis = "+{}"\nvariable = "{}"\nlink = [{}, 0, 0]\n'
    tip = '[[tip]]\nname = "{}_hand"\njoint = "{}"\n'
    description = tmp_path / "two_arms.toml"
    description.write_text('name = "two_arms"\ntitle = "two arms"\n' + joint.format("z", "waist", 0.5)
                           + joint.format("y", "left", 0.3) + joint.format("x", "right", 0.2) + 'parent = "waist"\n'
                           + tip.format("left", "left") + tip.format("right", "right"))
    robot = qvgen.load(description, "--only", "kinematics,jacobian")
    assert robot.joint_names == ["waist", "left", "right"]
    assert list(robot.limbs) == ["left_hand", "right_hand"]
    limb = robot.limbs["right_hand"]
    assert limb.joint_names == ["waist", "right"] and limb is robot.limbs["right_hand"]
    np.testing.assert_allclose(limb.forward_kinematics([np.pi / 2, 0.3])[4:], [0, 0.7, 0], atol=1e-14)
    with pytest.raises(AttributeError, match="each limb has it"):
        robot.forward_kinematics
    left, right = _show._chains(robot, np.array([np.pi / 2, 0, 0.3]))
    np.testing.assert_allclose(left, [[0, 0, 0], [0, 0, 0], [0, 0.5, 0], [0, 0.8, 0]], atol=1e-14)
    np.testing.assert_allclose(right[-1], [0, 0.7, 0], atol=1e-14)
    floating = types.SimpleNamespace(functions={}, joint_names=robot.joint_names, limbs=robot.limbs, velocity_size=9)
    turn = [np.sqrt(0.5), 0, 0, np.sqrt(0.5)]  # a right angle about z
    moved = _show._chains(floating, np.array([*turn, 1, 2, 3, np.pi / 2, 0, 0.3]))[0]
    np.testing.assert_allclose(moved, [1, 2, 3] + left @ [[0, 1, 0], [-1, 0, 0], [0, 0, 1]], atol=1e-14)


def test_a_base_that_floats(tmp_path):
    inertial = ('<inertial><origin xyz="0.1 0 0"/><mass value="2"/>'
                '<inertia ixx="1" iyy="1.2" izz="1.5" ixy="0.1" ixz="0" iyz="0"/></inertial>')
    description = tmp_path / "satellite.urdf"
    description.write_text(f'<robot name="satellite"><link name="body">{inertial}</link><link name="arm">{inertial}</link>'
                           '<joint name="shoulder" type="continuous"><parent link="body"/><child link="arm"/>'
                           '<origin xyz="0 0.3 0"/><axis xyz="0 1 0"/></joint></robot>')
    robot = qvgen.load(description, "--only", "dynamics,mass", floating=True)
    assert (robot.dof, robot.velocity_size) == (1, 7)
    random = np.random.default_rng(3)
    q, qd, qdd = random.uniform(-1, 1, (5, 8)), random.uniform(-1, 1, (5, 7)), random.uniform(-1, 1, (5, 7))
    q[:, :4] /= np.linalg.norm(q[:, :4], axis=1)[:, None]
    torque = robot.inverse_dynamics(q, qd, qdd)
    np.testing.assert_allclose(robot.forward_dynamics(q, qd, torque), qdd, atol=1e-11)
    mass = robot.mass_matrix(q)
    parts = np.einsum("nij,nj->ni", mass, qdd) + robot.coriolis_torque(q, qd) + robot.gravity_torque(q)
    np.testing.assert_allclose(torque, parts, atol=1e-11)
    np.testing.assert_allclose(robot.momentum_matrix(q), mass[:, :6], atol=1e-13)
    np.testing.assert_allclose(robot.inverse_dynamics_with_gravity_vector(q, qd, qdd, [0, 0, -9.80665]), torque, atol=1e-13)
    weight = robot.gravity_torque_with_gravity_vector(q, [1, 2, 3])
    force = np.linalg.norm(weight[:, :3], axis=1)
    np.testing.assert_allclose(force, robot.total_mass() * np.sqrt(14), atol=1e-12)  # a force against the whole weight
    step = 1e-6 * qd
    change = robot.centre_of_mass(robot.integrated(q, step)) - robot.centre_of_mass(robot.integrated(q, -step))
    np.testing.assert_allclose(np.einsum("nij,nj->ni", robot.centre_of_mass_jacobian(q), qd), change / 2e-6, atol=1e-8)
    moved = robot.integrated(q, 0.1 * qd)
    np.testing.assert_allclose(robot.difference(q, moved), 0.1 * qd, atol=1e-14)
    with pytest.raises(ValueError, match="q has the shape"):
        robot.mass_matrix(np.zeros(1))


def test_what_the_readme_shows():
    lines = (HERE.parents[1] / "README.md").read_text().splitlines()
    begin = next(place for place, line in enumerate(lines) if line.startswith("    import numpy, qvgen"))
    end = next(place for place in range(begin, len(lines)) if lines[place] and lines[place][0] != " ")
    exec("\n".join(line[4:] for line in lines[begin:end]), {})
