# SPDX-License-Identifier: MIT
"""The C++ source of a module's inverse kinematics, handed to the templates of binding_inverse.h."""

POSE = "[w, x, y, z, px, py, pz]: unit quaternion and position, m"
# name of a task: its type in C++, its shape, what it is
TASKS = {
    "pose": ("qvgen::Pose<double>", 7, POSE),
    "position": ("qvgen::Vector3<double>", 3, "[px, py, pz]: position of the tool point, m"),
    "position_and_direction": ("qvgen::PositionAndDirection<double>", 6,
                               "[px, py, pz, x, y, z]: position, m, and the direction of the tool's axis, a unit vector"),
    "position_and_yaw": ("qvgen::PositionAndYaw<double>", 4,
                         "[px, py, pz, yaw]: position, m, and turn from where the tool is with all joints at zero, rad"),
    "position_and_pitch": ("qvgen::PositionAndPitch<double>", 4,
                           "[px, py, pz, pitch]: position, m, and angle of the tool's axis to the first joint's, rad"),
    "direction": ("qvgen::Direction<double>", 3, "[x, y, z]: direction of the tool's axis, a unit vector"),
    "orientation": ("Eigen::Quaternion<double>", 4, "[w, x, y, z]: unit quaternion"),
}

GIVEN = "given: () or (n,), of several joints (k,) or (n, k): value of {joint}, rad or m"

ALL = """  m.def("{name}",
        [](const py::object& {target}, {given_parameter}const py::object& seed, const py::object& limits,
           const py::object& geometry, double tolerance) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          const auto bounds = limits_of<arm::Limits, arm::dof>(limits);
          const auto solve = [](const auto&... arguments) {{ return arm::{name}(arguments...); }};
          return {solutions}({{{target}, {given}, seed, limits}}, bounds, g, tolerance, {label}solve);
        }},
        py::arg("{target}"), {given_keyword}py::arg("seed") = py::none(), py::kw_only(), py::arg("limits") = py::none(),
        py::arg("geometry") = py::none(), py::arg("tolerance") = qvgen::inverse::default_tolerance,
        R"({doc})");
"""

NEAR = """  m.def("{name}",
        [](const py::object& {target}, {given_parameter}const py::object& seed, bool path, const py::object& limits,
           const py::object& geometry, double tolerance) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          const auto bounds = limits_of<arm::Limits, arm::dof>(limits);
          const auto solve = [](const auto&... arguments) {{ return arm::{name}(arguments...); }};
          return near_{solutions}({{{target}, {given}, seed, limits}}, path, bounds, g, tolerance, {label}solve);
        }},
        py::arg("{target}"), {given_keyword}py::arg("seed"), py::kw_only(), py::arg("path") = false,
        py::arg("limits") = py::none(),
        py::arg("geometry") = py::none(), py::arg("tolerance") = qvgen::inverse::default_tolerance,
        R"({doc})");
"""

ARM_ANGLE = """  m.def("arm_angle",
        [](const py::object& q, const std::string& reference, const py::object& geometry) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          const auto counted_from = reference_of(reference);
          return each_row<double>({{Rows<double>(q, {{arm::dof}}, "q")}}, {{}}, py::none(), [&](const double* const* row) {{
            return arm::arm_angle(vector<qvgen::Joints<arm::dof>>(row[0]), counted_from, g);
          }});
        }},
        py::arg("q"), py::kw_only(), py::arg("reference") = "conventional", py::arg("geometry") = py::none(),
        R"({angle_doc})");
  m.def("inverse_kinematics_arm_angle",
        [](const py::object& pose, const py::object& psi, const py::object& seed, const std::string& reference,
           const py::object& geometry, double tolerance) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          const auto counted_from = reference_of(reference);
          std::vector<Rows<double>> rows{{Rows<double>(pose, {{7}}, "pose"), Rows<double>(psi, {{}}, "psi")}};
          const auto target = [](const double* const* row) {{ return TargetOf<qvgen::Pose<double>>::read(row[0]); }};
          if (seed.is_none())
            return each_solution<arm::dof>(rows, [&](const double* const* row) {{
              return arm::inverse_kinematics_arm_angle(target(row), row[1][0], counted_from, g, tolerance);
            }});
          rows.emplace_back(seed, Shape{{arm::dof}}, "seed");
          return each_solution<arm::dof>(rows, [&](const double* const* row) {{
            return arm::inverse_kinematics_arm_angle(target(row), row[1][0], vector<qvgen::Joints<arm::dof>>(row[2]),
                                                     counted_from, g, tolerance);
          }});
        }},
        py::arg("pose"), py::arg("psi"), py::arg("seed") = py::none(), py::kw_only(),
        py::arg("reference") = "conventional", py::arg("geometry") = py::none(),
        py::arg("tolerance") = qvgen::inverse::default_tolerance, R"({solutions_doc})");
  m.def("inverse_kinematics",
        [](const py::object& pose, const py::object& seed, const py::object& limits, const py::object& geometry,
           double tolerance) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          const auto bounds = limits_of<arm::Limits, arm::dof>(limits);
          if (!bounds) throw py::value_error("limits: \\"description\\", or a pair (lower, upper)");
          std::vector<Rows<double>> rows{{Rows<double>(pose, {{7}}, "pose")}};
          const auto target = [](const double* const* row) {{ return TargetOf<qvgen::Pose<double>>::read(row[0]); }};
          if (seed.is_none())
            return each_solution<arm::dof>(rows, [&](const double* const* row) {{
              return arm::inverse_kinematics(target(row), *bounds, qvgen::ArmAngleReference(), g, tolerance);
            }});
          rows.emplace_back(seed, Shape{{arm::dof}}, "seed");
          return each_solution<arm::dof>(rows, [&](const double* const* row) {{
            return arm::inverse_kinematics(target(row), vector<qvgen::Joints<arm::dof>>(row[1]), *bounds,
                                           qvgen::ArmAngleReference(), g, tolerance);
          }});
        }},
        py::arg("pose"), py::arg("seed") = py::none(), py::kw_only(), py::arg("limits") = "description",
        py::arg("geometry") = py::none(), py::arg("tolerance") = qvgen::inverse::default_tolerance, R"({limits_doc})");
"""

REFERENCE_DOC = 'reference: "conventional": counted from a fixed direction, or "stereographic": from one that turns along'

ANGLE_DOC = f"""Arm angle of joint values, rad in (-pi, pi]: the turn of the elbow about the line from shoulder to wrist.

q: (dof,) or (n, dof), joint positions, rad
{REFERENCE_DOC}
geometry: values of constants of the description, by name
Returns float64 of the shape (), a batch axis in front if q has one."""

ANGLE_SOLUTIONS_DOC = """All joint values that bring the tool to a pose with an arm angle.

pose: (7,) or (n, 7), {pose}
psi: () or (n,), arm angle, rad
seed: (dof,) or (n, dof): solutions are sorted by their distance from it, free joints are taken from it
{reference}
{common}
Returns qvgen.Solutions, with a batch axis in front of each field if an argument has one."""

ANGLE_LIMITS_DOC = """Joint values within limits that bring the tool to a pose, wherever there are any: one row for each branch.

pose: (7,) or (n, 7), {pose}
seed: (dof,) or (n, dof): the arm angle nearest to its, the nearest row first; without: the one farthest from the limits
limits: "description": the description's; (lower, upper): two rows of dof numbers
{common}
Returns qvgen.Solutions, with a batch axis in front of each field if an argument has one."""

COMMON_DOC = """geometry: values of constants of the description, by name
tolerance: how far beyond the boundary of reach, as a share of the arm's size, a pose is still solved"""

ALL_DOC = """All joint values that bring the tool to a pose.

{targets}seed: (dof,) or (n, dof): solutions are sorted by their distance from it, free joints are taken from it
limits: None: angles in (-pi, pi], each once; "description": the description's; (lower, upper): two rows of dof numbers.
    Within limits angles that differ by whole turns are different solutions; with a seed the nearest of each branch
{common}
Returns qvgen.Solutions: q (max, dof), count (), status (), branch (max,), continuum (max,), with a batch axis in
front of each if an argument has one. Always computed and returned in float64."""

NEAR_DOC = """For control loops: the joint values on the branch of the seed, the joints that went before.

{targets}seed: (dof,) or (n, dof); angles are within half a turn of it
path: the targets follow each other: `seed`, a single row, is the first one's, then the last solution before a target is its seed
limits: None; "description": the description's; (lower, upper): two rows of dof numbers. The solution without limits if it is
    within them, else none: it neither jumps to another branch nor by whole turns
{common}
Returns qvgen.NearSolution: q (dof,), NaN if there is none, and status (), with a batch axis in front of each if an
argument has one. Whoever must not jump looks how far q is from the seed. Always computed and returned in float64."""


def _targets_doc(target, taken, given):
    shapes = [f"({size},) or (n, {size}), {meaning}" for _, size, meaning in (TASKS[task] for task in taken)]
    return f"{target}: " + ";\n    or ".join(shapes) + "\n" + given


def inverse_source(name, taken):
    """C++ that binds a function of inverse kinematics; `taken` are the names of the tasks that it takes."""
    joint = name.partition("_given_")[2]
    target = "pose" if taken == ["pose"] else "target"
    given = GIVEN.format(joint=joint) + "\n" if joint else ""
    has_given = f"1 + arm::inverse_info_given_{joint}.more_given" if joint else "0"
    values = {"name": name, "target": target, "has_given": has_given, "given": "given" if joint else "{}",
              "given_parameter": "const py::object& given, " if joint else "",
              "given_keyword": 'py::arg("given"), ' if joint else ""}
    kind = TASKS[taken[0]][0]
    either = "" if len(taken) == 1 else "_either"
    near = name.startswith("inverse_kinematics_near")
    template, doc = (NEAR, NEAR_DOC) if near else (ALL, ALL_DOC)
    return template.format(**values, solutions=f"solutions_of{either}<{kind}, arm::dof, {has_given}>",
                           label="" if either else f'"{target}", ',
                           doc=doc.format(targets=_targets_doc(target, taken, given), common=COMMON_DOC))


def arm_angle_source():
    """C++ that binds what arms with a spherical shoulder and wrist have."""
    return ARM_ANGLE.format(
        angle_doc=ANGLE_DOC, limits_doc=ANGLE_LIMITS_DOC.format(pose=POSE, common=COMMON_DOC),
        solutions_doc=ANGLE_SOLUTIONS_DOC.format(pose=POSE, reference=REFERENCE_DOC, common=COMMON_DOC))


NEAREST_POSE = """  m.def("nearest_pose",
        [](const py::object& pose, const py::object& seed, const std::string& prefer, double metres_per_radian,
           const py::object& limits, int starts, const py::object& geometry) {{
          const auto g = constants<arm::Geometry>(geometry, arm::geometry_names, "geometry");
          qvgen::NearestPoseOptions<arm::dof> options;
          options.prefer = prefer_of(prefer);
          options.metres_per_radian = metres_per_radian;
          if (const auto bounds = limits_of<arm::Limits, arm::dof>(limits)) options.limits = *bounds;
          options.starts = starts;
          const qvgen::inverse::NearestPose solver{{arm::is_revolute,
              [&](const qvgen::Joints<arm::dof>& q) {{ return arm::forward_kinematics(q, g); }},
              [&](const qvgen::Joints<arm::dof>& q) {{ return arm::jacobian(q, g); }}}};
          return nearest_rows<arm::dof>(pose, seed, options, solver);
        }},
        py::arg("pose"), py::arg("seed") = py::none(), py::kw_only(), py::arg("prefer") = "both",
        py::arg("metres_per_radian") = 0.0, py::arg("limits") = py::none(), py::arg("starts") = 32,
        py::arg("geometry") = py::none(), R"({doc})");
"""

NEAREST_POSE_DOC = f"""Joint values whose pose is nearest to a given one, the nearest first: for poses that were rounded or are out of reach.

pose: (7,) or (n, 7), {POSE}
seed: (dof,) or (n, dof): one more start of the descent
prefer: "both": least squares; "position" or "orientation": that first, and of what is left the nearest other
metres_per_radian: m, the distance that counts as much as a radian; 0: the arm's size
limits: None; "description": the description's; (lower, upper): two rows of dof numbers
starts: starts spread over the joints' ranges; with a good seed 0 is enough
geometry: values of constants of the description, by name
Returns qvgen.NearestRows: q (16, dof), position_error (16,), m, orientation_error (16,), rad, continuum (16,), count (),
status (): solved where the first row reaches the pose, else unreachable; with a batch axis in front of each if an argument
has one. Always computed and returned in float64."""


def nearest_pose_source():
    """C++ that binds the nearest reachable pose, which needs forward kinematics and the Jacobian."""
    return NEAREST_POSE.format(doc=NEAREST_POSE_DOC)


ARM_ANGLE_FUNCTIONS = ("arm_angle", "inverse_kinematics_arm_angle")
