// SPDX-License-Identifier: MIT
#include "case.h"

#include <cmath>

#include "reference/linear_algebra.h"

namespace qvgen::test {

Case::Case(const InverseUnderTest& robot)
    : robot_(robot), chain_(reference::load(robot.description, robot.geometry)) {}

Eigen::VectorXd Case::joints() {
  return Eigen::VectorXd::NullaryExpr(robot_.dof, [this] { return uniform(-pi, pi); });
}

bool Case::asks_position() const {
  return robot_.info.task != Task::direction && robot_.info.task != Task::orientation;
}

bool Case::asks_orientation() const {
  return robot_.info.task == Task::pose || robot_.info.task == Task::position_and_yaw ||
         robot_.info.task == Task::orientation;
}

bool Case::asks_direction() const {
  return robot_.info.task == Task::direction || robot_.info.task == Task::position_and_direction;
}

Eigen::Vector3d Case::tool_axis() const { return Eigen::Vector3d(robot_.info.tool_axis); }

Eigen::Vector3d Case::axis(int joint, const Eigen::VectorXd& q) const {
  return reference::joint_places(chain_, q)[static_cast<std::size_t>(joint)].axis;
}

int Case::base_joint() const {
  if (base_) return *base_;
  const int given = robot_.info.given_joint;
  int joint = 0;
  while (joint == given || !revolute(joint)) ++joint;
  base_ = joint;
  if (!asks_inclination() || given < 0 || given > joint || !revolute(given)) return joint;
  if (reference::rank(jacobian(Eigen::VectorXd::LinSpaced(dof(), 0.4, 1.3)), 1e-9) < dof() - 1) base_ = given;
  return *base_;
}

int Case::pitch_joint() const {
  int joint = base_joint() + 1;
  while (joint == robot_.info.given_joint || !revolute(joint)) ++joint;
  return joint;
}

namespace {

/// From one vector to another, seen along a unit vector.
double angle_about(const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return std::atan2(axis.dot(from.cross(to)), from.cross(axis).dot(to.cross(axis)));
}

}  // namespace

double Case::pitch(const Eigen::VectorXd& q) const {
  Eigen::VectorXd ahead = q;
  ahead[base_joint()] = 0;
  return angle_about(axis(pitch_joint(), ahead), axis(base_joint(), ahead),
                     tool(ahead).linear() * tool_axis());
}

Case::Miss Case::miss(const Eigen::VectorXd& q, const Eigen::Isometry3d& target) const {
  const Eigen::Isometry3d reached = tool(q);
  Miss result;
  if (asks_position()) result.position = (reached.translation() - target.translation()).norm();
  // |R - R'| = 2 sqrt(2) sin(angle/2): no loss of digits at small angles, unlike the trace.
  const double gap = (reached.linear() - target.linear()).norm();
  if (asks_orientation()) result.orientation = 2 * std::asin(std::min(1.0, gap / std::sqrt(8.0)));
  if (asks_direction()) result.orientation = ((reached.linear() - target.linear()) * tool_axis()).norm();
  if (leaves_heading()) result.orientation = (base_seen(q, reached) - base_seen(q, target)).norm();
  return result;
}

Eigen::VectorXd Case::residual(const Eigen::VectorXd& q, const Eigen::Isometry3d& target) const {
  const Eigen::Isometry3d reached = tool(q);
  Eigen::VectorXd result(3 * parts());
  if (asks_position()) result.head<3>() = target.translation() - reached.translation();
  if (asks_direction())
    result.tail<3>() = reached.linear().transpose() * (target.linear() - reached.linear()) * tool_axis();
  if (asks_pitch()) {
    const Eigen::Vector3d across = reached.linear().transpose() * axis(pitch_joint(), q);
    result.tail<3>() =
        Eigen::Vector3d(angle_about(across, base_seen(q, target), base_seen(q, reached)), 0, 0);
  }
  if (asks_inclination()) result.tail<3>() = base_seen(q, target) - base_seen(q, reached);
  if (!asks_orientation()) return result;
  const Eigen::AngleAxisd turn(target.linear() * reached.linear().transpose());
  result.tail<3>() = turn.angle() * turn.axis();
  return result;
}

Eigen::VectorXd Case::moved(const Eigen::VectorXd& q, const Eigen::VectorXd& step) const {
  Eigen::VectorXd result = q;
  for (int i = 0, k = 0; i < dof(); ++i)
    if (i != robot_.info.given_joint) result[i] += step[k++];
  return result;
}

Eigen::VectorXd Case::difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  Eigen::VectorXd result = b - a;
  for (int i = 0; i < dof(); ++i)
    if (revolute(i)) result[i] = std::remainder(result[i], 2 * pi);
  return result;
}

Eigen::MatrixXd Case::jacobian(const Eigen::VectorXd& q) const {
  const Eigen::MatrixXd full = reference::jacobian(chain_, q);
  const Eigen::Matrix3d to_tool = tool(q).linear().transpose();
  Eigen::MatrixXd result(3 * parts(), 0);
  for (int i = 0; i < dof(); ++i) {
    if (i == robot_.info.given_joint) continue;
    Eigen::VectorXd column(result.rows());
    if (asks_position()) column.head<3>() = full.col(i).head<3>();
    if (asks_orientation()) column.tail<3>() = full.col(i).tail<3>();
    // In the tool's frame, where nothing moves along the axis.
    if (asks_direction())
      column.tail<3>() = Eigen::Vector3d(to_tool * full.col(i).tail<3>()).cross(tool_axis());
    // The first joint turns what the pitch is counted from, too.
    if (asks_pitch()) {
      const double rate = i == base_joint() ? 0 : full.col(i).tail<3>().dot(axis(pitch_joint(), q));
      column.tail<3>() = Eigen::Vector3d(rate, 0, 0);
    }
    // A turn about the base's axis does not change how the tool sees that axis.
    if (asks_inclination()) column.tail<3>() = to_tool * axis(base_joint(), q).cross(full.col(i).tail<3>());
    result.conservativeResize(Eigen::NoChange, result.cols() + 1);
    result.col(result.cols() - 1) = column;
  }
  return result;
}

}  // namespace qvgen::test
