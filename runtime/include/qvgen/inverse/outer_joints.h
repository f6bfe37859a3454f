// SPDX-License-Identifier: MIT
// Joints in front of an arm, behind it, or between its own, whose values are given: a rail, a gantry, a
// torso, a wrist that is held.
//
// The inner arm is the arm with joints in front and behind at zero. With screws S and the tool at zero M the
// tool is at e(S1) ... e(Sn) M. So these move the inner arm's pose alone: those in front are taken off on the
// left, those behind, seen from the tool, on the right. Joints that are held between, or behind where a part
// of a pose is asked for, are constants of the inner arm's geometry, and their values alone stand here.
#pragma once

#include <array>
#include <limits>

#include <qvgen/inverse/phases.h>
#include <qvgen/inverse/requested_pose.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/tasks.h>
#include <qvgen/inverse/within.h>

namespace qvgen::inverse {

/// Which of an arm's joints are the inner arm's, how many stand in front of it, and the first that stands
/// behind.
template <int inner>
struct InnerPlaces {
  std::array<int, static_cast<std::size_t>(inner)> of;
  int first, behind;
};

/// Outer joints of an arm.
template <int dof, int inner>
class OuterJoints {
 public:
  /// `values`: of the given joints, zero for others. One that is no number makes what is asked for invalid.
  OuterJoints(const ArmAtZero<dof>& arm, const InnerPlaces<inner>& places, const Joints<dof>& values)
      : places_(places), values_(values) {
    const Pose<double> none{Eigen::Quaterniond::Identity(), Vector3<double>::Zero()};
    before_ = moved(arm, 0, places.first, none).inverse();
    behind_ = (arm.tool.inverse() * moved(arm, places.behind, dof, none) * arm.tool).inverse();
    if (!values.allFinite()) before_.position.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  /// The pose that the inner arm has to reach; what is no pose stays none.
  [[nodiscard]] Pose<double> inner_pose(const Pose<double>& pose) const {
    return between_frames(before_, pose_meant(pose).value_or(pose), behind_);
  }
  // Parts of a pose, as the inner arm has to reach them; no outer joints stand behind it.

  [[nodiscard]] Vector3<double> inner_task(const Vector3<double>& position) const {
    return before_ * position;
  }
  [[nodiscard]] PositionAndDirection<double> inner_task(const PositionAndDirection<double>& task) const {
    return {before_ * task.position, before_.orientation * direction_meant(task.direction)};
  }
  /// A pitch is counted from axes that the outer joints move along.
  [[nodiscard]] PositionAndPitch<double> inner_task(const PositionAndPitch<double>& task) const {
    return {before_ * task.position, task.pitch};
  }
  /// The inclination is seen by the tool.
  [[nodiscard]] PositionAndInclination<double> inner_task(const PositionAndInclination<double>& task) const {
    return {before_ * task.position, task.up};
  }
  [[nodiscard]] Pose<double> inner_task(const Pose<double>& pose) const { return inner_pose(pose); }

  /// Rows of the inner arm as rows of the arm.
  template <int capacity>
  [[nodiscard]] Solutions<dof, capacity> rows(const Solutions<inner, capacity>& found) const {
    Solutions<dof, capacity> result;
    result.status = found.status;
    result.effort = found.effort;
    for (const Solution<inner>& row : found) {
      Solution<dof>& whole = result.append();
      whole.q = values_;
      for (int i = 0; i < inner; ++i) whole.q[place(i)] = row.q[i];
      whole.branch = row.branch;
      whole.continuum = row.continuum;
    }
    return result;
  }
  /// Values of the inner arm's joints.
  [[nodiscard]] Joints<inner> inner_of(const Joints<dof>& q) const {
    Joints<inner> values;
    for (int i = 0; i < inner; ++i) values[i] = q[place(i)];
    return values;
  }
  /// Limits of the inner arm's joints.
  [[nodiscard]] JointLimits<inner> inner_limits(const JointLimits<dof>& limits) const {
    return {inner_of(limits.lower), inner_of(limits.upper)};
  }

 private:
  [[nodiscard]] int place(int i) const { return places_.of[static_cast<std::size_t>(i)]; }
  /// A frame carried along by some joints.
  [[nodiscard]] Pose<double> moved(const ArmAtZero<dof>& arm, int begin, int end, Pose<double> frame) const {
    for (int i = end; i-- > begin;) {
      ArmAtZero<1> joint;
      joint.joints[0] = arm.joints[static_cast<std::size_t>(i)];
      joint.tool = frame;
      frame = tool_of(joint, Joints<1>(values_[i]));
    }
    return frame;
  }

  InnerPlaces<inner> places_;
  Joints<dof> values_;
  Pose<double> before_, behind_;
};

}  // namespace qvgen::inverse
