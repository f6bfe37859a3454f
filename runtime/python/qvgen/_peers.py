# SPDX-License-Identifier: MIT
"""Configurations and velocities of a robot in the orders and notations of Pinocchio and MuJoCo, joints matched by their names.

                 floating base                 velocity of the base                         joints without limits
    qvgen        w x y z, metres               linear, angular, in the base's frame         one angle
    Pinocchio    metres, x y z w               as here                                      cosine and sine
    MuJoCo       metres, w x y z               linear in the world, angular in the base's   one angle
"""

import dataclasses
import difflib

import numpy as np


@dataclasses.dataclass(frozen=True)
class _Joint:
    """A joint of a peer's model: its places in configurations and velocities, and whether it is a cosine and a sine."""
    q: int
    v: int
    is_on_circle: bool = False


def _turned(quaternion, vectors, sign=1):
    """Vectors turned by quaternions w x y z, or back."""
    w, v = quaternion[..., :1], sign * quaternion[..., 1:]
    return vectors + 2 * np.cross(v, np.cross(v, vectors) + w * vectors)


def _rows(values, size, name):
    values = np.asarray(values, float)
    if values.ndim == 0 or values.shape[-1] != size:
        raise ValueError(f"{name} has the shape {values.shape}; its last axis must be {size}")
    return values


class Conversion:
    """Conversions between a robot and a peer's model of it; all take one row or a batch, any axes in front.

    Joints of the model that the robot has not keep the values of `rest` and rest themselves.
    """

    def __init__(self, robot, joints, base, rest, velocity_size):
        self._joints, self._base, self._rest, self._velocity_size = joints, base, rest, velocity_size
        self._floats = hasattr(robot, "velocity_size")
        self._dof = len(robot.joint_names)
        if self._floats and base is None:
            raise ValueError("the robot's base floats, the model's does not")

    def to_configuration(self, q):
        """The model's configuration of q: joints, behind the base's pose if the base floats."""
        q = _rows(q, self._dof + 7 * self._floats, "q")
        found = np.broadcast_to(self._rest, (*q.shape[:-1], len(self._rest))).copy()
        if self._floats:
            self._base.pack(found, q[..., :7])
        for joint, value in zip(self._joints, np.moveaxis(q[..., 7 * self._floats:], -1, 0)):
            if joint.is_on_circle:
                found[..., joint.q], found[..., joint.q + 1] = np.cos(value), np.sin(value)
            else:
                found[..., joint.q] = value
        return found

    def from_configuration(self, configuration):
        """q of the model's configuration; angles of joints that are a cosine and a sine are in [-pi, pi]."""
        given = _rows(configuration, len(self._rest), "configuration")
        values = [np.arctan2(given[..., joint.q + 1], given[..., joint.q]) if joint.is_on_circle else given[..., joint.q]
                  for joint in self._joints]
        joints = np.stack(values, axis=-1)
        return np.concatenate([self._base.unpack(given), joints], axis=-1) if self._floats else joints

    def to_velocity(self, q, qd):
        """The model's velocity of qd at q; the base's six in front if it floats."""
        q, qd = _rows(q, self._dof + 7 * self._floats, "q"), _rows(qd, self._dof + 6 * self._floats, "qd")
        front = np.broadcast_shapes(q.shape[:-1], qd.shape[:-1])
        found = np.zeros((*front, self._velocity_size))
        if self._floats:
            found[..., self._base.v:self._base.v + 6] = self._base.velocity(q, qd[..., :6], 1)
        found[..., [joint.v for joint in self._joints]] = qd[..., 6 * self._floats:]
        return found

    def from_velocity(self, q, velocity):
        """qd of the model's velocity at q, the robot's configuration."""
        q, given = _rows(q, self._dof + 7 * self._floats, "q"), _rows(velocity, self._velocity_size, "velocity")
        joints = given[..., [joint.v for joint in self._joints]]
        if not self._floats:
            return joints
        base = self._base.velocity(q, given[..., self._base.v:self._base.v + 6], -1)
        return np.concatenate([base, np.broadcast_to(joints, (*base.shape[:-1], self._dof))], axis=-1)


@dataclasses.dataclass(frozen=True)
class _Base:
    """A floating base in a peer's model, by its first places; `last` if the quaternion's w is the last of its four."""
    q: int
    v: int
    has_w_last: bool
    is_linear_in_world: bool

    def pack(self, found, pose):
        order = [1, 2, 3, 0] if self.has_w_last else [0, 1, 2, 3]
        found[..., self.q:self.q + 3] = pose[..., 4:]
        found[..., self.q + 3:self.q + 7] = pose[..., order]

    def unpack(self, given):
        order = [6, 3, 4, 5] if self.has_w_last else [3, 4, 5, 6]
        return given[..., [self.q + place for place in (*order, 0, 1, 2)]]

    def velocity(self, q, values, sign):
        if not self.is_linear_in_world:
            return np.broadcast_to(values, (*np.broadcast_shapes(q.shape[:-1], values.shape[:-1]), 6))
        linear = _turned(q[..., :4], values[..., :3], sign)
        return np.concatenate([linear, np.broadcast_to(values[..., 3:], linear.shape)], axis=-1)


def _matched(robot, joints, names):
    """The model's joint of each of the robot's; `names`: what the model calls those that have another name there."""
    found = []
    for own in robot.joint_names:
        name = (names or {}).get(own, own)
        if name not in joints:
            near = difflib.get_close_matches(name, joints, cutoff=0.6) or list(joints) or ["none"]
            raise ValueError(f"the model has no joint {name} that turns or slides; it has {', '.join(near)}; "
                             f"names={{{own!r}: ...}} says which one it is")
        found.append(joints[name])
    return found


def pinocchio(robot, model, *, names=None):
    """A Conversion to a pinocchio.Model, whose first joint is a free flyer if the robot's base floats.

    `names`: names of joints in the model, by the robot's, where they differ.
    """
    import pinocchio as pin
    joints, base = {}, None
    for name, joint in zip(list(model.names)[1:], list(model.joints)[1:]):
        if joint.nv == 1:
            joints[name] = _Joint(joint.idx_q, joint.idx_v, joint.nq == 2)
        elif joint.shortname() == "JointModelFreeFlyer":
            base = base or _Base(joint.idx_q, joint.idx_v, True, False)
    return Conversion(robot, _matched(robot, joints, names), base, pin.neutral(model), model.nv)


def mujoco(robot, model, *, names=None):
    """A Conversion to a mujoco.MjModel, whose first free joint is the robot's base if that floats.

    `names`: names of joints in the model, by the robot's, where they differ.
    """
    import mujoco as mj
    joints, base = {}, None
    for i in range(model.njnt):
        kind, q, v = mj.mjtJoint(int(model.jnt_type[i])), int(model.jnt_qposadr[i]), int(model.jnt_dofadr[i])
        if kind in (mj.mjtJoint.mjJNT_HINGE, mj.mjtJoint.mjJNT_SLIDE):
            joints[model.joint(i).name] = _Joint(q, v)
        elif kind == mj.mjtJoint.mjJNT_FREE:
            base = base or _Base(q, v, False, True)
    return Conversion(robot, _matched(robot, joints, names), base, np.array(model.qpos0), model.nv)
