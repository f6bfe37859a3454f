# SPDX-License-Identifier: MIT
"""The C++ source of a robot's module: its functions, those it has, handed to the templates of binding.h."""

import json

from ._inverse_source import POSE, inverse_source

ARGUMENTS = {"q": "joint positions, rad or m", "qd": "joint rates, rad/s or m/s",
             "qdd": "joint accelerations, rad/s^2 or m/s^2", "torque": "joint forces, N m or N"}
# name: arguments, shape of a row of the result, a line of text
KINEMATICS = {
    "forward_kinematics": ("q", "7", f"Pose of the tool in the world frame, {POSE}."),
    "homogeneous_transform": ("q", "4, 4", "Pose of the tool in the world frame as a 4 x 4 matrix, m."),
    "jacobian": ("q", "6, arm::dof", "Jacobian in the world frame at the tool, linear rows first."),
    "tool_jacobian": ("q", "6, arm::dof", "Jacobian in the tool frame at the tool, linear rows first."),
    "jacobian_dot": ("q qd", "6, arm::dof", "Derivative of the Jacobian by time."),
    "velocity": ("q qd", "6", "Twist of the tool in the world frame, m/s and rad/s, linear first."),
    "jacobian_dot_times_qd": ("q qd", "6", "The tool's acceleration at constant joint rates."),
}
DYNAMICS = {
    "inverse_dynamics": ("q qd qdd", "arm::dof", "Joint forces for a motion, N m or N."),
    "forward_dynamics": ("q qd torque", "arm::dof", "Joint accelerations for joint forces."),
    "gravity_torque": ("q", "arm::dof", "Joint forces that hold the robot at rest."),
    "coriolis_torque": ("q qd", "arm::dof", "Joint forces of the joint rates alone, without friction."),
    "mass_matrix": ("q", "arm::dof, arm::dof", "M(q), symmetric."),
    "coriolis_matrix": ("q qd", "arm::dof, arm::dof", "C(q, qd) of Christoffel's symbols."),
    "kinetic_energy": ("q qd", "", "Kinetic energy, J."),
    "potential_energy": ("q", "", "Potential energy, J."),
}
WITH_GRAVITY = {"inverse_dynamics", "forward_dynamics", "gravity_torque", "potential_energy"}

BOUND = {*KINEMATICS, *DYNAMICS}

HEAD = """// SPDX-License-Identifier: MIT
#include <qvgen/robots/{robot}.h>

#include "binding.h"
{inverse}
namespace arm = qvgen::robots::{robot};
namespace py = pybind11;
using namespace qvgen::python;

PYBIND11_MODULE({robot}, m) {{
  m.attr("dof") = arm::dof;
  m.attr("joint_names") = list_of(arm::joint_names);
  m.attr("is_revolute") = list_of(arm::is_revolute);
  m.attr("lower_limits") = list_of(arm::lower_limits);
  m.attr("upper_limits") = list_of(arm::upper_limits);
  m.attr("default_geometry") = defaults<arm::Geometry>(arm::geometry_names);
  m.attr("functions") = py::module_::import("json").attr("loads")(R"({functions})");
"""

INERTIA = """  m.attr("default_inertia") = defaults<arm::Inertia>(arm::inertia_names);
"""

FUNCTION = """  m.def("{name}",
        []({parameters}const py::object& geometry{more_parameters}, const py::object& out) {{
          return in_scalar_of({{{names}}}, [&](auto zero) {{
            using Scalar = decltype(zero);
            using Joints = arm::JointVector<Scalar>;
            const auto g = constants<arm::BasicGeometry<Scalar>, Scalar>(geometry, arm::geometry_names, "geometry");
{prepare}            return each_row<Scalar>({{{rows}}}, {{{shape}}}, out,
                [&](const Scalar* const* row) {{ return arm::{name}({values}, g{more_values}); }});
          }});
        }},
        {keywords}py::kw_only(), py::arg("geometry") = py::none(), {more_keywords}py::arg("out") = py::none(),
        R"({doc})");
"""


def _doc(text, arguments, shape, extra):
    row = shape.replace("arm::", "")
    lines = [text, "", *(f"{name}: (dof,) or (n, dof), {ARGUMENTS[name]}" for name in arguments), *extra,
             "geometry: values of constants of the description, by name",
             f"Returns the shape ({row}{'' if ',' in row or not row else ','}), a batch axis in front if an argument has one;",
             "in `out`, which may not overlap an argument, if it is given. Computed and returned in float32 if all of",
             f"{', '.join(arguments)} are arrays of float32, else in float64."]
    return "\n".join(lines)


def _function(name, arguments, shape, text, dynamics):
    arguments = arguments.split()
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
    return FUNCTION.format(
        name=name, shape=shape, doc=_doc(text, arguments, shape, extra), prepare=prepare,
        parameters="".join(f"const py::object& {each}, " for each in arguments),
        names=", ".join(arguments), rows=", ".join(f'Rows<Scalar>({each}, {{arm::dof}}, "{each}")' for each in arguments),
        values=", ".join(f"vector<Joints>(row[{place}])" for place in range(len(arguments))),
        keywords="".join(f'py::arg("{each}"), ' for each in arguments),
        more_parameters=parameters, more_values=values, more_keywords=keywords)


def binding_source(robot, functions, targets):
    """C++ of the module of a robot: `functions` as it is to say, `targets` what its inverse kinematics takes."""
    here = [name for name, place in functions.items() if place == "here"]
    text = HEAD.format(robot=robot, functions=json.dumps(functions),
                       inverse='#include "binding_inverse.h"\n' if targets else "")
    text += INERTIA if "mass_matrix" in here else ""
    for table, dynamics in ((KINEMATICS, False), (DYNAMICS, True)):
        for name, (arguments, shape, line) in table.items():
            if name in here:
                text += _function(name, arguments, shape, line, dynamics)
    return text + "".join(inverse_source(name, taken) for name, taken in targets.items()) + "}\n"
