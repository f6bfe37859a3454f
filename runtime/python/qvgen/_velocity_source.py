# SPDX-License-Identifier: MIT
"""The C++ source of a module's inverse velocity, handed to the templates of binding_velocity.h."""

FUNCTION = """  m.def("{name}",
        [](const py::object& q, const py::object& twist, {limits_parameter}const py::object& geometry, double threshold,
           double damping, double scale) {{
          return in_scalar_of({{q, twist}}, [&](auto zero) {{
            using Scalar = decltype(zero);
            const auto g = constants<arm::BasicGeometry<Scalar>, Scalar>(geometry, arm::geometry_names, "geometry");
            const auto options = velocity_options<Scalar>(threshold, damping, scale);
{bounds}            return rates_of<arm::dof, Scalar>(q, twist, [&](const auto& joints, const auto& wanted) {{
              return {call};
            }});
          }});
        }},
        py::arg("q"), py::arg("twist"), py::kw_only(), {limits_keyword}py::arg("geometry") = py::none(),
        py::arg("threshold") = 0.02, py::arg("damping") = 0.02, py::arg("scale") = 0.05, R"({doc})");
"""

BOUNDS = "            const auto bounds = rate_limits_of<Scalar, arm::dof>(limits, arm::velocity_limits);\n"

# name: its call, a line of text, what limits mean
FUNCTIONS = {
    "inverse_velocity": (
        "arm::inverse_velocity<Scalar>(joints, wanted, g, options)",
        "Joint rates for a twist of the tool, damped near singularities; for more than six joints the smallest.", None),
    "inverse_velocity_scaled": (
        "qvgen::scaled_to_limits<Scalar, arm::dof>(arm::inverse_velocity<Scalar>(joints, wanted, g, options), bounds)",
        "The rates of inverse_velocity, all scaled by the largest factor up to 1 that brings them within limits.",
        "they have to admit rest"),
    "inverse_velocity_within": (
        "qvgen::inverse_velocity_within<Scalar, arm::dof>(arm::jacobian(joints, g), wanted, bounds, options)",
        "The joint rates within limits whose twist is nearest to one; for more than six joints the smallest of those.",
        "they need not admit rest"),
}

LIMITS_DOC = """limits: "description": the greatest velocities of the description; (lower, upper): two rows of dof numbers, rad/s or m/s;
    {meaning}
"""

DOC = """{line}

q: (dof,) or (n, dof), joint positions, rad or m
twist: (6,) or (n, 6), twist of the tool in the world frame, m/s and rad/s, linear first
{limits}geometry: values of constants of the description, by name
threshold, damping, scale: singular values below threshold times the largest are damped, at zero by damping times the
    largest, which counts as at least scale, m or rad
Returns qvgen.JointRates: qd (dof,), status (), residual (), factor (), limited (), with a batch axis in front of each if
an argument has one. Computed and returned in float32 if q and twist are arrays of float32, else in float64."""


def velocity_source():
    """C++ that binds what gives joint rates for twists."""
    text = ""
    for name, (call, line, meaning) in FUNCTIONS.items():
        text += FUNCTION.format(
            name=name, call=call, bounds=BOUNDS if meaning else "",
            limits_parameter="const py::object& limits, " if meaning else "",
            limits_keyword='py::arg("limits") = "description", ' if meaning else "",
            doc=DOC.format(line=line, limits=LIMITS_DOC.format(meaning=meaning) if meaning else ""))
    return text
