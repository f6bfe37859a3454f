# SPDX-License-Identifier: MIT
"""Exact derivatives of a robot's functions by their arguments, made of what is generated; nothing is differentiated by steps.

    value, (by_q, by_qd, by_torque) = qvgen.derivatives.forward_dynamics(arm, q, qd, torque)

Each function takes a robot's module and arrays of rows, (n, dof), and returns the value, (n, ...), and for each argument its
derivative, the argument's axis last. CasADi, JAX and PyTorch get theirs from here (qvgen.interop).
"""

import numpy as np

__all__ = ["OF", "arguments_of"]


def _by_joints(arm, q):
    """Derivative of the Jacobian by the joints, (n, 6, dof, dof): its rate when one joint alone moves by one."""
    return np.stack([arm.jacobian_dot(q, np.broadcast_to(unit, q.shape)) for unit in np.eye(arm.dof)], axis=-1)


def forward_kinematics(arm, q):
    """Pose as w x y z and position; a quaternion turns by half its product with the angular velocity."""
    pose, jacobian = arm.forward_kinematics(q), arm.jacobian(q)
    w, vector = pose[:, :1, None], pose[:, 1:4, None]
    turn = jacobian[:, 3:]
    by_q = np.concatenate([-0.5 * (turn * vector).sum(1, keepdims=True),
                           0.5 * (w * turn + np.cross(turn, np.broadcast_to(vector, turn.shape), axis=1)), jacobian[:, :3]], axis=1)
    return pose, (by_q,)


def homogeneous_transform(arm, q):
    """Pose as a matrix; its columns turn with the angular velocity."""
    pose, jacobian = arm.homogeneous_transform(q), arm.jacobian(q)
    by_q = np.zeros((*pose.shape, arm.dof))
    by_q[:, :3, :3] = np.cross(jacobian[:, 3:, None, :], pose[:, :3, :3, None], axis=1)
    by_q[:, :3, 3] = jacobian[:, :3]
    return pose, (by_q,)


def jacobian(arm, q):
    """Jacobian of the tool in the world frame."""
    return arm.jacobian(q), (_by_joints(arm, q),)


def velocity(arm, q, qd):
    """Twist of the tool."""
    return arm.velocity(q, qd), (np.einsum("nikj,nk->nij", _by_joints(arm, q), qd), arm.jacobian(q))


def inverse_dynamics(arm, q, qd, qdd):
    """Joint forces for a motion."""
    _, by_q, by_qd = arm.inverse_dynamics_derivatives(q, qd, qdd)
    return arm.inverse_dynamics(q, qd, qdd), (by_q, by_qd, arm.mass_matrix(q))


def forward_dynamics(arm, q, qd, torque):
    """Joint accelerations; their derivatives solve the mass matrix, as the forces of the motion stay the same."""
    qdd = arm.forward_dynamics(q, qd, torque)
    _, by_q, by_qd = arm.inverse_dynamics_derivatives(q, qd, qdd)
    inverse = np.linalg.inv(arm.mass_matrix(q))
    return qdd, (-inverse @ by_q, -inverse @ by_qd, inverse)


def gravity_torque(arm, q):
    """Joint forces that hold the robot at rest."""
    still = np.zeros_like(q)
    _, by_q, _ = arm.inverse_dynamics_derivatives(q, still, still)
    return arm.gravity_torque(q), (by_q,)


# name of a function: itself, its arguments, the functions of a module that it needs
OF = {
    "forward_kinematics": (forward_kinematics, "q", "jacobian"),
    "homogeneous_transform": (homogeneous_transform, "q", "jacobian"),
    "jacobian": (jacobian, "q", "jacobian_dot"),
    "velocity": (velocity, "q qd", "jacobian_dot"),
    "inverse_dynamics": (inverse_dynamics, "q qd qdd", "inverse_dynamics_derivatives"),
    "forward_dynamics": (forward_dynamics, "q qd torque", "inverse_dynamics_derivatives"),
    "gravity_torque": (gravity_torque, "q", "inverse_dynamics_derivatives"),
}


def arguments_of(arm, name):
    """Names of the arguments of a function that has derivatives here; ValueError says which functions of a robot have."""
    there = [each for each, (_, _, needs) in OF.items() if arm.functions.get(each) == "here" and arm.functions.get(needs) == "here"]
    if name not in there:
        raise ValueError(f"{arm.__name__} has no derivatives of {name}; it has those of {', '.join(there)}"
                         + ("" if "inverse_dynamics" in there else "; those of dynamics need --only dynamics_derivatives in addition"))
    return OF[name][1].split()
