// SPDX-License-Identifier: MIT
// Generated Jacobians and their derivatives against central differences with a step of 1e-20 in 60 digits:
// truncation and rounding are both near 1e-40, so what is left are the doubles into which a description's
// numbers were rounded.
#include <random>

#include <gtest/gtest.h>

#include "exact_robot.h"

namespace {

using namespace qvgen::test;

/// Constants of the geometry and their sums and products are rounded to double each: some roundings of 1e-16.
constexpr double tolerance = 2e-15;

class Differences : public testing::TestWithParam<ExactRobot> {
 protected:
  ExactVector random() {
    std::uniform_real_distribution<double> number(-2, 2);
    return ExactVector::NullaryExpr(GetParam().dof, [&] { return Exact(number(random_)); });
  }
  const Exact step = Exact::power_of_ten(-20);

 private:
  std::mt19937_64 random_{20};
};

double largest(const ExactMatrix& m) {
  double result = 0;
  for (Eigen::Index i = 0; i < m.size(); ++i) result = std::max(result, std::abs(static_cast<double>(m(i))));
  return result;
}

template <class Function>
ExactMatrix derivative(const Function& function, const ExactVector& q, const ExactVector& direction,
                       const Exact& step) {
  const ExactVector change = direction * step;
  const ExactMatrix difference = function(q + change) - function(q - change);
  return difference * (Exact(0.5) / step);
}

TEST_P(Differences, JacobianIsTheDerivativeOfTheTransform) {
  for (int k = 0; k < 10; ++k) {
    const ExactVector q = random();
    const ExactMatrix jacobian = GetParam().jacobian(q);
    const ExactMatrix rotation = GetParam().transform(q).topLeftCorner(3, 3);
    for (int i = 0; i < GetParam().dof; ++i) {
      ExactVector unit = ExactVector::Constant(GetParam().dof, Exact(0.0));
      unit[i] = Exact(1.0);
      const ExactMatrix change = derivative(GetParam().transform, q, unit, step);
      const ExactMatrix spin = change.topLeftCorner(3, 3) * rotation.transpose();
      ExactMatrix expected(6, 1);
      expected << change(0, 3), change(1, 3), change(2, 3), spin(2, 1), spin(0, 2), spin(1, 0);
      EXPECT_LT(largest(jacobian.col(i) - expected), tolerance) << "column " << i;
    }
  }
}

TEST_P(Differences, TimeDerivativesOfTheJacobian) {
  for (int k = 0; k < 10; ++k) {
    const ExactVector q = random();
    const ExactVector qd = random();
    const ExactMatrix rate = derivative(GetParam().jacobian, q, qd, step);
    EXPECT_LT(largest(GetParam().jacobian_dot(q, qd) - rate), 10 * tolerance);
    EXPECT_LT(largest(GetParam().jacobian_dot_times_qd(q, qd) - rate * qd), 100 * tolerance);
    EXPECT_LT(largest(GetParam().velocity(q, qd) - GetParam().jacobian(q) * qd), 10 * tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Differences, testing::ValuesIn(exact_robots()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
