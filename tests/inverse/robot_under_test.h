// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <qvgen/inverse/branch.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/tasks.h>
#include <qvgen/pose.h>

#include "reference/expression.h"

namespace qvgen::test {

struct Row {
  Eigen::VectorXd q;
  int branch = 0;
  bool continuum = false;
};

struct Found {
  Status status = Status::invalid;
  std::vector<Row> rows;
  inverse::Effort effort = {};
};

template <class SolutionSet>
Found copy(const SolutionSet& set) {
  Found found{set.status, {}, set.effort};
  for (const auto& row : set) found.rows.push_back({row.q, row.branch, row.continuum});
  return found;
}

/// The compiled functions of one robot, whatever its types; the values are those of geometric constants by
/// name, the defaults for others. Pointers: what std::function makes of each lambda takes longest to compile.
/// The first two may hold an arm that is known at run time alone; others give them pointers, too.
struct InverseFunctions {
  using Vector = Eigen::VectorXd;
  using Values = reference::Values;
  std::function<Found(const Pose<double>&, double given, double tolerance, const Values&)> solve;
  std::function<Found(const Pose<double>&, double given, const Vector& seed, const Values&)> solve_from;
  Found (*solve_matrix)(const Eigen::Matrix3d&, const Eigen::Vector3d&, double given) = nullptr;
  Found (*solve_within)(const Pose<double>&, double given, const Vector& lower,
                        const Vector& upper) = nullptr;
  Found (*solve_scalar)(const Pose<double>&, double given, double tolerance, const Values&) = nullptr;
  /// The one solution on the seed's branch.
  Found (*solve_near)(const Pose<double>&, double given, const Vector& seed, double tolerance,
                      const Values&) = nullptr;
  /// Rows by the pitch itself, of arms that are asked for one: their main entry takes it from a pose.
  Found (*solve_pitch)(const Eigen::Vector3d& position, double pitch, double given) = nullptr;
  /// Rows by the direction of the first axis that the tool sees, of arms that are asked for an inclination.
  Found (*solve_inclination)(const Eigen::Vector3d& position, const Eigen::Vector3d& up,
                             double given) = nullptr;
  /// Whole poses of arms that are asked for less, with and without a seed.
  Found (*solve_pose)(const Pose<double>&, double tolerance) = nullptr;
  Found (*solve_pose_from)(const Pose<double>&, const Vector& seed) = nullptr;
};

/// Returns the argument of a robot's main entry for a pose: not a number where the pose is invalid, which a
/// task would hide.
template <Task task>
auto asked(const Pose<double>& pose, const InverseInfo& info) {
  const bool valid = pose.position.allFinite() && std::abs(pose.orientation.squaredNorm() - 1) < 1e-3;
  const double scale = valid ? 1 : std::numeric_limits<double>::quiet_NaN();
  [[maybe_unused]] const Eigen::Vector3d direction =
      scale * (pose.normalised().orientation * Eigen::Vector3d(info.tool_axis));
  if constexpr (task == Task::position_and_direction)
    return PositionAndDirection<double>{pose.position, direction};
  else if constexpr (task == Task::direction)
    return Direction<double>{direction};
  else if constexpr (task == Task::orientation)
    return Eigen::Quaterniond(Eigen::Vector4d(scale * pose.orientation.coeffs()));
  else
    return pose;
}

/// The generated inverse kinematics of one robot behind one type.
struct InverseUnderTest {
  std::string name;
  std::string description;  ///< path of the robot's description
  int dof = 0;
  InverseInfo info;
  std::vector<std::string> constants;  ///< names of the geometric constants
  InverseFunctions functions;
  reference::Values geometry = {};  ///< constants with other values than the defaults
  bool asks_whole_poses = false;    ///< of an arm whose main entry is asked for less

  [[nodiscard]] Found solve(const Pose<double>& pose, double given, double tolerance) const {
    if (asks_whole_poses) return functions.solve_pose(pose, tolerance);
    return functions.solve(pose, given, tolerance, geometry);
  }
  /// One branch after the other, also where there is a vector form.
  [[nodiscard]] Found solve_scalar(const Pose<double>& pose, double given, double tolerance) const {
    return functions.solve_scalar(pose, given, tolerance, geometry);
  }
  [[nodiscard]] Found solve_from(const Pose<double>& pose, double given, const Eigen::VectorXd& seed) const {
    if (asks_whole_poses) return functions.solve_pose_from(pose, seed);
    return functions.solve_from(pose, given, seed, geometry);
  }
  [[nodiscard]] Found solve_near(const Pose<double>& pose, double given, const Eigen::VectorXd& seed,
                                 double tolerance = inverse::default_tolerance) const {
    return functions.solve_near(pose, given, seed, tolerance, geometry);
  }
  [[nodiscard]] Found solve_matrix(const Eigen::Matrix3d& r, const Eigen::Vector3d& p, double given) const {
    return functions.solve_matrix(r, p, given);
  }
  [[nodiscard]] Found solve_within(const Pose<double>& pose, double given, const Eigen::VectorXd& lower,
                                   const Eigen::VectorXd& upper) const {
    return functions.solve_within(pose, given, lower, upper);
  }
};

/// For GoogleTest's messages.
inline void PrintTo(const InverseUnderTest& robot, std::ostream* stream) { *stream << robot.name; }

inline std::vector<InverseUnderTest>& inverses() {
  static std::vector<InverseUnderTest> all;
  return all;
}

inline bool add_inverse(InverseUnderTest robot) {
  inverses().push_back(std::move(robot));
  return true;
}

}  // namespace qvgen::test
