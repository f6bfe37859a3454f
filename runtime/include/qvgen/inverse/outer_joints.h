// SPDX-License-Identifier: MIT
// Joints in front of an arm and behind it, whose values are given: a rail, a gantry, a torso, a wrist that is
// held.
//
// The inner arm is the arm with these joints at zero. With screws S and the tool at zero M the tool is at
// e(S1) ... e(Sn) M. So the outer joints move the inner arm's pose alone: those in front are taken off on the
// left, those behind, seen from the tool, on the right.
#pragma once

#include <qvgen/inverse/phases.h>
#include <qvgen/inverse/requested_pose.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/tasks.h>
#include <qvgen/inverse/within.h>

namespace qvgen::inverse {

/// Outer joints of an arm whose joints `first`, ..., `first + inner - 1` are the inner arm's.
template <int dof, int first, int inner>
class OuterJoints {
 public:
  /// `values`: of the outer joints, those of others are not read.
  OuterJoints(const ArmAtZero<dof>& arm, const Joints<dof>& values) : values_(values) {
    const Pose<double> none{Eigen::Quaterniond::Identity(), Vector3<double>::Zero()};
    before_ = moved(arm, 0, first, none).inverse();
    behind_ = (arm.tool.inverse() * moved(arm, first + inner, dof, none) * arm.tool).inverse();
  }

  /// The pose that the inner arm has to reach; what is no pose stays none.
  [[nodiscard]] Pose<double> inner_pose(const Pose<double>& pose) const {
    return between_frames(before_, pose_meant(pose).value_or(pose), behind_);
  }
  // Parts of a pose, as the inner arm has to reach them; no outer joints stand behind it.

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
      whole.q.template segment<inner>(first) = row.q;
      whole.branch = row.branch;
      whole.continuum = row.continuum;
    }
    return result;
  }
  /// Values of the inner arm's joints.
  static Joints<inner> inner_of(const Joints<dof>& q) { return q.template segment<inner>(first); }

 private:
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

  Joints<dof> values_;
  Pose<double> before_, behind_;
};

}  // namespace qvgen::inverse
