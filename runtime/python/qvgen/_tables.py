# SPDX-License-Identifier: MIT
"""Functions that a robot's module can have: their arguments, the shapes of their results and what they are.

Shapes are expressions of the robot's numbers (`dof`, `base_parameter_count`): the C is printed from them, and Python makes
arrays by them. A function that is added to a robot's C needs a line here.
"""

import re

POSE = "[w, x, y, z, px, py, pz]: unit quaternion and position, m"

# name: shape of a row, what it is
ARGUMENTS = {
    "q": ("dof", "joint positions, rad or m"),
    "qd": ("dof", "joint rates, rad/s or m/s"),
    "qdd": ("dof", "joint accelerations, rad/s^2 or m/s^2"),
    "torque": ("dof", "joint forces, N m or N"),
    "point": ("3", "a point that moves with the tool, in the tool frame, m"),
    "fall": ("3", "acceleration of free fall in the world frame, m/s^2"),
    "wrench": ("6", "force and moment on the tool from outside, in the world frame, N and N m"),
    "step": ("velocity_size", "a velocity times a time"),
    "start": ("7 + dof", "a configuration"),
    "goal": ("7 + dof", "a configuration"),
}
# Likewise of a robot whose base floats, in functions of dynamics.
FLOATING = {
    "q": ("7 + dof", "pose of the base in the world, w x y z, then metres, and joint positions, rad or m"),
    "qd": ("velocity_size",
           "velocity of the base in its own frame, linear, then angular, m/s and rad/s, and joint rates"),
    "qdd": ("velocity_size", "derivatives of the numbers in qd"),
    "torque": ("velocity_size", "force and moment on the base from outside, in its own frame, N and N m, and joint forces"),
}
AFTER_INERTIA = ("fall", "wrench")  # where they stand in C
# name: arguments, shape of a row of the result, a line of text
KINEMATICS = {
    "forward_kinematics": ("q", "7", f"Pose of the tool in the world frame, {POSE}."),
    "homogeneous_transform": ("q", "4, 4", "Pose of the tool in the world frame as a 4 x 4 matrix, m."),
    "jacobian": ("q", "6, dof", "Jacobian in the world frame at the tool, linear rows first."),
    "tool_jacobian": ("q", "6, dof", "Jacobian in the tool frame at the tool, linear rows first."),
    "jacobian_at": ("q point", "6, dof", "Jacobian in the world frame at a point of the tool."),
    "singularity_measures": ("q", "singularity_count",
                             "Factors of the Jacobian's determinant: the arm is singular where one is zero."),
    "jacobian_dot": ("q qd", "6, dof", "Derivative of the Jacobian by time."),
    "velocity": ("q qd", "6", "Twist of the tool in the world frame, m/s and rad/s, linear first."),
    "jacobian_dot_times_qd": ("q qd", "6", "The tool's acceleration at constant joint rates."),
    "geometry_jacobian": ("q", "6, geometry_error_count",
                          "Derivative of the tool's pose by shifts along and turns about x, y, z of each joint's frame, "
                          "then of the tool's; linear rows first."),
    "link_poses": ("q", "link_count, 4, 4", "Poses of all links in the world frame as 4 x 4 matrices, m."),
    "frame_poses": ("q", "frame_count, 4, 4", "Poses of all frames, as frame_names has them, m."),
    "forward_kinematics_and_jacobian": ("q", "transform 4, 4; jacobian 6, dof",
                                        "Pose of the tool as a 4 x 4 matrix, m, and the Jacobian in the world frame."),
}
# Functions of one frame, by what stands before its name.
OF_A_FRAME = {
    "forward_kinematics": ("q", "7", "Pose of the frame {} in the world frame, " + f"{POSE}."),
    "homogeneous_transform": ("q", "4, 4", "Pose of the frame {} in the world frame as a 4 x 4 matrix, m."),
    "jacobian": ("q", "6, dof", "Jacobian of the frame {} at its origin in the world frame, linear rows first."),
}
DYNAMICS = {
    "inverse_dynamics": ("q qd qdd", "dof", "Joint forces for a motion, N m or N."),
    "forward_dynamics": ("q qd torque", "dof", "Joint accelerations for joint forces."),
    "gravity_torque": ("q", "dof", "Joint forces that hold the robot at rest."),
    "coriolis_torque": ("q qd", "dof", "Joint forces of the joint rates alone, without friction."),
    "mass_matrix": ("q", "dof, dof", "M(q), symmetric."),
    "coriolis_matrix": ("q qd", "dof, dof", "C(q, qd) of Christoffel's symbols."),
    "momentum_matrix": ("q", "6, dof", "Momentum about the base's origin, in the base's frame, by velocities."),
    "kinetic_energy": ("q qd", "", "Kinetic energy, J."),
    "potential_energy": ("q", "", "Potential energy, J."),
    "inverse_dynamics_derivatives": ("q qd qdd", "torque dof; by_position dof, dof; by_rate dof, dof",
                                     "Joint forces for a motion, and their derivatives by q and qd; by qdd it is mass_matrix."),
    "regressor": ("q qd qdd", "dof, base_parameter_count",
                  "Y with inverse_dynamics = Y b, b the base parameters, without drives."),
    "regressor_with_drives": ("q qd qdd", "dof, identifiable_parameter_count",
                              "Y with inverse_dynamics = Y p, p the identifiable parameters of links and drives."),
    "centre_of_mass": ("q", "3", "Centre of mass of all links in the world frame, m."),
    "centre_of_mass_jacobian": ("q", "3, dof", "Derivatives of the centre of mass by the joints."),
    "inverse_dynamics_with_gravity_vector": ("q qd qdd fall", "dof", "Joint forces, gravity in any direction."),
    "inverse_dynamics_with_wrench": ("q qd qdd fall wrench", "dof", "Joint forces, with a load on the tool."),
    "gravity_torque_with_gravity_vector": ("q fall", "dof", "Joint forces at rest, gravity in any direction."),
    "forward_dynamics_with_gravity_vector": ("q qd torque fall", "dof", "Joint accelerations, gravity in any direction."),
    "forward_dynamics_with_wrench": ("q qd torque fall wrench", "dof", "Joint accelerations, with a load on the tool."),
    "potential_energy_with_gravity_vector": ("q fall", "", "Potential energy, J, gravity in any direction."),
}
WITH_GRAVITY = {"inverse_dynamics", "forward_dynamics", "gravity_torque", "potential_energy", "regressor",
                "regressor_with_drives", "inverse_dynamics_derivatives"}
# Functions of robots whose base floats, in C++.
OF_A_BASE = {
    "integrated": ("q step", "7 + dof", "The configuration that a step leads to."),
    "difference": ("start goal", "velocity_size", "The step from one configuration to another: integrated(start, step) is the goal."),
}
VELOCITY = {
    "inverse_velocity": ("Joint rates for a twist of the tool, damped near singularities; for more than six joints the smallest.", None),
    "inverse_velocity_scaled": ("The rates of inverse_velocity, all scaled by the largest factor up to 1 that brings them within limits.",
                                "they have to admit rest"),
    "inverse_velocity_within": ("The joint rates within limits whose twist is nearest to one; for more than six joints the smallest of those.",
                                "they need not admit rest"),
}
# name of a task of inverse kinematics: its length, what it is, its arguments in C with their places in a row, its type in C++
TASKS = {
    "pose": (7, POSE, {"orientation": "t", "position": "t + 4"}, "qvgen::Pose<double>"),
    "position": (3, "[px, py, pz]: position of the tool point, m", {"position": "t"}, "qvgen::Vector3<double>"),
    "position_and_direction": (6, "[px, py, pz, x, y, z]: position, m, and the direction of the tool's axis, a unit vector",
                               {"position": "t", "direction": "t + 3"}, "qvgen::PositionAndDirection<double>"),
    "position_and_yaw": (4, "[px, py, pz, yaw]: position, m, and turn from where the tool is with all joints at zero, rad",
                         {"position": "t", "yaw": "t[3]"}, "qvgen::PositionAndYaw<double>"),
    "position_and_pitch": (4, "[px, py, pz, pitch]: position, m, and angle of the tool's axis to the first joint's, rad",
                           {"position": "t", "pitch": "t[3]"}, "qvgen::PositionAndPitch<double>"),
    "position_and_inclination": (6, "[px, py, pz, x, y, z]: position, m, and the direction of the first joint's axis as the tool sees it, a unit vector",
                                 {"position": "t", "up": "t + 3"}, "qvgen::PositionAndInclination<double>"),
    "direction": (3, "[x, y, z]: direction of the tool's axis, a unit vector", {"direction": "t"}, "qvgen::Direction<double>"),
    "orientation": (4, "[w, x, y, z]: unit quaternion", {"orientation": "t"}, "Eigen::Quaternion<double>"),
}
ARM_ANGLE = ("arm_angle", "inverse_kinematics_arm_angle", "inverse_kinematics")


def entry_of(name):
    """Returns arguments, shape, text of a function of kinematics or dynamics and whether it is one of dynamics; None of any other."""
    if name in DYNAMICS:
        return *DYNAMICS[name], True
    if name in KINEMATICS:
        return *KINEMATICS[name], False
    match = re.fullmatch("(" + "|".join(OF_A_FRAME) + r")_of_(\w+)", name)
    if match is None:
        return None
    arguments, shape, line = OF_A_FRAME[match[1]]
    return arguments, shape, line.format(match[2]), False


def parts_of(shape):
    """The named parts of a result that has several, else one without a name: ["transform 4, 4", ...] as (name, shape)."""
    parts = [each.strip() for each in shape.split(";")]
    if len(parts) == 1:
        return [("", shape)]
    return [tuple(each.split(" ", 1)) for each in parts]


def sizes(shape, numbers):
    """A shape in numbers: "6, dof" is (6, 7) for seven joints."""
    return tuple(eval(each, {"__builtins__": {}}, numbers) for each in shape.split(", ")) if shape else ()
