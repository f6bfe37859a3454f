// SPDX-License-Identifier: MIT
// Compiled forward kinematics of every robot against an independent chain of homogeneous matrices, which is
// fed from the descriptions by a reader of its own.
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "reference/load.h"
#include "robot_under_test.h"

namespace {

using qvgen::test::RobotUnderTest;

constexpr int configurations = 10'000;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Some hundred roundings of values up to the reach, those of the reference included.
constexpr double few_roundings = 100 * epsilon;

reference::Chain chain_of(const RobotUnderTest& robot) {
  return reference::load(std::string(QVGEN_SOURCE_DIR) + "/generator/robots/" + robot.name + ".toml");
}

class Configurations {
 public:
  explicit Configurations(const RobotUnderTest& robot) : dof_(robot.dof) {}
  Eigen::VectorXd next() {
    std::uniform_real_distribution<double> turn(-3.1415926535897931, 3.1415926535897931);
    return Eigen::VectorXd::NullaryExpr(dof_, [&] { return turn(random_); });
  }

 private:
  int dof_;
  std::mt19937_64 random_{20070711};
};

class Kinematics : public testing::TestWithParam<RobotUnderTest> {};

double reach(const Eigen::VectorXd& q, const Eigen::Isometry3d& tool) {
  return 1 + q.cwiseAbs().maxCoeff() + tool.translation().norm();
}

TEST_P(Kinematics, PoseIsThatOfTheReferenceChain) {
  const reference::Chain chain = chain_of(GetParam());
  ASSERT_EQ(chain.size(), GetParam().dof);
  Configurations random(GetParam());
  for (int i = 0; i < configurations; ++i) {
    const Eigen::VectorXd q = random.next();
    const Eigen::Isometry3d expected = reference::forward_kinematics(chain, q);
    const qvgen::Pose<double> pose = GetParam().pose(q);
    const double tolerance = few_roundings * reach(q, expected);
    ASSERT_NEAR(pose.orientation.norm(), 1, few_roundings);
    ASSERT_LT((pose.orientation.toRotationMatrix() - expected.linear()).cwiseAbs().maxCoeff(), few_roundings)
        << q.transpose();
    ASSERT_LT((pose.position - expected.translation()).norm(), tolerance) << q.transpose();
  }
}

TEST_P(Kinematics, TransformIsThatOfTheReferenceChain) {
  const reference::Chain chain = chain_of(GetParam());
  Configurations random(GetParam());
  for (int i = 0; i < configurations; ++i) {
    const Eigen::VectorXd q = random.next();
    const Eigen::Isometry3d expected = reference::forward_kinematics(chain, q);
    const Eigen::Isometry3d tool = GetParam().transform(q);
    ASSERT_LT((tool.linear() - expected.linear()).cwiseAbs().maxCoeff(), few_roundings) << q.transpose();
    ASSERT_LT((tool.translation() - expected.translation()).norm(), few_roundings * reach(q, expected))
        << q.transpose();
    ASSERT_EQ(tool.matrix().row(3), Eigen::RowVector4d(0, 0, 0, 1));
  }
}

TEST_P(Kinematics, FloatDiffersByFloatRounding) {
  Configurations random(GetParam());
  const double tolerance = 200 * std::numeric_limits<float>::epsilon();
  for (int i = 0; i < configurations; ++i) {
    const Eigen::VectorXd q = random.next().cast<float>().cast<double>();
    const qvgen::Pose<double> exact = GetParam().pose(q);
    const qvgen::Pose<float> rounded = GetParam().pose_in_float(q);
    ASSERT_LT((rounded.orientation.coeffs().cast<double>() - exact.orientation.coeffs()).norm(), tolerance);
    ASSERT_LT((rounded.position.cast<double>() - exact.position).norm(),
              tolerance * (1 + q.cwiseAbs().maxCoeff()));
  }
}

TEST_P(Kinematics, OtherScalarsInstantiate) {
  Configurations random(GetParam());
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd q = random.next();
    const qvgen::Pose<double> rounded = GetParam().pose(q);
    const qvgen::Pose<long double> exact = GetParam().pose_in_long_double(q);
    ASSERT_LT((exact.orientation.coeffs().cast<double>() - rounded.orientation.coeffs()).norm(),
              few_roundings);
    ASSERT_LT((exact.position.cast<double>() - rounded.position).norm(),
              few_roundings * (1 + q.cwiseAbs().maxCoeff()));
  }
}

/// The two may be contracted differently by the compiler, so the last bits may differ.
TEST_P(Kinematics, GivenSinesAndCosinesGiveTheSame) {
  Configurations random(GetParam());
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd q = random.next();
    const double tolerance = few_roundings * (1 + q.cwiseAbs().maxCoeff());
    ASSERT_TRUE(
        GetParam().pose(q).position.isApprox(GetParam().pose_with_angles_given(q).position, tolerance));
    ASSERT_TRUE(
        GetParam().pose(q).orientation.isApprox(GetParam().pose_with_angles_given(q).orientation, tolerance));
    ASSERT_TRUE(GetParam().transform(q).isApprox(GetParam().transform_with_angles_given(q), tolerance));
  }
}

TEST_P(Kinematics, ZeroConfigurationIsHome) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(GetParam().dof);
  const Eigen::Isometry3d expected = reference::forward_kinematics(chain_of(GetParam()), zero);
  EXPECT_LT((GetParam().transform(zero).matrix() - expected.matrix()).norm(), few_roundings);
}

TEST_P(Kinematics, NotANumberStaysNotANumber) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int joint = 0; joint < GetParam().dof; ++joint) {
      Eigen::VectorXd q = Eigen::VectorXd::Constant(GetParam().dof, 0.5);
      q[joint] = bad;
      const qvgen::Pose<double> pose = GetParam().pose(q);
      const bool marked = !pose.position.allFinite() || !pose.orientation.coeffs().allFinite();
      EXPECT_TRUE(marked) << "joint " << joint;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Kinematics, testing::ValuesIn(qvgen::test::robots()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
