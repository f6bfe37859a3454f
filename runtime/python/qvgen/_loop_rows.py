# SPDX-License-Identifier: MIT
"""Functions of a robot's closed loops: what its header assembly.h declares, and the C++ that runs them over rows.

The loops over rows are the templates of rows_loops.h. What C has is run by C instead: _loop_rows_c.py.
"""

import re

# name: length of a row, what it is
ARGUMENTS = {
    "a": ("driven_count", "positions of the driven joints, rad or m"),
    "outputs": ("output_count", "positions of the joints that say where the platform is, rad or m"),
    "q": ("dof", "joint positions of an assembly, rad or m"),
    "qd": ("dof", "rates of all joints, rad/s or m/s: rates(q) times those of the driven ones"),
    "ad": ("driven_count", "rates of the driven joints, rad/s or m/s"),
    "add": ("driven_count", "accelerations of the driven joints, rad/s^2 or m/s^2"),
    "forces": ("driven_count", "forces of the motors, N m or N"),
    "wrench": ("6", "force and moment on the tip in the world frame, N and N m"),
    "fall": ("3", "acceleration of free fall in the world frame, m/s^2"),
}
# In dynamics of a robot whose base floats these are other rows:
ON_FLOATING_BASE = {
    "q": ("configuration_size", "pose of the base, w x y z and metres, then joint positions of an assembly, rad or m"),
    "ad": ("moved_count", "velocity of the base in its own frame, linear before angular, then rates of the driven joints"),
    "add": ("moved_count", "accelerations of the base, its velocity's derivatives, then of the driven joints"),
    "forces": ("moved_count", "force and moment on the base, in its own frame, then forces of the motors, N and N m"),
}
WRENCH_ON_FLOATING_BASE = ("6", "force and moment on the tip in the base's frame, N and N m")
# name: arguments, of what it takes constants, shape of a row of the result, a line of text
FUNCTIONS = {
    "loop_gaps": ("q", "geometry", "gap_count", "Gaps of the loops, m: zero where they are closed."),
    "loop_jacobian": ("q", "geometry", "passive_count, dof", "Derivatives of the gaps by all joints."),
    "rates": ("q", "geometry", "dof, driven_count", "Rates of all joints by those of the driven ones, dq/da."),
    "accelerations": ("q qd add", "geometry", "dof", "Accelerations of all joints."),
    "drive_measure": ("q", "geometry", "", "From 0 to 1: 0 where passive joints move although the motors stand still."),
    "platform_measure": ("q", "geometry", "", "From 0 to 1: 0 where motors turn although the platform stands still."),
    "platform_rates": ("q", "geometry", "output_count, driven_count",
                       "Rates of the platform's joints by those of the driven ones."),
    "driven_inverse_dynamics": ("q ad add", "geometry inertia gravity", "driven_count",
                                "Forces of the motors for a motion, N m or N."),
    "loop_forces": ("q ad add", "geometry inertia gravity", "passive_count",
                    "Forces in the loops for a motion, N: a rod's pushes its ends apart."),
    "driven_mass_matrix": ("q", "geometry inertia", "driven_count, driven_count", "Mass matrix of the driven joints, symmetric."),
    "driven_forward_dynamics": ("q ad forces", "geometry inertia gravity", "driven_count",
                                "Accelerations of the driven joints under forces of their motors."),
}
OF_A_TIP = {
    "pose_of": ("q", "geometry", "7", "Pose of the tip {} in the world frame: quaternion w, x, y, z, then the position in metres."),
    "jacobian_of": ("q", "geometry", "6, driven_count",
                    "Jacobian of the tip {} by the driven joints, in the world frame, linear rows first."),
    "motor_forces_of": ("q wrench", "geometry", "driven_count", "Forces of the motors that hold a wrench on the tip {}, N m or N."),
    "loop_forces_of": ("q wrench", "geometry", "passive_count", "Forces in the loops, N, that a wrench on the tip {} makes."),
}
SETS = {"assemble": "a", "assemble_from_outputs": "outputs"}
ARGUMENTS["pose"] = ("7", "pose of the tip in the world frame: quaternion w, x, y, z, then the position in metres")
TIP_MOTION, WITH_VECTOR = "driven_tip_motion_of_", "_with_gravity_vector"  # in C, of robots whose base floats
OF_JOINTS, OF_POSE = "assemble_from_joints_of_", "inverse_kinematics_of_"

HEAD = """#include <qvgen/robots/{robot}/assembly.h>
#include "rows_loops.h"
"""

INERTIA = """static arm::Inertia inertia(const qvgen_call* c) { return constants<arm::Inertia>(c->inertia, arm::inertia_names); }
"""

FUNCTION = """QVGEN_ROWS ptrdiff_t rows_{name}(const qvgen_call* c) {{
  {constants}
  return value_rows(c, [&](ptrdiff_t k) {{ return arm::{name}({values}); }});
}}
"""

READ_POSE = "TargetOf<qvgen::Pose<double>>::read(row<double>(c, 0, k))"

SET = """QVGEN_ROWS ptrdiff_t rows_{name}(const qvgen_call* c) {{
  const auto g = geometry(c);
  return assembly_rows<arm::dof>(c, [&](ptrdiff_t k, const auto&... seed) {{
    return arm::{name}({given}, seed..., g, c->numbers[0]);
  }});
}}
"""

FOLLOW = """QVGEN_ROWS ptrdiff_t rows_follow(const qvgen_call* c) {{
  const auto g = geometry(c);
  return followed_rows<arm::dof>(c, [&](ptrdiff_t k, const qvgen::Joints<arm::dof>& seed) {{
    return arm::follow({given}, seed, g);
  }});
}}
"""


def entry_of_loops(name, floats=False):
    """Returns arguments, constants, shape and text of a function, those of a tip among them; None of any other. `floats`: the
    robot's base does, so that dynamics are of the base, too."""
    if name.endswith(WITH_VECTOR):
        arguments, constants, shape, line = entry_of_loops(name[:-len(WITH_VECTOR)], floats)
        return arguments + " fall", constants.replace(" gravity", ""), shape, line + " Gravity has any direction."
    match = re.fullmatch("(" + "|".join(OF_A_TIP) + r")_(\w+)", name)
    if match is None and name in FUNCTIONS:
        arguments, constants, shape, line = FUNCTIONS[name]
        if floats and is_dynamics(constants):
            shape = shape.replace("driven_count", "moved_count")
            line += " Velocities, accelerations and motor forces begin with six of the base."
        return arguments, constants, shape, line
    if match is None:
        return None
    arguments, constants, shape, line = OF_A_TIP[match[1]]
    line = line.replace("world frame", "base's frame") if floats else line
    return arguments, constants, shape, line.format(match[2])


def is_dynamics(constants):
    """True of functions that take inertial parameters."""
    return "inertia" in constants


def with_base(numbers):
    """Counts of joints with those that a floating base adds."""
    return {**numbers, "configuration_size": 7 + numbers["dof"], "moved_count": 6 + numbers["driven_count"]}


def given_of(name):
    """Returns the argument of a function that gives sets of assemblies, None of any other."""
    if name.startswith(OF_JOINTS):
        return "joints_of_" + name[len(OF_JOINTS):]
    return "pose" if name.startswith(OF_POSE) else SETS.get(name)


def argument_of(given):
    """Returns the length of a row of an argument, and what it is."""
    if given.startswith("joints_of_"):
        return given + "_count", f"positions of the joints between the base and the tip {given[len('joints_of_'):]}, rad or m"
    return ARGUMENTS[given]


class Loops:
    """The header assembly.h of one robot, as text: its functions, numbers and places of joints."""

    def __init__(self, text):
        declared = dict.fromkeys(re.findall(r"^(?:inline )?[\w:<>, ]+ (\w+)\(const ", text, re.MULTILINE))
        self.functions = [name for name in declared if given_of(name) or name == "follow" or entry_of_loops(name)]
        self.numbers = {name: int(value) for name, value in re.findall(r"constexpr int (\w+_count) = (\d+);", text)}
        lists = re.findall(r"constexpr std::array<int, \w+> ((?:driven|passive|output)_joints)\{([^}]*)\};", text)
        self.joints = {name: [int(each) for each in listed.split(",") if each.strip()] for name, listed in lists}
        self.numbers["output_count"] = len(self.joints.get("output_joints", ()))
        limbs = re.findall(r"assemble_from_joints_of_(\w+)\(const Eigen::Matrix<double, (\d+), 1>& joints,\s+const Geometry", text)
        self.numbers.update({f"joints_of_{tip}_count": int(count) for tip, count in limbs})
        self.solved_tips = [name[len(OF_POSE):] for name in self.functions if name.startswith(OF_POSE)]
        self.tips = [name[len("pose_of_"):] for name in self.functions if name.startswith("pose_of_")]
        self.base_floats = "driven_velocity_size" in text
        if self.base_floats:
            self.functions += [name + WITH_VECTOR for name in self.functions if "gravity" in (entry_of_loops(name) or ("", ""))[1]]
        if "driven_tip_motion(" in text:
            self.functions += [TIP_MOTION + tip for tip in self.tips]

    def tips_with_parts(self, robot):
        """Limbs of a robot with the parts of them whose functions are called."""
        parts = ["jacobian", "kinematics"]
        return {f"{robot}_{tip}": [*parts, *(["inverse", "inverse_avx2"] if tip in self.solved_tips else [])] for tip in self.tips}


def _read(argument, place, count=None):
    """C++ that reads an argument as a vector of its length."""
    if argument == "pose":
        return READ_POSE
    length = str(count) if count else ARGUMENTS[argument][0]
    size = "static_cast<int>(arm::output_joints.size())" if length == "output_count" else length if length.isdigit() else f"arm::{length}"
    return f"vector<Eigen::Matrix<double, {size}, 1>>(row<double>(c, {place}, k))"


def _function(name):
    arguments, constants, *_ = entry_of_loops(name)
    constants = constants.split()
    taken = {"geometry": "g", "inertia": "i", "gravity": "c->numbers[0]"}
    values = [*(_read(each, place) for place, each in enumerate(arguments.split())), *(taken[each] for each in constants)]
    lines = ["const auto g = geometry(c);", *(["const auto i = inertia(c);"] if "inertia" in constants else [])]
    return FUNCTION.format(name=name, constants="\n  ".join(lines), values=", ".join(values))


def _rows_of(name, numbers):
    given = given_of(name)
    if given:
        return SET.format(name=name, given=_read(given, 0, numbers.get(f"{given}_count")))
    return FOLLOW.format(given=_read("a", 0)) if name == "follow" else _function(name)


def _is_of_the_base(name):
    """True of functions that take the pose of a base that floats."""
    return name.startswith(TIP_MOTION) or is_dynamics((entry_of_loops(name) or ("", ""))[1])


def loop_rows(robot, loops):
    """C++ that runs functions of closed loops over rows, behind that of the robot's other functions."""
    names = [name for name in loops.functions if not (loops.base_floats and _is_of_the_base(name))]
    head = HEAD.format(robot=robot) + (INERTIA if "driven_mass_matrix" in names else "")
    return head + "".join(_rows_of(name, loops.numbers) for name in names)  # C has those of a floating base
