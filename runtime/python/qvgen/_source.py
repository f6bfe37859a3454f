# SPDX-License-Identifier: MIT
"""The C++ source of a robot's module: its functions, those it has, handed to the templates of binding.h."""

import json
import re

from ._inverse_source import ARM_ANGLE_FUNCTIONS, POSE, arm_angle_source, inverse_source, nearest_pose_source
from ._velocity_source import velocity_source

# name: length of a row, its type in C++, what it is
ARGUMENTS = {
    "q": ("dof", "Joints", "joint positions, rad or m"),
    "qd": ("dof", "Joints", "joint rates, rad/s or m/s"),
    "qdd": ("dof", "Joints", "joint accelerations, rad/s^2 or m/s^2"),
    "torque": ("dof", "Joints", "joint forces, N m or N"),
    "point": ("3", "qvgen::Vector3<Scalar>", "a point that moves with the tool, in the tool frame, m"),
    "fall": ("3", "qvgen::Vector3<Scalar>", "acceleration of free fall in the world frame, m/s^2"),
    "wrench": ("6", "arm::Wrench<Scalar>", "force and moment on the tool from outside, in the world frame, N and N m"),
}
# Likewise of a robot whose base floats, in functions of dynamics.
FLOATING = {
    "q": ("7 + dof", "", "pose of the base in the world, w x y z, then metres, and joint positions, rad or m"),
    "qd": ("velocity_size", "arm::Velocity<Scalar>",
           "velocity of the base in its own frame, linear, then angular, m/s and rad/s, and joint rates"),
    "qdd": ("velocity_size", "arm::Velocity<Scalar>", "derivatives of the numbers in qd"),
    "torque": ("velocity_size", "arm::Velocity<Scalar>",
               "force and moment on the base from outside, in its own frame, N and N m, and joint forces"),
}
AFTER_INERTIA = ("fall", "wrench")  # where they stand in C++
# name: arguments, shape of a row of the result, a line of text
KINEMATICS = {
    "forward_kinematics": ("q", "7", f"Pose of the tool in the world frame, {POSE}."),
    "homogeneous_transform": ("q", "4, 4", "Pose of the tool in the world frame as a 4 x 4 matrix, m."),
    "jacobian": ("q", "6, arm::dof", "Jacobian in the world frame at the tool, linear rows first."),
    "tool_jacobian": ("q", "6, arm::dof", "Jacobian in the tool frame at the tool, linear rows first."),
    "jacobian_at": ("q point", "6, arm::dof", "Jacobian in the world frame at a point of the tool."),
    "singularity_measures": ("q", "arm::singularity_count",
                             "Factors of the Jacobian's determinant: the arm is singular where one is zero."),
    "jacobian_dot": ("q qd", "6, arm::dof", "Derivative of the Jacobian by time."),
    "velocity": ("q qd", "6", "Twist of the tool in the world frame, m/s and rad/s, linear first."),
    "jacobian_dot_times_qd": ("q qd", "6", "The tool's acceleration at constant joint rates."),
    "geometry_jacobian": ("q", "6, arm::geometry_error_count",
                          "Derivative of the tool's pose by shifts along and turns about x, y, z of each joint's frame, "
                          "then of the tool's; linear rows first."),
}
FRAMES = {
    "link_poses": ("q", "arm::link_count, 4, 4", "Poses of all links in the world frame as 4 x 4 matrices, m."),
    "frame_poses": ("q", "arm::frame_count, 4, 4", "Poses of all frames, as frame_names has them, m."),
}
# Functions of one frame, by what stands before its name.
OF_A_FRAME = {
    "forward_kinematics": ("q", "7", "Pose of the frame {} in the world frame, " + f"{POSE}."),
    "homogeneous_transform": ("q", "4, 4", "Pose of the frame {} in the world frame as a 4 x 4 matrix, m."),
    "jacobian": ("q", "6, arm::dof", "Jacobian of the frame {} at its origin in the world frame, linear rows first."),
}
DYNAMICS = {
    "inverse_dynamics": ("q qd qdd", "arm::dof", "Joint forces for a motion, N m or N."),
    "forward_dynamics": ("q qd torque", "arm::dof", "Joint accelerations for joint forces."),
    "gravity_torque": ("q", "arm::dof", "Joint forces that hold the robot at rest."),
    "coriolis_torque": ("q qd", "arm::dof", "Joint forces of the joint rates alone, without friction."),
    "mass_matrix": ("q", "arm::dof, arm::dof", "M(q), symmetric."),
    "coriolis_matrix": ("q qd", "arm::dof, arm::dof", "C(q, qd) of Christoffel's symbols."),
    "momentum_matrix": ("q", "6, arm::dof", "Momentum about the base's origin, in the base's frame, by velocities."),
    "kinetic_energy": ("q qd", "", "Kinetic energy, J."),
    "potential_energy": ("q", "", "Potential energy, J."),
    "regressor": ("q qd qdd", "arm::dof, arm::base_parameter_count",
                  "Y with inverse_dynamics = Y b, b the base parameters, without drives."),
    "regressor_with_drives": ("q qd qdd", "arm::dof, arm::identifiable_parameter_count",
                              "Y with inverse_dynamics = Y p, p the identifiable parameters of links and drives."),
    "centre_of_mass": ("q", "3", "Centre of mass of all links in the world frame, m."),
    "centre_of_mass_jacobian": ("q", "3, arm::dof", "Derivatives of the centre of mass by the joints."),
    "inverse_dynamics_with_gravity_vector": ("q qd qdd fall", "arm::dof", "Joint forces, gravity in any direction."),
    "inverse_dynamics_with_wrench": ("q qd qdd fall wrench", "arm::dof", "Joint forces, with a load on the tool."),
    "gravity_torque_with_gravity_vector": ("q fall", "arm::dof", "Joint forces at rest, gravity in any direction."),
    "forward_dynamics_with_gravity_vector": ("q qd torque fall", "arm::dof",
                                             "Joint accelerations, gravity in any direction."),
    "forward_dynamics_with_wrench": ("q qd torque fall wrench", "arm::dof",
                                     "Joint accelerations, with a load on the tool."),
    "potential_energy_with_gravity_vector": ("q fall", "", "Potential energy, J, gravity in any direction."),
}
WITH_GRAVITY = {"inverse_dynamics", "forward_dynamics", "gravity_torque", "potential_energy", "regressor",
                "regressor_with_drives"}
# header beside the umbrella's: functions that need it
LOADS = {name for name in DYNAMICS if name.endswith(("_with_gravity_vector", "_with_wrench"))}
HEADERS = {"dynamics_loads": LOADS, "regressor": {"regressor"}}


def _of_a_frame(name):
    """The entry of a function of one frame; None of any other."""
    match = re.fullmatch("(" + "|".join(OF_A_FRAME) + r")_of_(\w+)", name)
    if match is None:
        return None
    arguments, shape, line = OF_A_FRAME[match[1]]
    return arguments, shape, line.format(match[2])


def is_bound(name):
    """True of a function of C++ that Python can have."""
    return name in KINEMATICS or name in FRAMES or name in DYNAMICS or name in ARM_ANGLE_FUNCTIONS or \
        _of_a_frame(name) is not None


HEAD = """// SPDX-License-Identifier: MIT
#include <qvgen/robots/{robot}.h>
{headers}
namespace arm = qvgen::robots::{robot};
namespace py = pybind11;
using namespace qvgen::python;

PYBIND11_MODULE({robot}, m) {{
  m.attr("dof") = arm::dof;
  m.attr("joint_names") = list_of(arm::joint_names);
  m.attr("is_revolute") = list_of(arm::is_revolute);
  m.attr("lower_limits") = list_of(arm::lower_limits);
  m.attr("upper_limits") = list_of(arm::upper_limits);
  m.attr("velocity_limits") = list_of(arm::velocity_limits);
  m.attr("effort_limits") = list_of(arm::effort_limits);
  m.attr("default_geometry") = defaults<arm::Geometry>(arm::geometry_names);
  m.attr("functions") = py::module_::import("json").attr("loads")(R"json({functions})json");
"""

FLOATING_BASE = """  m.attr("velocity_size") = arm::velocity_size;
  m.def("integrated",
        +[](const py::object& q, const py::object& step, const py::object& out) {
          return in_scalar_of({q, step}, [&](auto zero) {
            using Scalar = decltype(zero);
            return each_row<Scalar>(
                {Rows<Scalar>(q, {7 + arm::dof}, "q"), Rows<Scalar>(step, {arm::velocity_size}, "step")}, {7 + arm::dof}, out,
                [&](const Scalar* const* row) {
                  return qvgen::integrated(configuration<arm::Configuration<Scalar>>(row[0]),
                                           vector<arm::Velocity<Scalar>>(row[1]));
                });
          });
        },
        py::arg("q"), py::arg("step"), py::kw_only(), py::arg("out") = py::none(),
        text("The configuration that a step leads to, a velocity times a time. q: (7 + dof,) or (n, 7 + dof), step: (velocity_size,)."));
  m.def("difference",
        +[](const py::object& from, const py::object& to, const py::object& out) {
          return in_scalar_of({from, to}, [&](auto zero) {
            using Scalar = decltype(zero);
            return each_row<Scalar>(
                {Rows<Scalar>(from, {7 + arm::dof}, "start"), Rows<Scalar>(to, {7 + arm::dof}, "goal")}, {arm::velocity_size},
                out, [&](const Scalar* const* row) {
                  return qvgen::difference(configuration<arm::Configuration<Scalar>>(row[0]),
                                           configuration<arm::Configuration<Scalar>>(row[1]));
                });
          });
        },
        py::arg("start"), py::arg("goal"), py::kw_only(), py::arg("out") = py::none(),
        text("The step from one configuration to another, (velocity_size,): integrated(start, step) is the goal."));
"""

INERTIA = """  m.attr("default_inertia") = defaults<arm::Inertia>(arm::inertia_names);
"""

NAMES = """  m.attr("{name}") = list_of(arm::{name});
"""

TOTAL_MASS = """  m.def("total_mass", +[](const py::object& geometry, const py::object& inertia) {
          return arm::total_mass<double>(constants<arm::Geometry>(geometry, arm::geometry_names, "geometry"),
                                         constants<arm::Inertia>(inertia, arm::inertia_names, "inertia"));
        },
        py::kw_only(), py::arg("geometry") = py::none(), py::arg("inertia") = py::none(),
        text("Mass of all links, kg. geometry, inertia: values of constants of the description, by name."));
"""

FUNCTION = """  m.def("{name}",
        +[]({parameters}const py::object& geometry{more_parameters}, const py::object& out) {{
          return in_scalar_of({{{names}}}, [&](auto zero) {{
            using Scalar = decltype(zero);
            using Joints = arm::JointVector<Scalar>;
            const auto g = constants<arm::BasicGeometry<Scalar>, Scalar>(geometry, arm::geometry_names, "geometry");
{prepare}            return each_row<Scalar>({{{rows}}}, {{{shape}}}, out,
                [&](const Scalar* const* row) {{ return arm::{called}({values}, g{more_values}); }});
          }});
        }},
        {keywords}py::kw_only(), py::arg("geometry") = py::none(), {more_keywords}py::arg("out") = py::none(),
        text(R"({doc})"));
"""


def _doc(text, arguments, shape, extra, meanings):
    row = shape.replace("arm::", "")
    sizes = [(name, *meanings[name]) for name in arguments]
    lines = [text, "", *(f"{name}: ({size},) or (n, {size}), {meaning}" for name, size, _, meaning in sizes), *extra,
             "geometry: values of constants of the description, by name",
             f"Returns the shape ({row}{'' if ',' in row or not row else ','}), a batch axis in front if an argument has one;",
             "in `out`, which may not overlap an argument, if it is given. Computed and returned in float32 if all of",
             f"{', '.join(arguments)} are arrays of float32, else in float64."]
    return "\n".join(lines)


def _taken(argument, place, meanings):
    """The argument as C++ takes it."""
    if not meanings[argument][1]:
        return f"configuration<arm::Configuration<Scalar>>(row[{place}])"
    return f"vector<{meanings[argument][1]}>(row[{place}])"


def _function(name, arguments, shape, text, dynamics, floats):
    arguments = arguments.split()
    meanings = ARGUMENTS | (FLOATING if floats and dynamics else {})
    if floats and dynamics:
        shape = shape.replace("arm::dof", "arm::velocity_size")
    extra, prepare, parameters, values, keywords = [], "", "", "", ""
    if dynamics:
        extra.append("inertia: inertial parameters of the description, by name")
        prepare = ('            const auto i = constants<arm::BasicInertia<Scalar>, Scalar>(inertia, arm::inertia_names, '
                   '"inertia");\n')
        parameters, values = ", const py::object& inertia", ", i"
        keywords = 'py::arg("inertia") = py::none(), '
        if name in WITH_GRAVITY:
            extra.append("gravity: acceleration of free fall along the world's -z, m/s^2")
            parameters, values = parameters + ", double gravity", values + ", static_cast<Scalar>(gravity)"
            keywords += 'py::arg("gravity") = 9.80665, '
    rows = [f'Rows<Scalar>({each}, {{{_length(meanings[each][0])}}}, "{each}")' for each in arguments]
    taken = {each: _taken(each, place, meanings) for place, each in enumerate(arguments)}
    values += "".join(f", {taken.pop(each)}" for each in AFTER_INERTIA if each in taken)
    return FUNCTION.format(
        name=name, called=name.partition("_with_")[0] if name in LOADS else name, shape=shape, doc=_doc(text, arguments, shape, extra, meanings),
        prepare=prepare, parameters="".join(f"const py::object& {each}, " for each in arguments),
        names=", ".join(arguments), rows=", ".join(rows), values=", ".join(taken.values()),
        keywords="".join(f'py::arg("{each}"), ' for each in arguments),
        more_parameters=parameters, more_values=values, more_keywords=keywords)


def _length(size):
    return size.replace("dof", "arm::dof").replace("velocity_size", "arm::velocity_size")


def binding_source(robot, functions, targets):
    """C++ of the module of a robot: `functions` as it is to say, `targets` what its inverse kinematics takes."""
    here = [name for name, place in functions.items() if place == "here"]
    headers = [f"<qvgen/robots/{robot}/{each}.h>" for each, users in HEADERS.items() if users.intersection(here)]
    headers += ['"binding.h"', *(['"binding_inverse.h"'] if targets or "nearest_pose" in here else []),
                *(['"binding_nearest_pose.h"'] if "nearest_pose" in here else []),
                *(['"binding_velocity.h"'] if "inverse_velocity" in here else [])]
    text = HEAD.format(robot=robot, functions=json.dumps(functions),
                       headers="".join(f"#include {each}\n" for each in headers))
    floats = "momentum_matrix" in here
    text += FLOATING_BASE if floats else ""
    text += INERTIA if "mass_matrix" in here else ""
    text += NAMES.format(name="singularity_names") if "singularity_measures" in here else ""
    text += NAMES.format(name="base_parameter_names") if "regressor" in here else ""
    text += NAMES.format(name="identifiable_parameter_names") if "regressor_with_drives" in here else ""
    text += NAMES.format(name="frame_names") if "frame_poses" in here else ""
    text += TOTAL_MASS if "centre_of_mass" in here else ""
    of_frames = {name: _of_a_frame(name) for name in here if _of_a_frame(name)}
    for table, dynamics in ((KINEMATICS, False), ({**FRAMES, **of_frames}, False), (DYNAMICS, True)):
        for name, (arguments, shape, line) in table.items():
            if name in here:
                text += _function(name, arguments, shape, line, dynamics, floats)
    text += arm_angle_source() if "arm_angle" in here else ""
    text += velocity_source() if "inverse_velocity" in here else ""
    text += nearest_pose_source() if "nearest_pose" in here else ""
    return text + "".join(inverse_source(name, taken) for name, taken in targets.items()) + "}\n"
