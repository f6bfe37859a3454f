# SPDX-License-Identifier: MIT
"""The C++ source of a module's closed loops: the functions of assembly.h, handed to the templates of binding_loops.h."""

import re

# name: length of a row, what it is
ARGUMENTS = {
    "a": ("arm::driven_count", "positions of the driven joints, rad or m"),
    "outputs": ("arm::output_joints.size()", "positions of the joints that say where the platform is, rad or m"),
    "q": ("arm::dof", "joint positions of an assembly, rad or m"),
    "qd": ("arm::dof", "rates of all joints, rad/s or m/s: rates(q) times those of the driven ones"),
    "ad": ("arm::driven_count", "rates of the driven joints, rad/s or m/s"),
    "add": ("arm::driven_count", "accelerations of the driven joints, rad/s^2 or m/s^2"),
    "forces": ("arm::driven_count", "forces of the motors, N m or N"),
}
GEOMETRY, INERTIA, GRAVITY = "geometry", "inertia", "gravity"
# name: arguments, constants, shape of a row of the result, a line of text
FUNCTIONS = {
    "loop_gaps": ("q", (GEOMETRY,), "arm::gap_count", "Gaps of the loops, m: zero where they are closed."),
    "loop_jacobian": ("q", (GEOMETRY,), "arm::passive_count, arm::dof", "Derivatives of the gaps by all joints."),
    "rates": ("q", (GEOMETRY,), "arm::dof, arm::driven_count", "Rates of all joints by those of the driven ones, dq/da."),
    "accelerations": ("q qd add", (GEOMETRY,), "arm::dof", "Accelerations of all joints."),
    "drive_measure": ("q", (GEOMETRY,), "", "From 0 to 1: 0 where passive joints move although the motors stand still."),
    "platform_measure": ("q", (GEOMETRY,), "", "From 0 to 1: 0 where motors turn although the platform stands still."),
    "platform_rates": ("q", (GEOMETRY,), "arm::output_joints.size(), arm::driven_count",
                       "Rates of the platform's joints by those of the driven ones."),
    "driven_inverse_dynamics": ("q ad add", (GEOMETRY, INERTIA, GRAVITY), "arm::driven_count",
                                "Forces of the motors for a motion, N m or N."),
    "driven_mass_matrix": ("q", (GEOMETRY, INERTIA), "arm::driven_count, arm::driven_count",
                           "Mass matrix of the driven joints, symmetric."),
    "driven_forward_dynamics": ("q ad forces", (GEOMETRY, INERTIA, GRAVITY), "arm::driven_count",
                                "Accelerations of the driven joints under forces of their motors."),
}
OF_A_TIP = {
    "pose_of": ("q", (GEOMETRY,), "7", "Pose of the tip {} in the world frame: quaternion w, x, y, z, then the position in metres."),
    "jacobian_of": ("q", (GEOMETRY,), "6, arm::driven_count",
                    "Jacobian of the tip {} by the driven joints, in the world frame, linear rows first."),
}
SETS = {"assemble": "a", "assemble_from_outputs": "outputs"}

FUNCTION = """  m.def("{name}",
        +[]({parameters}const py::object& out) {{
{prepare}          return each_row<double>({{{rows}}}, {{{shape}}}, out,
              [&](const double* const* row) {{ return arm::{name}({values}); }});
        }},
        {keywords}py::kw_only(), {constants}py::arg("out") = py::none(), text(R"({doc})"));
"""

SET = """  m.def("{name}",
        +[](const py::object& {given}, const py::object& seed, const py::object& geometry, double tolerance) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          using Given = Eigen::Matrix<double, static_cast<int>({size}), 1>;
          std::vector<Rows<double>> rows{{Rows<double>({given}, {{{size}}}, "{given}")}};
          if (seed.is_none())
            return each_assembly<arm::dof>(rows, [&](const double* const* row) {{
              return arm::{name}(vector<Given>(row[0]), g, tolerance);
            }});
          rows.emplace_back(seed, Shape{{arm::dof}}, "seed");
          return each_assembly<arm::dof>(rows, [&](const double* const* row) {{
            return arm::{name}(vector<Given>(row[0]), vector<arm::JointVector<double>>(row[1]), g, tolerance);
          }});
        }},
        py::arg("{given}"), py::arg("seed") = py::none(), py::kw_only(), py::arg("geometry") = py::none(),
        py::arg("tolerance") = qvgen::inverse::default_tolerance, text(R"({doc})"));
"""

SET_DOC = """All assemblies of the loops: joint positions at which they close.

{given}: ({size},) or (n, {size}), {meaning}
seed: (dof,) or (n, dof): rows are sorted by their distance from it, and angles are next to it by whole turns
geometry: values of constants of the description, by name
tolerance: how far beyond the boundary of reach, as a share of the mechanism's size, the loops still close
Returns qvgen.Assemblies: q (max, dof), count (), status (), branch (max,), continuum (max,), meets (max,), with a batch
axis in front of each if an argument has one."""

FOLLOW = """  m.def("follow",
        +[](const py::object& a, const py::object& seed, bool path, const py::object& geometry) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          const std::vector<Rows<double>> rows{{Rows<double>(a, {{arm::driven_count}}, "a"),
                                               Rows<double>(seed, {{arm::dof}}, "seed")}};
          return each_followed<arm::dof>(rows, path, [&](const double* driven, const arm::JointVector<double>& near) {{
            return arm::follow(vector<arm::Driven>(driven), near, g);
          }});
        }},
        py::arg("a"), py::arg("seed"), py::kw_only(), py::arg("path") = false, py::arg("geometry") = py::none(),
        text(R"({doc})"));
"""

FOLLOW_DOC = """The assembly next to a seed, by Newton's steps: it leads to one assembly, also where there is no closed form.

a: (driven_count,) or (n, driven_count), positions of the driven joints, rad or m
seed: (dof,) or (n, dof), an assembly nearby
path: the rows follow each other: `seed`, a single row, is the first one's, then the row before is the seed
geometry: values of constants of the description, by name
Returns qvgen.Followed: q (dof,), NaN where the loops do not close, and closed (), with a batch axis in front of each if an
argument has one."""

VALUES = """  m.attr("driven_count") = arm::driven_count;
  m.attr("driven_joints") = list_of(arm::driven_joints);
  m.attr("passive_joints") = list_of(arm::passive_joints);
"""

OUTPUTS = """  m.attr("output_joints") = list_of(arm::output_joints);
"""

# How a constant is taken, handed on, and what it is.
CONSTANTS = {
    GEOMETRY: ('const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");', "g", "py::none()",
               "values of constants of the description, by name"),
    INERTIA: ('const auto i = constants<arm::Inertia>(inertia, arm::inertia_names, "inertia");', "i", "py::none()",
              "inertial parameters of the description, by name"),
    GRAVITY: ("", "gravity", "9.80665", "acceleration of free fall along the world's -z, m/s^2"),
}


def _entry(name):
    """The entry of a function, those of a tip among them; None of any other."""
    match = re.fullmatch("(" + "|".join(OF_A_TIP) + r")_(\w+)", name)
    if match is None:
        return FUNCTIONS.get(name)
    arguments, constants, shape, line = OF_A_TIP[match[1]]
    return arguments, constants, shape, line.format(match[2])


def loop_functions(header):
    """The names of the functions that the text of a header assembly.h declares and Python can have."""
    declared = dict.fromkeys(re.findall(r"^(?:inline )?[\w:<>, ]+ (\w+)\(const ", header, re.MULTILINE))
    return [name for name in declared if name in SETS or name == "follow" or _entry(name)]


def tips(names):
    """The tips that functions are of."""
    return [name[len("pose_of_"):] for name in names if name.startswith("pose_of_")]


def _size(length):
    return {"arm::output_joints.size()": "output_count"}.get(length, length.replace("arm::", ""))


def _function(name, arguments, constants, shape, line):
    arguments = arguments.split()
    rows = [f'Rows<double>({each}, {{{ARGUMENTS[each][0]}}}, "{each}")' for each in arguments]
    values = [f"vector<Eigen::Matrix<double, {ARGUMENTS[each][0]}, 1>>(row[{place}])" for place, each in enumerate(arguments)]
    taken = [(each, *CONSTANTS[each]) for each in constants]
    sizes = [(each, _size(ARGUMENTS[each][0]), ARGUMENTS[each][1]) for each in arguments]
    row = ", ".join(_size(each) for each in shape.split(", ")) if shape else ""
    doc = [line, "", *(f"{each}: ({size},) or (n, {size}), {meaning}" for each, size, meaning in sizes),
           *(f"{each}: {meaning}" for each, *_, meaning in taken),
           f"Returns float64 of the shape ({row}{'' if ',' in row or not row else ','}), a batch axis in front if an argument has",
           "one; in `out`, which may not overlap an argument, if it is given."]
    types = {GRAVITY: "double gravity, "}
    return FUNCTION.format(
        name=name, rows=", ".join(rows), shape=shape, values=", ".join([*values, *(value for _, _, value, *_ in taken)]),
        prepare="".join(f"          {line}\n" for _, line, *_ in taken if line),
        parameters="".join([*(f"const py::object& {each}, " for each in arguments),
                            *(types.get(each, f"const py::object& {each}, ") for each in constants)]),
        keywords="".join(f'py::arg("{each}"), ' for each in arguments),
        constants="".join(f'py::arg("{each}") = {default}, ' for each, _, _, default, _ in taken), doc="\n".join(doc))


def loop_source(names):
    """C++ that binds functions of assembly.h."""
    text = VALUES + (OUTPUTS if "platform_rates" in names else "")
    for name in names:
        if name in SETS:
            size, meaning = ARGUMENTS[SETS[name]]
            doc = SET_DOC.format(given=SETS[name], size=_size(size), meaning=meaning)
            text += SET.format(name=name, given=SETS[name], size=size, doc=doc)
        elif name == "follow":
            text += FOLLOW.format(doc=FOLLOW_DOC)
        else:
            text += _function(name, *_entry(name))
    return text
