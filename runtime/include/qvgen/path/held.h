// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <qvgen/path/arm.h>

/// An arm of seven joints, one of which stays where it is, as an arm of six.
namespace qvgen::path {

/// One of seven joints that is held at a value.
struct Held {
  int joint;     ///< index, from 0
  double value;  ///< rad or m

  /// The seven joints of six.
  [[nodiscard]] Joints<7> with(const Values& q) const {
    Joints<7> all;
    all << q.head(joint), value, q.tail(6 - joint);
    return all;
  }
  /// Six joints of seven.
  [[nodiscard]] Values without(const Joints<7>& q) const {
    Values others;
    others << q.head(joint), q.tail(6 - joint);
    return others;
  }
  [[nodiscard]] Eigen::Matrix<double, 6, 6> without_column(
      const Eigen::Matrix<double, 6, 7>& jacobian) const {
    Eigen::Matrix<double, 6, 6> others;
    others << jacobian.leftCols(joint), jacobian.rightCols(6 - joint);
    return others;
  }
  template <int capacity>
  [[nodiscard]] Solutions<6, capacity> without(const Solutions<7, capacity>& found) const {
    Solutions<6, capacity> others;
    others.status = found.status;
    others.effort = found.effort;
    for (const Solution<7>& row : found) inverse::append(others, without(row.q), row.branch, row.continuum);
    return others;
  }
  [[nodiscard]] JointLimits<6> without(const JointLimits<7>& limits) const {
    return {without(limits.lower), without(limits.upper)};
  }
  [[nodiscard]] JointKinds<6> without(const JointKinds<7>& revolute) const {
    JointKinds<6> others{};
    for (std::size_t i = 0, k = 0; i < 7; ++i)
      if (static_cast<int>(i) != joint) others[k++] = revolute[i];
    return others;
  }
};

}  // namespace qvgen::path
