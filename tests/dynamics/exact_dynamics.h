// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "exact_scalar.h"

namespace qvgen::test {

using ExactVector = Eigen::Matrix<Exact, Eigen::Dynamic, 1>;
using ExactMatrix = Eigen::Matrix<Exact, Eigen::Dynamic, Eigen::Dynamic>;

struct ExactDerivatives {
  ExactVector torque;
  ExactMatrix by_position, by_rate;
};

/// A robot whose inertias are numbers, in 60 digits.
struct ExactDynamics {
  std::string name;
  int dof = 0;
  std::function<ExactVector(const ExactVector& q, const ExactVector& qd, const ExactVector& qdd)> torque;
  std::function<ExactDerivatives(const ExactVector& q, const ExactVector& qd, const ExactVector& qdd)>
      derivatives;
  std::function<ExactMatrix(const ExactVector& q)> mass_matrix;
  std::function<ExactMatrix(const ExactVector& q, const ExactVector& qd)> coriolis_matrix;
};

inline std::vector<ExactDynamics>& exact_dynamics() {
  static std::vector<ExactDynamics> all;
  return all;
}

inline bool add_exact_dynamics(ExactDynamics robot) {
  exact_dynamics().push_back(std::move(robot));
  return true;
}

}  // namespace qvgen::test
