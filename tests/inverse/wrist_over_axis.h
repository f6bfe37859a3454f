// SPDX-License-Identifier: MIT
// Joints of an arm of six turns that put the centre of its wrist on its first axis, which then does nothing
// that the wrist does not do. They are found from places of the tool alone, whatever the arm's lengths are.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Core>

namespace qvgen::test {

/// The tool's position by joint values.
using ToolAt = std::function<Eigen::Vector3d(const Eigen::VectorXd&)>;

/// Returns the centre of a wrist with right angles between its axes: half a turn of its middle axis takes all
/// but what is along that axis to the other side, half a turn of its first axis takes the rest there.
inline Eigen::Vector3d wrist_centre(const ToolAt& tool, const Eigen::VectorXd& q) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const double first : {0.0, std::numbers::pi})
    for (const double middle : {0.0, std::numbers::pi}) {
      Eigen::VectorXd turned = q;
      turned[3] += first;
      turned[4] += middle;
      sum += tool(turned) / 4;
    }
  return sum;
}

/// Returns the way from the first axis to the wrist's centre.
inline Eigen::Vector3d from_first_axis(const ToolAt& tool, const Eigen::VectorXd& q) {
  Eigen::VectorXd opposite = q;
  opposite[0] += std::numbers::pi;
  return (wrist_centre(tool, q) - wrist_centre(tool, opposite)) / 2;
}

/// Turns the second joint until the wrist's centre is on the first axis. Returns false if the arm has no such
/// wrist or if the joints that are given lead to no such place.
inline bool put_wrist_over_first_axis(const ToolAt& tool, Eigen::VectorXd& q) {
  Eigen::VectorXd other = q;
  other.tail(3) += Eigen::Vector3d(0.3, 0.5, 0.7);
  if ((wrist_centre(tool, q) - wrist_centre(tool, other)).norm() > 1e-9) return false;
  const Eigen::Vector3d side = from_first_axis(tool, q).normalized();
  const auto way = [&](double second) {
    q[1] = second;
    return from_first_axis(tool, q).dot(side);
  };
  double low = q[1], high = low;
  for (int i = 0; i < 40 && way(high) > 0; ++i) high += 0.15;
  if (way(high) > 0) return false;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (way(middle) > 0 ? low : high) = middle;
  }
  q[1] = (low + high) / 2;
  return from_first_axis(tool, q).norm() < 1e-9;
}

}  // namespace qvgen::test
