# SPDX-License-Identifier: MIT
"""The C++ source of a robot's module: its functions, those it has, handed to the templates of binding.h."""

ARGUMENTS = {"q": "joint positions, rad or m", "qd": "joint rates, rad/s or m/s",
             "qdd": "joint accelerations, rad/s^2 or m/s^2", "torque": "joint forces, N m or N"}
POSE = "[w, x, y, z, px, py, pz]: unit quaternion and position, m"
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

BOUND = {*KINEMATICS, *DYNAMICS, "inverse_kinematics"}

HEAD = """// SPDX-License-Identifier: MIT
#include <qvgen/robots/{robot}.h>

#include "binding.h"

namespace arm = qvgen::robots::{robot};
namespace py = pybind11;
using namespace qvgen::python;
using Joints = arm::JointVector<double>;

PYBIND11_MODULE({robot}, m) {{
  m.attr("dof") = arm::dof;
  m.attr("joint_names") = list_of(arm::joint_names);
  m.attr("is_revolute") = list_of(arm::is_revolute);
  m.attr("lower_limits") = list_of(arm::lower_limits);
  m.attr("upper_limits") = list_of(arm::upper_limits);
  m.attr("default_geometry") = defaults<arm::Geometry>(arm::geometry_names);
"""

INERTIA = """  m.attr("default_inertia") = defaults<arm::Inertia>(arm::inertia_names);
"""

FUNCTION = """  m.def("{name}",
        []({parameters}const py::object& geometry{more_parameters}, const py::object& out) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
{prepare}          return each_row({{{rows}}}, {{{shape}}}, out,
                          [&](const double* const* row) {{ return arm::{name}({values}, g{more_values}); }});
        }},
        {keywords}py::kw_only(), py::arg("geometry") = py::none(), {more_keywords}py::arg("out") = py::none(),
        R"({doc})");
"""

INVERSE = """  m.def("inverse_kinematics",
        [](const py::object& pose, const py::object& seed, const py::object& geometry) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          constexpr int capacity = arm::inverse_info.capacity;
          if (seed.is_none())
            return each_solution<capacity>({{Rows(pose, {{7}}, "pose")}}, arm::dof,
                [&](const double* const* row) {{ return arm::inverse_kinematics(pose_of(row[0]), g); }});
          return each_solution<capacity>({{Rows(pose, {{7}}, "pose"), Rows(seed, {{arm::dof}}, "seed")}}, arm::dof,
              [&](const double* const* row) {{
                return arm::inverse_kinematics(pose_of(row[0]), vector<Joints>(row[1]), g);
              }});
        }},
        py::arg("pose"), py::arg("seed") = py::none(), py::kw_only(), py::arg("geometry") = py::none(),
        R"({doc})");
"""

INVERSE_DOC = f"""All joint values that bring the tool to a pose.

pose: (7,) or (n, 7), {POSE}
seed: (dof,) or (n, dof): solutions are sorted by their distance from it
geometry: values of constants of the description, by name
Returns (solutions, counts, status, branches): solutions (max, dof), rad or m, NaN behind the counts-th; status as in
qvgen.Status; branches (max,), -1 behind the last. With a batch axis in front of each if an argument has one."""


def _doc(text, arguments, shape, extra):
    row = shape.replace("arm::", "")
    lines = [text, "", *(f"{name}: (dof,) or (n, dof), {ARGUMENTS[name]}" for name in arguments), *extra,
             "geometry: values of constants of the description, by name",
             f"Returns float64 of the shape ({row}{'' if ',' in row or not row else ','}), a batch axis in front if an",
             "argument has one; in `out`, which may not overlap an argument, if it is given."]
    return "\n".join(lines)


def _function(name, arguments, shape, text, dynamics):
    arguments = arguments.split()
    extra, prepare, parameters, values, keywords = [], "", "", "", ""
    if dynamics:
        extra.append("inertia: inertial parameters of the description, by name")
        prepare = '          const auto i = constants<arm::Inertia>(inertia, arm::inertia_names, "inertia");\n'
        parameters, values = ", const py::object& inertia", ", i"
        keywords = 'py::arg("inertia") = py::none(), '
        if name in WITH_GRAVITY:
            extra.append("gravity: acceleration of free fall along the world's -z, m/s^2")
            parameters, values = parameters + ", double gravity", values + ", gravity"
            keywords += 'py::arg("gravity") = 9.80665, '
    return FUNCTION.format(
        name=name, shape=shape, doc=_doc(text, arguments, shape, extra), prepare=prepare,
        parameters="".join(f"const py::object& {each}, " for each in arguments),
        rows=", ".join(f'Rows({each}, {{arm::dof}}, "{each}")' for each in arguments),
        values=", ".join(f"vector<Joints>(row[{place}])" for place in range(len(arguments))),
        keywords="".join(f'py::arg("{each}"), ' for each in arguments),
        more_parameters=parameters, more_values=values, more_keywords=keywords)


def binding_source(robot, functions):
    """C++ of the module of a robot that has these functions."""
    text = HEAD.format(robot=robot) + (INERTIA if "mass_matrix" in functions else "")
    for table, dynamics in ((KINEMATICS, False), (DYNAMICS, True)):
        for name, (arguments, shape, line) in table.items():
            if name in functions:
                text += _function(name, arguments, shape, line, dynamics)
    if "inverse_kinematics" in functions:
        text += INVERSE.format(doc=INVERSE_DOC)
    return text + "}\n"
