// SPDX-License-Identifier: MIT
#include "random_arms.h"

#include "reference/linear_algebra.h"

namespace qvgen::test {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d Random::direction() {
  Vector3d v;
  do v = vector();
  while (v.norm() < 0.1);
  return v.normalized();
}

JointLimits<7> Random::limits() {
  JointLimits<7> limits;
  for (int i = 0; i < 7; ++i) {
    const double width = between(0.5, 6.5), middle = between(-1.5, 1.5);
    limits.lower[i] = middle - width / 2;
    limits.upper[i] = middle + width / 2;
  }
  return limits;
}

ArmAngleReference Random::reference() {
  switch (static_cast<int>(between(0, 4))) {
    case 0:
      return ArmAngleReference::conventional();
    case 1:
      return ArmAngleReference::conventional(direction());
    case 2:
      return ArmAngleReference::stereographic();
    default:
      return ArmAngleReference::stereographic(direction(), direction());
  }
}

namespace {

/// A direction at an angle, rad, to another.
Vector3d aside(const Vector3d& from, double angle, Random& random) {
  const Vector3d across = from.cross(random.direction()).normalized();
  return AngleAxisd(angle, across) * from;
}

}  // namespace

Arm Random::arm(const Build& build) {
  constexpr double right = 1.57079632679489661923;
  const auto twist = [&] { return build.right_angles ? right : between(0.4, 2.7); };
  Arm arm;
  auto& axes = arm.axes;
  arm.base = vector();
  arm.shoulder = vector();
  axes[3] = direction();
  const Vector3d forward = aside(axes[3], right, *this);
  const double upper = between(0.2, 0.6), forearm = build.equal_lengths ? upper : between(0.2, 0.6);
  arm.elbow = arm.shoulder + upper * forward;
  const Vector3d swinging = AngleAxisd(between(-3, 3), axes[3]) * forward;
  arm.wrist = arm.elbow + forearm * swinging;
  if (!build.planar) arm.wrist += between(0.05, 0.3) * axes[3];
  arm.planar = build.planar;
  axes[2] = build.plain_elbow ? forward : aside(axes[3], twist(), *this);
  axes[1] = aside(axes[2], twist(), *this);
  axes[0] = aside(axes[1], twist(), *this);
  axes[4] = build.plain_elbow ? swinging : aside(axes[3], twist(), *this);
  axes[5] = aside(axes[4], twist(), *this);
  axes[6] = aside(axes[5], twist(), *this);
  arm.tool.orientation = Eigen::Quaterniond(AngleAxisd(between(-3, 3), direction()));
  arm.tool.position = arm.wrist + 0.3 * vector();
  return arm;
}

namespace {

/// Returns the pose of the frame that the first `joints` joints carry.
Isometry3d carried(const Arm& arm, const Row& q, int joints) {
  Isometry3d result = Isometry3d::Identity();
  for (int i = 0; i < joints; ++i) {
    const Vector3d& point = i < 3 ? arm.shoulder : i == 3 ? arm.elbow : arm.wrist;
    Isometry3d motion = Isometry3d::Identity();
    motion.linear() = AngleAxisd(q[i], arm.axes[static_cast<std::size_t>(i)]).toRotationMatrix();
    motion.translation() = point - motion.linear() * point;
    result = result * motion;
  }
  return result;
}

Vector3d upwards(const Arm& arm) {
  return (arm.shoulder - arm.base).dot(arm.axes[0]) < 0 ? Vector3d(-arm.axes[0]) : arm.axes[0];
}

/// Across the line from shoulder to wrist, to the side where the arm angle is zero.
Vector3d zero_side(const Arm& arm, const ArmAngleReference& reference, const Vector3d& line) {
  const Vector3d direction = reference.direction.isZero() ? upwards(arm) : reference.direction.normalized();
  if (reference.kind == ArmAngleReference::Kind::conventional) return direction - direction.dot(line) * line;
  // The shortest turn from opposite the half line to the line carries the direction along.
  const Vector3d half_line =
      reference.half_line.isZero() ? Vector3d(-upwards(arm)) : reference.half_line.normalized();
  Vector3d across = reference.direction;
  if (across.isZero()) {
    int least = 0;
    half_line.cwiseAbs().minCoeff(&least);
    across = Vector3d::Unit(least);
  }
  across = (across - across.dot(half_line) * half_line).normalized();
  return reference::shortest_turn(-half_line, line) * across;
}

}  // namespace

Isometry3d tool_at(const Arm& arm, const Row& q) {
  Isometry3d tool = Isometry3d::Identity();
  tool.linear() = arm.tool.orientation.toRotationMatrix();
  tool.translation() = arm.tool.position;
  return carried(arm, q, 7) * tool;
}

double arm_angle_at(const Arm& arm, const Row& q, const ArmAngleReference& reference) {
  const Vector3d elbow = carried(arm, q, 3) * arm.elbow - arm.shoulder;
  const Vector3d line = (carried(arm, q, 4) * arm.wrist - arm.shoulder).normalized();
  const Vector3d side = elbow - elbow.dot(line) * line;
  const Vector3d zero = zero_side(arm, reference, line);
  return std::atan2(line.dot(zero.cross(side)), zero.dot(side));
}

double miss(const Arm& arm, const Row& q, const Pose<double>& pose) {
  const Isometry3d tool = tool_at(arm, q);
  const double size = (arm.elbow - arm.shoulder).norm() + (arm.wrist - arm.elbow).norm() +
                      (arm.tool.position - arm.wrist).norm() + arm.shoulder.norm();
  const double turn = (tool.linear() - pose.normalised().rotation_matrix()).cwiseAbs().maxCoeff();
  return std::max((tool.translation() - pose.position).norm() / size, turn);
}

Pose<double> pose_at(const Arm& arm, const Row& q) {
  const Isometry3d tool = tool_at(arm, q);
  return Pose<double>{Eigen::Quaterniond(tool.linear()), tool.translation()}.normalised();
}

double apart(const Row& a, const Row& b) {
  double most = 0;
  for (int i = 0; i < 7; ++i) most = std::max(most, std::abs(turn_between(a[i], b[i])));
  return most;
}

}  // namespace qvgen::test
