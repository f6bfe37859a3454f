// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>

#include "robot_under_test.h"

namespace qvgen::test {

/// The arm's constants: defaults but for those that are given by name.
template <class Arm>
typename Arm::Geometry geometry_of(const reference::Values& given) {
  using Geometry = typename Arm::Geometry;
  constexpr std::size_t count = Arm::geometry_names.size();
  if constexpr (count == 0) {
    return {};
  } else {
    using Numbers = std::array<double, count>;
    static_assert(sizeof(Geometry) == sizeof(Numbers));
    auto numbers = std::bit_cast<Numbers>(Geometry{});
    for (std::size_t i = 0; i < count; ++i)
      if (const auto value = given.find(Arm::geometry_names[i]); value != given.end())
        numbers[i] = value->second;
    return std::bit_cast<Geometry>(numbers);
  }
}

/// Calls of an arm: the given joint's value stands behind the task, if there is such a joint.
template <class Arm>
struct Calls {
  template <class... Rest>
  static Found solve(double given, const Pose<double>& pose, const Rest&... rest) {
    const auto task = asked<Arm::info.task>(pose, Arm::info);
    if constexpr (Arm::info.given_joint >= 0)
      return copy(Arm::inverse(task, given, rest...));
    else
      return copy(Arm::inverse(task, rest...));
  }
  static Found of_matrix(double given, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& position) {
    if constexpr (Arm::info.given_joint >= 0)
      return copy(Arm::inverse(rotation, position, given));
    else
      return copy(Arm::inverse(rotation, position));
  }
  template <class... Rest>
  static Found near(double given, const Pose<double>& pose, const typename Arm::Joints& seed,
                    const Rest&... rest) {
    const auto task = asked<Arm::info.task>(pose, Arm::info);
    if constexpr (Arm::info.given_joint >= 0)
      return copy(Arm::near(task, given, seed, rest...));
    else
      return copy(Arm::near(task, seed, rest...));
  }
};

/// Puts the functions of an arm (robot.cpp.in) behind one type, whether or not a joint's value is given.
template <class Arm>
bool register_inverse() {
  using Of = Calls<Arm>;
  InverseFunctions functions;
  functions.solve =
      +[](const Pose<double>& pose, double given, double tolerance, const reference::Values& values) {
        return Of::solve(given, pose, geometry_of<Arm>(values), tolerance);
      };
  functions.solve_from = +[](const Pose<double>& pose, double given, const Eigen::VectorXd& seed,
                             const reference::Values& values) {
    return Of::solve(given, pose, typename Arm::Joints(seed), geometry_of<Arm>(values));
  };
  constexpr bool takes_poses = Arm::info.task == Task::pose || Arm::info.task == Task::position ||
                               Arm::info.task == Task::position_and_pitch ||
                               Arm::info.task == Task::position_and_inclination;
  if constexpr (takes_poses) {
    functions.solve_matrix = [](const Eigen::Matrix3d& rotation, const Eigen::Vector3d& position,
                                double given) { return Of::of_matrix(given, rotation, position); };
  } else {
    functions.solve_pose = [](const Pose<double>& pose, double tolerance) {
      return copy(Arm::inverse(pose, typename Arm::Geometry{}, tolerance));
    };
    functions.solve_pose_from = [](const Pose<double>& pose, const Eigen::VectorXd& seed) {
      return copy(Arm::inverse(pose, typename Arm::Joints(seed)));
    };
  }
  functions.solve_within = [](const Pose<double>& pose, double given, const Eigen::VectorXd& lower,
                              const Eigen::VectorXd& upper) {
    return Of::solve(given, pose, JointLimits<Arm::dof>{lower, upper});
  };
  functions.solve_scalar = [](const Pose<double>& pose, double given, double tolerance,
                              const reference::Values& values) {
    return Of::solve(given, pose, geometry_of<Arm>(values), tolerance, inverse::Form::scalar);
  };
  if constexpr (Arm::has_near) {
    functions.solve_near = [](const Pose<double>& pose, double given, const Eigen::VectorXd& seed,
                              double tolerance, const reference::Values& values) {
      return Of::near(given, pose, typename Arm::Joints(seed), geometry_of<Arm>(values), tolerance);
    };
  }
  std::vector<std::string> constants(Arm::geometry_names.begin(), Arm::geometry_names.end());
  return add_inverse({Arm::name, Arm::description, Arm::dof, Arm::info, constants, functions});
}

}  // namespace qvgen::test
