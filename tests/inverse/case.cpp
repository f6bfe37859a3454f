// SPDX-License-Identifier: MIT
#include "case.h"

#include <cmath>

namespace qvgen::test {

Case::Case(const InverseUnderTest& robot)
    : robot_(robot), chain_(reference::load(robot.description, robot.geometry)) {}

Eigen::VectorXd Case::joints() {
  return Eigen::VectorXd::NullaryExpr(robot_.dof, [this] { return uniform(-pi, pi); });
}

Case::Miss Case::miss(const Eigen::VectorXd& q, const Eigen::Isometry3d& target) const {
  const Eigen::Isometry3d reached = tool(q);
  Miss result{(reached.translation() - target.translation()).norm(), 0};
  // |R - R'| = 2 sqrt(2) sin(angle/2): no loss of digits at small angles, unlike the trace.
  const double gap = (reached.linear() - target.linear()).norm();
  if (robot_.info.uses_orientation) result.orientation = 2 * std::asin(std::min(1.0, gap / std::sqrt(8.0)));
  return result;
}

Eigen::VectorXd Case::residual(const Eigen::VectorXd& q, const Eigen::Isometry3d& target) const {
  const Eigen::Isometry3d reached = tool(q);
  Eigen::VectorXd result(robot_.info.uses_orientation ? 6 : 3);
  result.head<3>() = target.translation() - reached.translation();
  if (!robot_.info.uses_orientation) return result;
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
  Eigen::MatrixXd result(robot_.info.uses_orientation ? 6 : 3, 0);
  for (int i = 0; i < dof(); ++i) {
    if (i == robot_.info.given_joint) continue;
    result.conservativeResize(Eigen::NoChange, result.cols() + 1);
    result.col(result.cols() - 1) = full.col(i).head(result.rows());
  }
  return result;
}

}  // namespace qvgen::test
