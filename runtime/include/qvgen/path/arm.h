// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/nearest.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/pose.h>

/// The functions of an arm that following a path needs. Six joints move; an arm of seven has one of them
/// given.
///
///     namespace robot = qvgen::robots::ur5;
///     const qvgen::path::Arm arm{
///         [](const auto& pose) { return robot::inverse_kinematics(pose); },
///         [](const auto& q) { return robot::forward_kinematics(q); },
///         [](const auto& q) { return robot::jacobian(q); }, robot::is_revolute,
///         robot::inverse_info.stable_branches};
namespace qvgen::path {

using inverse::whole_turn;

/// Values of the joints that move along the path, rad or m.
using Values = Joints<6>;

class Uncoupled;  // coupling.h

/// `Coupling` says what has limits: the joints, or motors that move them (coupling.h).
template <class Solve, class Forward, class Jacobian, class Coupling = Uncoupled>
struct Arm {
  Solve solve;        ///< pose -> all solutions, qvgen::Solutions<6, capacity>
  Forward forward;    ///< joints -> pose of the tool
  Jacobian jacobian;  ///< joints -> 6 x 6, at the tool, in the world frame, linear rows first
  JointKinds<6> revolute;
  bool stable_branches;  ///< a branch keeps its number along a path without a singularity
  Coupling coupling = {};

  using Limited = Coupling;
  using Found = decltype(std::declval<const Solve&>()(std::declval<const Pose<double>&>()));
  static constexpr int capacity = Found::max_size;
};

template <class Solve, class Forward, class Jacobian>
Arm(Solve, Forward, Jacobian, JointKinds<6>, bool) -> Arm<Solve, Forward, Jacobian>;
template <class Solve, class Forward, class Jacobian, class Coupling>
Arm(Solve, Forward, Jacobian, JointKinds<6>, bool, Coupling) -> Arm<Solve, Forward, Jacobian, Coupling>;

/// Difference of two values of each joint: of turns the one in [-pi, pi].
inline Values difference(const Values& to, const Values& from, const JointKinds<6>& revolute) {
  Values off = to - from;
  for (int i = 0; i < 6; ++i)
    if (revolute[static_cast<std::size_t>(i)]) off[i] = without_turns(off[i]);
  return off;
}

}  // namespace qvgen::path
