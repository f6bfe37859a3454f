# SPDX-License-Identifier: MIT
"""Configurations in Pinocchio and MuJoCo: what these compute of them is what the robot's own functions say."""

import types

import numpy as np
import pytest

import qvgen
from qvgen import _peers, interop

INERTIAL = ('<inertial><origin xyz="0.1 0 0"/><mass value="2"/>'
            '<inertia ixx="1" iyy="1.2" izz="1.5" ixy="0.1" ixz="0" iyz="0"/></inertial>')
JOINT = ('<joint name="{0}" type="{3}"><parent link="{1}"/><child link="{2}"/><origin xyz="0.2 0.3 0.1" rpy="0.3 0 0"/>'
         '<axis xyz="{4}"/><limit lower="-9" upper="9" velocity="9" effort="9"/></joint>')
URDF = ('<robot name="walker">' + "".join(f'<link name="{name}">{INERTIAL}</link>' for name in ("body", "wheel", "arm", "hand"))
        + JOINT.format("z_wheel", "body", "wheel", "continuous", "0 1 0") + JOINT.format("lift", "body", "arm", "prismatic", "0 0 1")
        + JOINT.format("wrist", "arm", "hand", "revolute", "1 0 0") + "</robot>")
BODY = ('<inertial pos="0.1 0 0" mass="2" fullinertia="1 1.2 1.5 0.1 0 0"/>')
MJCF = ('<mujoco model="walker"><compiler angle="radian"/><worldbody><body name="other"><joint name="door" type="hinge"/>' + BODY
        + '</body><body name="body"><freejoint/>' + BODY
        + f'<body name="arm" pos="0.2 0.3 0.1"><joint name="lift" type="slide" axis="0 0 1"/>{BODY}'
        + f'<body name="hand" pos="0.1 0 0"><joint name="wrist" axis="1 0 0"/>{BODY}</body></body>'
        + f'<body name="wheel" pos="0 0.3 0"><joint name="z_wheel" axis="0 1 0"/>{BODY}</body></body></worldbody></mujoco>')


@pytest.fixture(scope="module")
def floating(tmp_path_factory):
    """A body that floats, with a wheel, and a slide that carries a turning hand."""
    pytest.importorskip("pinocchio")  # before the robot is made
    description = tmp_path_factory.mktemp("peers") / "walker.urdf"
    description.write_text(URDF)
    return qvgen.load(description, "--only", "dynamics", floating=True)


def motions(robot, count=6):
    random = np.random.default_rng(11)
    floats = hasattr(robot, "velocity_size")
    q = random.uniform(-2, 2, (count, len(robot.joint_names) + 7 * floats))
    if floats:
        q[:, :4] /= np.linalg.norm(q[:, :4], axis=1)[:, None]
    return q, random.uniform(-1, 1, (count, len(robot.joint_names) + 6 * floats))


def test_pinocchio(floating):
    pin = pytest.importorskip("pinocchio")
    model = pin.buildModelFromXML(URDF, pin.JointModelFreeFlyer())
    data, to = model.createData(), interop.pinocchio(floating, model)
    q, qd = motions(floating)
    x, v = to.to_configuration(q), to.to_velocity(q, qd)
    assert x.shape == (6, model.nq) and model.nq == 7 + 4  # the wheel is a cosine and a sine
    np.testing.assert_allclose(to.from_configuration(x), q, atol=1e-14)
    np.testing.assert_array_equal(to.from_velocity(q, v), qd)
    for i in range(len(q)):
        pin.computeKineticEnergy(model, data, x[i], v[i])
        assert abs(data.kinetic_energy - floating.kinetic_energy(q[i], qd[i])) < 1e-12
        model.gravity.linear = np.array([0, 0, -9.80665])
        wanted = floating.inverse_dynamics(q[i], qd[i], np.zeros(9))
        torque = pin.rnea(model, data, x[i], v[i], np.zeros(model.nv))
        np.testing.assert_allclose(to.from_velocity(q[i], torque), wanted, atol=1e-11)


def test_mujoco(tmp_path):
    mj = pytest.importorskip("mujoco")
    description = tmp_path / "walker.xml"
    own = MJCF.replace(MJCF[MJCF.index('<body name="other">'):MJCF.index('<body name="body">')], "")
    description.write_text(own)
    robot = qvgen.load(description, "--only", "dynamics", floating=True)
    model = mj.MjModel.from_xml_string(MJCF)  # with a door that the robot does not have
    data, to = mj.MjData(model), interop.mujoco(robot, model)
    q, qd = motions(robot)
    x, v = to.to_configuration(q), to.to_velocity(q, qd)
    np.testing.assert_allclose(to.from_configuration(x), q, atol=1e-14)
    np.testing.assert_allclose(to.from_velocity(q, v), qd, atol=1e-14)
    for i in range(len(q)):
        data.qpos, data.qvel = x[i], v[i]
        mj.mj_forward(model, data)
        mj.mj_energyVel(model, data)
        assert abs(data.energy[1] - robot.kinetic_energy(q[i], qd[i])) < 1e-12
        # A step of the model's own integration is a step of the robot's.
        ahead = x[i].copy()
        mj.mj_integratePos(model, ahead, v[i], 0.1)
        np.testing.assert_allclose(to.from_configuration(ahead)[4:7], q[i, 4:7] + 0.1 * v[i, 1:4], atol=1e-14)
        np.testing.assert_allclose(to.from_configuration(ahead)[7:], q[i, 7:] + 0.1 * qd[i, 6:], atol=1e-14)


def test_an_arm_whose_base_is_fixed(arm):
    mj = pytest.importorskip("mujoco")
    pin = pytest.importorskip("pinocchio")
    from conftest import URDF as file
    model, q = pin.buildModelFromUrdf(str(file)), np.random.default_rng(5).uniform(-1, 1, (2, 3, arm.dof))
    to = interop.pinocchio(arm, model)
    np.testing.assert_allclose(to.from_configuration(to.to_configuration(q)), q, atol=1e-15)
    data = model.createData()
    masses = [pin.crba(model, data, to.to_configuration(row)) for row in q[0]]
    order = [joint.v for joint in to._joints]
    for mass, row in zip(masses, q[0]):
        mass = np.triu(mass) + np.triu(mass, 1).T
        np.testing.assert_allclose(mass[np.ix_(order, order)], arm.mass_matrix(row), atol=1e-6)  # 1.5708 is a right angle here
    to = interop.mujoco(arm, mj.MjModel.from_xml_string(file.read_text()))
    np.testing.assert_array_equal(to.from_configuration(to.to_configuration(q)), q)


def stand_in(names=("lift",)):
    joints = {"lift_joint": _peers._Joint(7, 6)}
    return types.SimpleNamespace(joint_names=list(names)), joints


def test_names_that_differ():
    robot, joints = stand_in()
    with pytest.raises(ValueError, match="no joint lift that turns or slides; it has lift_joint; names={'lift': ...} says"):
        _peers._matched(robot, joints, None)
    assert _peers._matched(robot, joints, {"lift": "lift_joint"}) == [joints["lift_joint"]]


def test_what_is_wrong_is_said():
    robot, joints = stand_in()
    fixed = _peers.Conversion(robot, list(joints.values()), None, np.zeros(8), 7)
    with pytest.raises(ValueError, match=r"q has the shape \(2,\); its last axis must be 1"):
        fixed.to_configuration([1, 2])
    robot.velocity_size = 7
    with pytest.raises(ValueError, match="the robot's base floats, the model's does not"):
        _peers.Conversion(robot, list(joints.values()), None, np.zeros(8), 7)
