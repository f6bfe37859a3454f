// SPDX-License-Identifier: MIT
#include "asked_part.h"

#include <algorithm>
#include <cmath>

#include "reference/linear_algebra.h"

namespace qvgen::test {

using Eigen::Vector3d;

AskedArm::AskedArm(const std::string& description, Task task, const Vector3d& tool_axis,
                   std::vector<int> given)
    : chain_(reference::load(description)), task_(task), tool_axis_(tool_axis), given_(std::move(given)) {}

bool AskedArm::is_given(std::size_t joint) const {
  return std::find(given_.begin(), given_.end(), static_cast<int>(joint)) != given_.end();
}

std::size_t AskedArm::turn_from(std::size_t joint) const {
  while (is_given(joint) || !chain_.joints.at(joint).revolute) ++joint;
  return joint;
}

bool AskedArm::slides_besides_given() const {
  for (std::size_t i = 0; i < chain_.joints.size(); ++i)
    if (!chain_.joints[i].revolute && !is_given(i)) return true;
  return false;
}

Vector3d AskedArm::axis(const VectorXd& q, std::size_t joint) const {
  return reference::joint_places(chain_, q)[joint].axis;
}

Part AskedArm::part(const VectorXd& q) const {
  const Eigen::Isometry3d pose = tool(q);
  Part part{pose.translation()};
  const Vector3d along = pose.linear() * tool_axis_;
  if (task_ == Task::pose) part.orientation = Eigen::Quaterniond(pose.linear());
  if (task_ == Task::position_and_direction) part.direction = along;
  if (task_ == Task::position_and_inclination)
    part.direction = pose.linear().transpose() * axis(q, turn_from(0));
  if (task_ == Task::position_and_pitch) {
    const std::size_t base = turn_from(0);
    const Vector3d up = axis(q, base), across = axis(q, turn_from(base + 1));
    part.pitch = std::atan2(across.dot(up.cross(along)), up.cross(across).dot(along.cross(across)));
  }
  return part;
}

bool AskedArm::serves(const VectorXd& q) const {
  if (task_ == Task::position_and_pitch) {
    const std::size_t base = turn_from(0);
    const Vector3d across = axis(q, turn_from(base + 1)), along = tool(q).linear() * tool_axis_;
    return axis(q, base).cross(across).norm() > 1e-6 && along.cross(across).norm() > 1e-6;
  }
  return true;
}

double AskedArm::gap(const VectorXd& a, const VectorXd& b) const {
  const Part one = part(a), other = part(b);
  return std::max({(one.position - other.position).norm(), (one.direction - other.direction).norm(),
                   one.orientation.angularDistance(other.orientation),
                   std::abs(std::remainder(one.pitch - other.pitch, 2 * M_PI))});
}

double AskedArm::way(const VectorXd& a, const VectorXd& b) const {
  double most = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const double apart = a[i] - b[i];
    const bool turns = chain_.joints[static_cast<std::size_t>(i)].revolute;
    if (const double off = std::abs(turns ? std::remainder(apart, 2 * M_PI) : apart); !(off <= most))
      most = std::isnan(off) ? infinity : off;
  }
  return most;
}

}  // namespace qvgen::test
