// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/inverse/elimination/solve.h>
#include <qvgen/inverse/whole_arm.h>

/// The elimination for arms that come down to six joints: five and the turn of the tool that a task leaves,
/// or seven of which one is given.
namespace qvgen::inverse::elimination {

inline Description description_of(const ArmAtZero<joints>& arm) {
  Description result;
  for (std::size_t i = 0; i < joints; ++i) result.axes[i] = arm.joints[i];
  const Eigen::Matrix3d rotation = arm.tool.orientation.toRotationMatrix();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result.tool.rotation[3 * i + k] = rotation(i, k);
    result.tool.translation[i] = arm.tool.position[i];
  }
  return result;
}

/// All solutions of an arm with one joint more, which is given; Status::invalid where its value is no number.
inline Solutions<joints + 1, most_solutions> solve_given(const ArmAtZero<joints + 1>& arm, int given,
                                                         double value, const Choices& choices,
                                                         const Pose<double>& pose, double tolerance,
                                                         const Preference<joints + 1>& preference,
                                                         Form form) {
  Found found;
  if (!std::isfinite(value)) {
    found.status = Status::invalid;
  } else {
    const Setup setup = set_up_first(description_of(without_joint(arm, given, value)), choices);
    solve(setup, pose, tolerance, without_joint(preference, given), form, found);
  }
  return with_joint(found, given, value);
}

}  // namespace qvgen::inverse::elimination
