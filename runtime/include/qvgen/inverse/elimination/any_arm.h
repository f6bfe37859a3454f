// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/inverse/elimination/solve.h>
#include <qvgen/inverse/whole_arm.h>

/// The elimination for arms that come down to six joints: five and the turn of the tool or the heading that a
/// task leaves, or seven of which one is given.
///
/// A heading is a turn of the tool, too. That the tool sees an axis e of the base as `up`, R^T e = up, says
/// that its own axis `up` points along e: a turn about e through the tool point is one about that axis. It
/// comes with the pose. As the last axis of the arm it leaves the equations of most eliminations as they are,
/// so that an arm in numbers is set up once, and a pose only turns that axis (`with_last_axis`).
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

/// Returns the axis of the heading in the tool's frame at a pose with the inclination that is asked for.
template <int dof>
Vector3<double> heading_seen(const ArmAtZero<dof>& arm, const HeadingJoints& places, const Pose<double>& pose,
                             double given = 0) {
  return pose.normalised().orientation.conjugate() * heading_axis(arm, places, given);
}

/// Returns the arm with the turn that a task without a heading leaves as one more joint, for a pose with the
/// position and the inclination that are asked for.
template <int dof>
ArmAtZero<dof + 1> with_heading(const ArmAtZero<dof>& arm, const HeadingJoints& places,
                                const Pose<double>& pose, double given = 0) {
  return with_tool_turn(arm, heading_seen(arm, places, pose, given));
}

/// Returns the setup of such an arm from that for any inclination.
template <int dof>
Setup with_heading(const Setup& setup, const ArmAtZero<dof>& arm, const HeadingJoints& places,
                   const Pose<double>& pose) {
  const Vector3<double> axis = heading_seen(arm, places, pose);
  return with_last_axis(setup, {axis.x(), axis.y(), axis.z()});
}

/// Returns the caller's preference for the rows of such an arm: the heading is the one that the seed leaves
/// to the pose.
template <int dof>
Preference<dof + 1> heading_preference(const ArmAtZero<dof + 1>& arm, const Joints<dof>& seed,
                                       const Pose<double>& pose) {
  Joints<dof + 1> row = Joints<dof + 1>::Zero();
  row.template head<dof>() = seed;
  const Triple<double>& last = arm.joints.back().axis;
  const Vector3<double> axis = arm.tool.orientation.conjugate() * Vector3<double>(last[0], last[1], last[2]);
  const Eigen::Quaterniond left = tool_of<dof + 1>(arm, row).orientation.conjugate() * pose.orientation;
  row[dof] = without_turns(2 * std::atan2(left.vec().dot(axis), left.w()));
  return preference<dof + 1>(row);
}

}  // namespace qvgen::inverse::elimination
