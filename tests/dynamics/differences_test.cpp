// SPDX-License-Identifier: MIT
// Generated derivatives of the inverse dynamics against central differences with a step of 1e-20 in 60
// digits: truncation and rounding are both near 1e-40, so what is left are the doubles into which a
// description's numbers were rounded.
#include <random>

#include <gtest/gtest.h>

#include "exact_dynamics.h"

namespace {

using namespace qvgen::test;

class DynamicsDifferences : public testing::TestWithParam<ExactDynamics> {
 protected:
  ExactVector random() {
    std::uniform_real_distribution<double> number(-2, 2);
    return ExactVector::NullaryExpr(GetParam().dof, [&] { return Exact(number(random_)); });
  }

 private:
  std::mt19937_64 random_{21};
};

double largest(const ExactMatrix& m) {
  double result = 0;
  for (Eigen::Index i = 0; i < m.size(); ++i) result = std::max(result, std::abs(static_cast<double>(m(i))));
  return result;
}

void expect_close(const ExactMatrix& found, const ExactMatrix& expected) {
  EXPECT_LE(largest(found - expected), 1e-14 * (1 + largest(expected)));
}

TEST_P(DynamicsDifferences, DerivativesAreTheDifferencesOfTheForces) {
  const ExactDynamics& robot = GetParam();
  const Exact step = Exact::power_of_ten(-20);
  const Exact per_step = Exact(0.5) / step;
  for (int k = 0; k < 5; ++k) {
    const ExactVector q = random(), qd = random(), qdd = random();
    const ExactDerivatives found = robot.derivatives(q, qd, qdd);
    expect_close(found.torque, robot.torque(q, qd, qdd));
    for (int i = 0; i < robot.dof; ++i) {
      ExactVector change = ExactVector::Constant(robot.dof, Exact(0.0));
      change[i] = step;
      expect_close(found.by_position.col(i),
                   (robot.torque(q + change, qd, qdd) - robot.torque(q - change, qd, qdd)) * per_step);
      expect_close(found.by_rate.col(i),
                   (robot.torque(q, qd + change, qdd) - robot.torque(q, qd - change, qdd)) * per_step);
      expect_close(robot.mass_matrix(q).col(i),
                   (robot.torque(q, qd, qdd + change) - robot.torque(q, qd, qdd - change)) * per_step);
    }
  }
}

/// C is half of the derivative of the forces that it stands for, the forces of gravity apart.
TEST_P(DynamicsDifferences, CoriolisMatrixIsHalfTheDerivativeByTheRates) {
  for (int k = 0; k < 5; ++k) {
    const ExactVector q = random(), qd = random();
    const ExactVector none = ExactVector::Constant(GetParam().dof, Exact(0.0));
    expect_close(GetParam().coriolis_matrix(q, qd), GetParam().derivatives(q, qd, none).by_rate * Exact(0.5));
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, DynamicsDifferences, testing::ValuesIn(exact_dynamics()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
