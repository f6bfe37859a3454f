// SPDX-License-Identifier: MIT
// The singular configurations of the six-joint arms are exactly the zeros of their singularity measures.
#include <algorithm>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "reference/linear_algebra.h"
#include "robot_under_test.h"

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using qvgen::test::RobotUnderTest;

std::vector<RobotUnderTest> six_joint_robots() {
  std::vector<RobotUnderTest> result;
  for (const RobotUnderTest& robot : qvgen::test::robots())
    if (robot.dof == 6) result.push_back(robot);
  return result;
}

class Singularities : public testing::TestWithParam<RobotUnderTest> {
 protected:
  VectorXd random() {
    std::uniform_real_distribution<double> number(-3, 3);
    return VectorXd::NullaryExpr(6, [&] { return number(random_); });
  }
  double smallest(const VectorXd& q) const {
    return reference::smallest_singular_value(GetParam().jacobian(q));
  }
  double least_measure(const VectorXd& q) const {
    return GetParam().singularity_measures(q).cwiseAbs().minCoeff();
  }

  /// Steps along random directions, longer after a success and shorter after a failure.
  VectorXd minimised(VectorXd q) {
    std::normal_distribution<double> normal;
    double best = smallest(q);
    double step = 0.3;
    for (int i = 0; i < 4000 && best > 1e-13 && step > 1e-15; ++i) {
      const VectorXd direction = VectorXd::NullaryExpr(6, [&] { return normal(random_); });
      bool improved = false;
      for (const double sign : {1.0, -1.0}) {
        const VectorXd candidate = q + sign * step * direction;
        const double value = smallest(candidate);
        if (value >= best) continue;
        best = value;
        q = candidate;
        improved = true;
        break;
      }
      step *= improved ? 1.5 : 0.8;
    }
    return q;
  }

 private:
  std::mt19937_64 random_{7};
};

/// From random starts the smallest singular value is driven to zero; at each zero found a measure must
/// vanish. The smallest singular value is at most a few times the least measure and at least a small part of
/// it, where the other measures and the arm are of size one, so 1e-9 in one is below 1e-5 in the other unless
/// the condition is missing from the list (double zeros, d3^2, halve the digits).
TEST_P(Singularities, EveryMinimiserIsOnTheList) {
  int found = 0;
  for (int start = 0; start < 25; ++start) {
    const VectorXd q = minimised(random());
    if (smallest(q) > 1e-10) continue;
    ++found;
    EXPECT_LT(least_measure(q), 1e-5)
        << q.transpose() << " measures " << GetParam().singularity_measures(q).transpose();
  }
  EXPECT_GE(found, 8);
}

/// A measure that changes sign along a line vanishes in between, and there the Jacobian must be singular.
TEST_P(Singularities, EveryZeroOfAMeasureIsSingular) {
  const Eigen::Index count = GetParam().singularity_measures(random()).size();
  std::vector<int> zeros(static_cast<std::size_t>(count), 0);
  for (int line = 0; line < 200; ++line) {
    VectorXd a = random();
    VectorXd b = random();
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto measure = [&](const VectorXd& q) { return GetParam().singularity_measures(q)[k]; };
      VectorXd low = a;
      VectorXd high = b;
      if (measure(low) * measure(high) >= 0) continue;
      for (int i = 0; i < 60; ++i) {
        const VectorXd middle = (low + high) / 2;
        (measure(low) * measure(middle) <= 0 ? high : low) = middle;
      }
      ++zeros[static_cast<std::size_t>(k)];
      EXPECT_LT(smallest(low), 1e-12) << "measure " << k << " at " << low.transpose();
    }
  }
  // A factor such as l2 - d4 sin(theta3) has no zeros for some lengths; the wrist's always has.
  EXPECT_GT(*std::max_element(zeros.begin(), zeros.end()), 0);
}

TEST(SingularityMeasures, HaveDifferentNames) {
  for (const RobotUnderTest& robot : qvgen::test::robots()) {
    const std::set<std::string> names(robot.singularity_names.begin(), robot.singularity_names.end());
    EXPECT_EQ(names.size(), robot.singularity_names.size()) << robot.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Singularities, testing::ValuesIn(six_joint_robots()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
