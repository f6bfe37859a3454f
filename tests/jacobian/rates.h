// SPDX-License-Identifier: MIT
// Rates of arms with so many joints by the runtime's templates, whose Eigen types take long to compile:
// defined here, and compiled once for each number of joints, in rates.cpp, which CMake writes.
#pragma once

#include <qvgen/inverse_velocity_within.h>

#include "robot_under_test.h"

namespace qvgen::test {

template <int dof>
JointRates RatesOf<dof>::of_the_whole(const Jacobian& jacobian, const VectorXd& twist) {
  const auto result = inverse_velocity<double, dof>(jacobian, Twist(twist));
  return {result.status, result.qd, result.residual};
}

template <int dof>
LimitedRates RatesOf<dof>::scaled(const InverseVelocity<double, dof>& rates, const VectorXd& lower,
                                  const VectorXd& upper) {
  const auto result = scaled_to_limits(rates, RateLimits<double, dof>{lower, upper});
  return {{result.status, result.qd, result.residual}, result.factor};
}

template <int dof>
LimitedRates RatesOf<dof>::within(const Jacobian& jacobian, const VectorXd& twist, const VectorXd& lower,
                                  const VectorXd& upper) {
  const RateLimits<double, dof> limits{lower, upper};
  const auto result = inverse_velocity_within<double, dof>(jacobian, Twist(twist), limits);
  return {{result.status, result.qd, result.residual}, 1, result.limited};
}

}  // namespace qvgen::test
