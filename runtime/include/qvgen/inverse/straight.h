// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/inverse/polish.h>
#include <qvgen/inverse/whole_arm.h>

namespace qvgen::inverse {

/// Joint values at which the axes before and behind a joint are in line, as those of a wrist are: there the
/// joints of these axes do the same. Closed forms take a wrist for regular up to rounding, and leave its
/// first joint anywhere.
template <int dof>
class Straight {
 public:
  explicit Straight(const ArmAtZero<dof>& arm) {
    for (int i = 1; i + 1 < dof; ++i) add(arm, i);
  }

  /// True if some joint is next to such a value, or to the opposite one.
  [[nodiscard]] bool holds(const Joints<dof>& q) const {
    constexpr double next_to = tolerance::idle;
    for (int i = 1; i + 1 < dof; ++i)
      if (exists_[i] && std::abs(without_turns(2 * (q[i] - value_[i]))) < next_to) return true;
    return false;
  }

 private:
  void add(const ArmAtZero<dof>& arm, int i) {
    const auto at = [&](int joint) { return arm.joints[static_cast<std::size_t>(joint)]; };
    exists_[i] = false;
    if (!at(i - 1).revolute || !at(i).revolute || !at(i + 1).revolute) return;
    const Triple<double>& axis = at(i).axis;
    const Triple<double> before = cross(axis, at(i - 1).axis), behind = cross(axis, at(i + 1).axis);
    const double inclined = dot(before, before), also = dot(behind, behind);
    exists_[i] = inclined > tolerance::inclined && std::abs(inclined - also) < tolerance::inclined;
    value_[i] = exists_[i] ? std::atan2(dot(axis, cross(behind, before)), dot(behind, before)) : 0;
  }

  bool exists_[dof];
  double value_[dof];
};

}  // namespace qvgen::inverse
