// SPDX-License-Identifier: MIT
// Weighted least squares over the equations of all joints. Each joint's noise is estimated with the
// parameters, from its residuals and the degrees of freedom that these have left; its equations are weighted
// by it. What the data cannot tell apart is found by a pivoted factorisation of the columns, each scaled to
// length one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/equations.h"

namespace qvgen::identify {

struct Estimate {
  Eigen::VectorXd value;      ///< one for each parameter; zero for those that the data do not tell
  Eigen::VectorXd deviation;  ///< standard deviations; zero for those
  Eigen::MatrixXd covariance;
  Eigen::VectorXd noise;  ///< standard deviation of each joint's residual, Nm or N; 0: the joint has no rows
  std::vector<Eigen::Index> measured;  ///< rows of each joint
  double condition = 0;                ///< of the weighted columns, scaled to length one, that are told apart
  std::vector<bool> told;  ///< false for parameters that show only as parts of others, or not at all
  /// Row k has the factors with which parameter k, if it is not told, is part of those that are.
  Eigen::MatrixXd parts;
  /// The weighted equations: |information * (p - value)|^2 is what a change adds to the weighted squares. For
  /// every parameter, those that are not told included. With `right_side` = information * value.
  Eigen::MatrixXd information;
  Eigen::VectorXd right_side;
};

/// Columns are dependent if less than this share of their length is left; data of that kind tell nothing.
inline constexpr double dependent_share = 1e-7;

/// Solves the equations. With `noise` the joints' standard deviations are given, else they are estimated.
/// Throws std::runtime_error if a joint has fewer rows than it has parameters to tell.
Estimate estimate(const Equations& equations, Eigen::Index parameters,
                  const std::optional<Eigen::VectorXd>& noise = std::nullopt);

/// Returns the root mean square of each joint's residual with these parameters, Nm or N.
Eigen::VectorXd residuals(const Equations& equations, const Eigen::VectorXd& parameters);
/// Returns the root mean square of each joint's torque.
Eigen::VectorXd torque_levels(const Equations& equations);

}  // namespace qvgen::identify
