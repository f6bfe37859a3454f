// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <qvgen/inverse/solutions.h>
#include <qvgen/pose.h>

namespace qvgen::test {

struct Row {
  Eigen::VectorXd q;
  int branch = 0;
  bool continuum = false;
};

struct Found {
  Status status = Status::invalid;
  std::vector<Row> rows;
};

template <class SolutionSet>
Found copy(const SolutionSet& set) {
  Found found{set.status, {}};
  for (const auto& row : set) found.rows.push_back({row.q, row.branch, row.continuum});
  return found;
}

/// The generated inverse kinematics of one robot behind one type; geometry is that of the defaults.
struct InverseUnderTest {
  std::string name;
  std::string robot;
  int dof = 0;
  InverseInfo info;
  std::function<Found(const Pose<double>&, double given, double tolerance)> solve;
  std::function<Found(const Pose<double>&, double given, const Eigen::VectorXd& seed)> solve_from;
  std::function<Found(const Eigen::Matrix3d&, const Eigen::Vector3d&, double given)> solve_matrix;
  std::function<Found(const Pose<double>&, double given, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper)> solve_within;
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
