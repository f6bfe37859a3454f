# SPDX-License-Identifier: MIT
"""Prints the C++ that runs over rows what a robot's C has not; its loops are the templates of rows_cxx.h."""

from ._c_rows import label_of
from ._tables import TASKS

HEAD = """// SPDX-License-Identifier: MIT
#include <qvgen/robots/{robot}.h>
#include "rows_cxx.h"
namespace arm = qvgen::robots::{robot};
using namespace qvgen::python;
static arm::Geometry geometry(const qvgen_call* c) {{ return constants<arm::Geometry>(c->geometry, arm::geometry_names); }}
"""

SOLVER = """QVGEN_ROWS ptrdiff_t rows_{label}(const qvgen_call* c) {{
  const auto g = geometry(c);
  return {rows}_rows<arm::dof>(c, {seed_at}, [&](ptrdiff_t k, const auto&... more) {{
    return arm::{name}(TargetOf<{target}>::read(row<double>(c, 0, k)), {given}more..., g, c->numbers[0]);
  }});
}}
"""

ARM_ANGLE = """QVGEN_ROWS ptrdiff_t rows_arm_angle(const qvgen_call* c) {
  const auto g = geometry(c);
  for (ptrdiff_t k = 0; k < c->count; ++k)
    *result<double>(c, 0, k) = arm::arm_angle(vector<qvgen::Joints<arm::dof>>(row<double>(c, 0, k)), reference(c), g);
  return 0;
}
QVGEN_ROWS ptrdiff_t rows_inverse_kinematics_arm_angle__pose(const qvgen_call* c) {
  const auto g = geometry(c);
  const auto solve = [&](ptrdiff_t k, const auto&... seed) {
    return arm::inverse_kinematics_arm_angle(TargetOf<qvgen::Pose<double>>::read(row<double>(c, 0, k)), *row<double>(c, 1, k),
                                             seed..., reference(c), g, c->numbers[0]);
  };
  std::size_t most = 0;
  for (ptrdiff_t k = 0; k < c->count; ++k)
    most = std::max(most, c->flags[0] != 0 ? put<arm::dof>(c, k, solve(k, vector<qvgen::Joints<arm::dof>>(row<double>(c, 2, k))))
                                           : put<arm::dof>(c, k, solve(k)));
  return static_cast<ptrdiff_t>(most);
}
QVGEN_ROWS ptrdiff_t rows_inverse_kinematics__pose(const qvgen_call* c) {
  const auto g = geometry(c);
  const auto bounds = *limits<arm::dof>(c);
  std::size_t most = 0;
  for (ptrdiff_t k = 0; k < c->count; ++k) {
    const auto pose = TargetOf<qvgen::Pose<double>>::read(row<double>(c, 0, k));
    const qvgen::ArmAngleReference usual;
    const auto seed = [&] { return vector<qvgen::Joints<arm::dof>>(row<double>(c, 1, k)); };
    most = std::max(most, c->flags[0] != 0
        ? put<arm::dof>(c, k, arm::inverse_kinematics(pose, seed(), bounds, usual, g, c->numbers[0]))
        : put<arm::dof>(c, k, arm::inverse_kinematics(pose, bounds, usual, g, c->numbers[0])));
  }
  return static_cast<ptrdiff_t>(most);
}
"""

NEAREST_POSE = """QVGEN_ROWS ptrdiff_t rows_nearest_pose(const qvgen_call* c) {
  const auto g = geometry(c);
  const qvgen::inverse::NearestPose solver{arm::is_revolute,
      [&](const qvgen::Joints<arm::dof>& q) { return arm::forward_kinematics(q, g); },
      [&](const qvgen::Joints<arm::dof>& q) { return arm::jacobian(q, g); }};
  return nearest_rows<arm::dof>(c, solver);
}
"""

FLOATING_BASE = """QVGEN_ROWS ptrdiff_t rows_integrated(const qvgen_call* c) {
  using At = arm::Configuration<double>;
  for (ptrdiff_t k = 0; k < c->count; ++k)
    write(qvgen::integrated(configuration<At>(row<double>(c, 0, k)), vector<arm::Velocity<double>>(row<double>(c, 1, k))),
          result<double>(c, 0, k, 7 + arm::dof));
  return 0;
}
QVGEN_ROWS ptrdiff_t rows_difference(const qvgen_call* c) {
  using At = arm::Configuration<double>;
  for (ptrdiff_t k = 0; k < c->count; ++k) {
    const auto step = qvgen::difference(configuration<At>(row<double>(c, 0, k)), configuration<At>(row<double>(c, 1, k)));
    std::copy(step.data(), step.data() + step.size(), result<double>(c, 0, k, step.size()));
  }
  return 0;
}
"""


def given_count(name):
    """C++ that says how many joints are given."""
    joint = name.partition("_given_")[2]
    return f"1 + arm::inverse_info_given_{joint}.more_given" if joint else "0"


def _solver(name, task, given):
    return SOLVER.format(label=label_of(name, task), rows="near" if name.startswith("inverse_kinematics_near") else "all",
                         seed_at=2 if given else 1, name=name, target=TASKS[task][3],
                         given="".join(f"row<double>(c, 1, k)[{i}], " for i in range(given)))


def cxx_rows(robot, targets, given, parts):
    """C++ of a robot: `targets` are those of its inverse kinematics, `given` how many joints are given for each name;
    `parts` of arm_angle, nearest_pose, floating_base."""
    text = HEAD.format(robot=robot)
    text += "".join(_solver(name, task, given[name]) for name, taken in targets.items() for task in taken)
    for part, source in (("arm_angle", ARM_ANGLE), ("nearest_pose", NEAREST_POSE), ("floating_base", FLOATING_BASE)):
        text += source if part in parts else ""
    return text
