// SPDX-License-Identifier: MIT
// Compiled Jacobians of every robot against cross products along an independent chain of homogeneous
// matrices.
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "reference/load.h"
#include "robot_under_test.h"

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using qvgen::test::RobotUnderTest;

constexpr int configurations = 2000;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Some hundred roundings of values up to the reach, those of the reference included.
constexpr double few_roundings = 200 * epsilon;

reference::Chain chain_of(const RobotUnderTest& robot) {
  return reference::load(std::string(QVGEN_SOURCE_DIR) + "/generator/robots/" + robot.name + ".toml");
}

class JacobianOf : public testing::TestWithParam<RobotUnderTest> {
 protected:
  VectorXd random(double size = 3.1415926535897931) {
    std::uniform_real_distribution<double> number(-size, size);
    return VectorXd::NullaryExpr(GetParam().dof, [&] { return number(random_); });
  }
  /// Lengths of the arms are about one metre and prismatic joints reach as far as q says.
  static double scale(const VectorXd& q) { return 2 + q.cwiseAbs().sum(); }

 private:
  std::mt19937_64 random_{5};
};

double largest(const MatrixXd& m) { return m.cwiseAbs().maxCoeff(); }

TEST_P(JacobianOf, IsThatOfTheReferenceChain) {
  const reference::Chain chain = chain_of(GetParam());
  for (int i = 0; i < configurations; ++i) {
    const VectorXd q = random();
    const MatrixXd expected = reference::jacobian(chain, q);
    ASSERT_LT(largest(GetParam().jacobian(q) - expected), few_roundings * scale(q)) << q.transpose();
    ASSERT_LT(largest(GetParam().jacobian_with_angles_given(q) - expected), few_roundings * scale(q));
  }
}

TEST_P(JacobianOf, InToolFrameIsTurned) {
  const reference::Chain chain = chain_of(GetParam());
  for (int i = 0; i < configurations; ++i) {
    const VectorXd q = random();
    const Eigen::Matrix3d back = reference::forward_kinematics(chain, q).linear().transpose();
    MatrixXd expected = reference::jacobian(chain, q);
    expected.topRows<3>() = back * expected.topRows<3>();
    expected.bottomRows<3>() = back * expected.bottomRows<3>();
    ASSERT_LT(largest(GetParam().tool_jacobian(q) - expected), few_roundings * scale(q)) << q.transpose();
  }
}

TEST_P(JacobianOf, AtAPointIsThatOfAMovedTool) {
  reference::Chain chain = chain_of(GetParam());
  const Eigen::Isometry3d tool = chain.tool;
  for (int i = 0; i < configurations; ++i) {
    const VectorXd q = random();
    const Eigen::Vector3d point = Eigen::Vector3d(0.3, -0.2, 0.1) * (i % 5);
    chain.tool = tool * Eigen::Translation3d(point);
    ASSERT_LT(largest(GetParam().jacobian_at(q, point) - reference::jacobian(chain, q)),
              few_roundings * scale(q));
  }
}

TEST_P(JacobianOf, ComesWithTheTransform) {
  const reference::Chain chain = chain_of(GetParam());
  for (int i = 0; i < configurations; ++i) {
    const VectorXd q = random();
    const auto [transform, jacobian] = GetParam().both(q);
    ASSERT_LT(largest(transform.matrix() - reference::forward_kinematics(chain, q).matrix()),
              few_roundings * scale(q));
    ASSERT_LT(largest(jacobian - reference::jacobian(chain, q)), few_roundings * scale(q));
  }
}

TEST_P(JacobianOf, TimesRatesIsVelocity) {
  const reference::Chain chain = chain_of(GetParam());
  for (int i = 0; i < configurations; ++i) {
    const VectorXd q = random();
    const VectorXd qd = random(2);
    const VectorXd expected = reference::jacobian(chain, q) * qd;
    ASSERT_LT(largest(GetParam().velocity(q, qd) - expected), few_roundings * scale(q) * qd.cwiseAbs().sum());
  }
}

/// Central differences with step h: truncation h^2/6 of the third derivative, rounding epsilon/h; with h =
/// 1e-5 both are below 1e-9 for values and rates of this size. differences_test.cpp has the other digits.
TEST_P(JacobianOf, DotIsTheDerivative) {
  const reference::Chain chain = chain_of(GetParam());
  const double h = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const VectorXd q = random();
    const VectorXd qd = random(1);
    const MatrixXd expected =
        (reference::jacobian(chain, q + h * qd) - reference::jacobian(chain, q - h * qd)) / (2 * h);
    const double tolerance = 1e-9 * scale(q) * (1 + qd.cwiseAbs().sum());
    ASSERT_LT(largest(GetParam().jacobian_dot(q, qd) - expected), tolerance) << q.transpose();
    ASSERT_LT(largest(GetParam().jacobian_dot_times_qd(q, qd) - expected * qd),
              tolerance * (1 + qd.cwiseAbs().sum()));
  }
}

TEST_P(JacobianOf, FloatDiffersByFloatRounding) {
  for (int i = 0; i < configurations; ++i) {
    const VectorXd q = random().cast<float>().cast<double>();
    const double tolerance = 200 * std::numeric_limits<float>::epsilon() * scale(q);
    ASSERT_LT(largest(GetParam().jacobian_in_float(q) - GetParam().jacobian(q)), tolerance);
  }
}

TEST_P(JacobianOf, BadJointsGiveNoNumbers) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int joint = 0; joint < GetParam().dof; ++joint) {
      VectorXd q = VectorXd::Constant(GetParam().dof, 0.5);
      q[joint] = bad;
      // A joint on which the transform depends shows there; what is a constant stays one.
      const auto [transform, jacobian] = GetParam().both(q);
      EXPECT_FALSE(transform.matrix().allFinite() && jacobian.allFinite()) << "joint " << joint;
      const MatrixXd good = GetParam().jacobian(VectorXd::Constant(GetParam().dof, 0.5));
      const MatrixXd seen = GetParam().jacobian(q);
      for (Eigen::Index i = 0; i < seen.size(); ++i)
        EXPECT_TRUE(!std::isfinite(seen(i)) || std::abs(seen(i) - good(i)) < 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, JacobianOf, testing::ValuesIn(qvgen::test::robots()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
