// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "exact_scalar.h"

namespace qvgen::test {

using ExactVector = Eigen::Matrix<Exact, Eigen::Dynamic, 1>;
using ExactMatrix = Eigen::Matrix<Exact, Eigen::Dynamic, Eigen::Dynamic>;

struct ExactRobot {
  std::string name;
  int dof = 0;
  std::function<ExactMatrix(const ExactVector& q)> transform;  ///< 4 x 4
  std::function<ExactMatrix(const ExactVector& q)> jacobian;
  std::function<ExactVector(const ExactVector& q, const ExactVector& qd)> velocity;
  std::function<ExactMatrix(const ExactVector& q, const ExactVector& qd)> jacobian_dot;
  std::function<ExactVector(const ExactVector& q, const ExactVector& qd)> jacobian_dot_times_qd;
};

inline std::vector<ExactRobot>& exact_robots() {
  static std::vector<ExactRobot> all;
  return all;
}

inline bool add_exact_robot(ExactRobot robot) {
  exact_robots().push_back(std::move(robot));
  return true;
}

}  // namespace qvgen::test
