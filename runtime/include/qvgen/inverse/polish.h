// SPDX-License-Identifier: MIT
// Newton's steps with the points that they are for.
#pragma once

#include <qvgen/inverse/newton.h>

namespace qvgen::inverse {
namespace polishing {

template <typename Scalar, std::size_t joints, std::size_t points>
class Newton {
 public:
  using Values = JointValues<Scalar, joints>;
  using Result = inverse::Reached<Scalar, joints, points>;

  explicit Newton(const PointMatching<Scalar, joints, points>& task) : task_(task) {}

  [[nodiscard]] Result reached(const Values& values) const { return reached_place(task_, values); }
  [[nodiscard]] Steps<Scalar, joints> following(const Result& at, std::size_t joint, const Scalar& by) const {
    return polishing::following(at, joint, by);
  }
  [[nodiscard]] static Dependent<Scalar, joints> idle(const Result& at) { return idle_joints(at); }
  void advance(std::size_t i, const Scalar& by, Values& values) const {
    inverse::advance(task_, i, by, values);
  }

 private:
  const PointMatching<Scalar, joints, points>& task_;
};

}  // namespace polishing

/// Polishes joint values by up to a thousand evaluations; true if they reach the goal.
template <typename Scalar, std::size_t joints, std::size_t points>
bool polish(const PointMatching<Scalar, joints, points>& task, double allowed,
            JointValues<Scalar, joints>& values, const Held<joints>& held = {}) {
  Budget budget{0, 1000};
  Reached<Scalar, joints, points> reached;
  return polish(task, {allowed}, values, reached, budget, held);
}

}  // namespace qvgen::inverse
