// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/inverse/requested_pose.h>
#include <qvgen/inverse/screw.h>
#include <qvgen/pose.h>

namespace qvgen {

/// Target position of the tool point, m, and direction of one of the tool's axes, a unit vector. The turn
/// about that axis is left open.
template <class Scalar>
struct PositionAndDirection {
  Vector3<Scalar> position;
  Vector3<Scalar> direction;
};

/// Target position of the tool point, m, and yaw of the tool, rad: its turn about the direction that all of
/// the arm's axes share, counted from the pose with all joints at zero.
template <class Scalar>
struct PositionAndYaw {
  Vector3<Scalar> position;
  Scalar yaw;
};

/// Target position of the tool point, m, and pitch of one axis of the tool, rad: its angle to the axis about
/// which the arm turns as a whole, counted about the axes of the joints behind it. 0 is along that axis, pi
/// against it: with an upright first axis a gripper that points down has the pitch pi.
template <class Scalar>
struct PositionAndPitch {
  Vector3<Scalar> position;
  Scalar pitch;
};

/// Target position of the tool point, m, and inclination of the tool: the direction of the axis about which
/// the arm turns as a whole, as the tool sees it, a unit vector in the tool's frame. With an upright first
/// axis it is what a level on the tool shows; the heading, the turn about that axis, is left open.
template <class Scalar>
struct PositionAndInclination {
  Vector3<Scalar> position;
  Vector3<Scalar> up;
};

/// Returns the direction of the base's z as a tool sees it whose orientation is Rz(any heading) Ry(pitch)
/// Rx(roll), rad.
template <class Scalar>
Vector3<Scalar> up_seen(Scalar pitch, Scalar roll) {
  using std::cos, std::sin;
  return {-sin(pitch), cos(pitch) * sin(roll), cos(pitch) * cos(roll)};
}

/// Target direction of one axis of the tool: a unit vector.
template <class Scalar>
struct Direction {
  Vector3<Scalar> vector;
};

namespace inverse {

/// An arm with all joints at zero, for telling whether joints reach a pose.
template <int dof>
struct ArmAtZero {
  std::array<Screw<double>, static_cast<std::size_t>(dof)> joints;
  Pose<double> tool;
};

template <int dof>
Pose<double> tool_of(const ArmAtZero<dof>& arm, const Eigen::Matrix<double, dof, 1>& q) {
  Pose<double> tool = arm.tool;
  for (int i = dof; i-- > 0;) {
    const Screw<double>& joint = arm.joints[static_cast<std::size_t>(i)];
    const Vector3<double> axis(joint.axis[0], joint.axis[1], joint.axis[2]);
    const Vector3<double> point(joint.point[0], joint.point[1], joint.point[2]);
    if (joint.revolute) {
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(q[i], axis));
      tool = {turn * tool.orientation, point + turn * (tool.position - point)};
    } else {
      tool.position += q[i] * axis;
    }
  }
  return tool;
}

/// The shortest turn that brings a unit vector to the direction of another, whose length the quaternion takes
/// over: one that is no unit vector by more than rounding makes no valid pose.
inline Eigen::Quaterniond turn_between(const Vector3<double>& from, const Vector3<double>& to) {
  const double length = to.norm();
  const double cosine = from.dot(to);
  if (cosine < -0.5 * length) {
    // By half a turn about a direction across first.
    const Vector3<double> across = from.unitOrthogonal();
    const Eigen::Quaterniond half(0, across.x(), across.y(), across.z());
    return turn_between(Vector3<double>(-from), to) * half;
  }
  const Vector3<double> normal = from.cross(to);
  const Eigen::Quaterniond twice(length + cosine, normal.x(), normal.y(), normal.z());
  return Eigen::Quaterniond(Eigen::Vector4d(twice.coeffs() * (length / twice.norm())));
}

/// The pose with a given direction that turns a tool at `near` least.
inline Pose<double> pose_of(const PositionAndDirection<double>& task, const Vector3<double>& tool_axis,
                            const Eigen::Quaterniond& near) {
  return {turn_between(near * tool_axis, direction_meant(task.direction)) * near, task.position};
}
inline Pose<double> pose_of(const Direction<double>& task, const Vector3<double>& tool_axis,
                            const Eigen::Quaterniond& near) {
  return {turn_between(near * tool_axis, direction_meant(task.vector)) * near, Vector3<double>::Zero()};
}

/// Returns an orientation alone as a pose, its digits completed if they were rounded away.
inline Pose<double> turn_meant(const Eigen::Quaterniond& orientation) {
  const Pose<double> given{orientation, Vector3<double>::Zero()};
  return pose_meant(given).value_or(given);
}

/// `axis`: what the yaw turns about.
inline Pose<double> pose_of(const PositionAndYaw<double>& task, const Triple<double>& axis,
                            const Eigen::Quaterniond& at_zero) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(task.yaw, Vector3<double>(axis[0], axis[1], axis[2])));
  return {turn * at_zero, task.position};
}

/// Which of an arm's joints a pitch is about.
struct PitchJoints {
  int base;        ///< turns the whole arm
  int first;       ///< the first of those that turn about the axes of the pitch
  int given = -1;  ///< the joint whose value the caller gives
};

/// Returns the angle from one vector to another as it is seen along a unit vector, 0 if one of them is along
/// it.
inline double angle_about(const Vector3<double>& axis, const Vector3<double>& from,
                          const Vector3<double>& to) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
}

/// Returns a pose that has the position and the pitch of a task: the joint at the base is at zero. It is no
/// rotation where the given joint brings the tool's axis along the axes of the pitch.
template <int dof>
Pose<double> pose_of(const PositionAndPitch<double>& task, const ArmAtZero<dof>& arm,
                     const PitchJoints& joints, const Vector3<double>& tool_axis, double given = 0) {
  Eigen::Matrix<double, dof, 1> q = Eigen::Matrix<double, dof, 1>::Zero();
  Eigen::Quaterniond moved = Eigen::Quaterniond::Identity();
  const auto axis_of = [&](int joint) {
    const Triple<double>& axis = arm.joints[static_cast<std::size_t>(joint)].axis;
    const Vector3<double> at_zero(axis[0], axis[1], axis[2]);
    return joints.given < joint ? Vector3<double>(moved * at_zero) : at_zero;
  };
  if (joints.given >= 0) {
    q[joints.given] = given;
    if (arm.joints[static_cast<std::size_t>(joints.given)].revolute)
      moved = Eigen::AngleAxisd(given, axis_of(joints.given));
  }
  const Vector3<double> base = axis_of(joints.base), across = axis_of(joints.first);
  const Eigen::Quaterniond tool = tool_of<dof>(arm, q).orientation;
  const Vector3<double> inclined = tool * tool_axis;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(task.pitch - angle_about(across, base, inclined), across));
  const bool has_pitch = inclined.cross(across).squaredNorm() > tolerance::pitched;
  return {has_pitch ? turn * tool : Eigen::Quaterniond(0, 0, 0, 0), task.position};
}

/// Joints that place the axis of the heading.
struct HeadingJoints {
  int base;        ///< turns the whole arm
  int given = -1;  ///< the joint whose value the caller gives
};

/// Returns the axis of the heading in the base's frame, where a given joint before it has moved it.
template <int dof>
Vector3<double> heading_axis(const ArmAtZero<dof>& arm, const HeadingJoints& joints, double given = 0) {
  const auto axis_of = [&](int joint) {
    const Triple<double>& axis = arm.joints[static_cast<std::size_t>(joint)].axis;
    return Vector3<double>(axis[0], axis[1], axis[2]);
  };
  const bool is_moved = joints.given >= 0 && joints.given < joints.base &&
                        arm.joints[static_cast<std::size_t>(joints.given)].revolute;
  const Vector3<double> base = axis_of(joints.base);
  return is_moved ? Eigen::AngleAxisd(given, axis_of(joints.given)) * base : base;
}

/// Returns the pose with the position and the inclination of a task that turns the tool least from the base's
/// frame.
template <int dof>
Pose<double> pose_of(const PositionAndInclination<double>& task, const ArmAtZero<dof>& arm,
                     const HeadingJoints& joints, double given = 0) {
  const Vector3<double> axis = heading_axis(arm, joints, given);
  return {turn_between(axis, direction_meant(task.up)).conjugate(), task.position};
}

}  // namespace inverse
}  // namespace qvgen
