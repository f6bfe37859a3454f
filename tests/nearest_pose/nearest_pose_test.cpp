// SPDX-License-Identifier: MIT
// The nearest reachable pose of random arms with one to seven joints, against their plain chains of matrices.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/inverse/nearest_pose.h>

#include "reference/chain.h"

namespace qvgen::test {
namespace {

/// A random chain of so many joints: turns and slides, axes and links anyhow.
template <int dof>
class RandomArm {
 public:
  using Values = Joints<dof>;

  explicit RandomArm(unsigned seed) : random_(seed) {
    for (int i = 0; i < dof; ++i) {
      reference::Joint joint;
      joint.revolute = uniform(1) > -0.6;
      joint.axis = vector(1).normalized();
      joint.before.translate(vector(0.5));
      joint.after.rotate(Eigen::Quaterniond::UnitRandom());
      chain_.joints.push_back(joint);
      revolute_[static_cast<std::size_t>(i)] = joint.revolute;
    }
    chain_.tool.translate(vector(0.5));
  }

  [[nodiscard]] Pose<double> pose(const Values& q) const {
    return Pose<double>::from_isometry(reference::forward_kinematics(chain_, q));
  }
  [[nodiscard]] auto solver() const {
    return inverse::NearestPose{revolute_, [this](const Values& q) { return pose(q); },
                                [this](const Values& q) { return reference::jacobian(chain_, q); }};
  }
  Values joints(double size = 1.5) {
    Values q;
    for (double& each : q) each = uniform(size);
    return q;
  }
  Pose<double> any_pose() { return {Eigen::Quaterniond::UnitRandom(), vector(1)}; }
  double uniform(double size) { return std::uniform_real_distribution<double>(-size, size)(random_); }

 private:
  Eigen::Vector3d vector(double size) { return {uniform(size), uniform(size), uniform(size)}; }

  std::mt19937 random_;
  reference::Chain chain_;
  std::array<bool, static_cast<std::size_t>(dof)> revolute_{};
};

template <class Dof>
class NearestPoseOf : public testing::Test {
 protected:
  static constexpr int dof = Dof::value;
  using Arm = RandomArm<dof>;
  using Options = NearestPoseOptions<dof>;

  static double miss(const Pose<double>& a, const Pose<double>& b, double length) {
    return std::hypot(linear_distance(a, b), length * angular_distance(a, b));
  }
  static double miss(const NearestRow<dof>& row, double length) {
    return std::hypot(row.position_error, length * row.orientation_error);
  }
  static Options both(double length = 0.7) {
    Options options;
    options.metres_per_radian = length;
    return options;
  }
};
#if defined(QVGEN_ALL_SIZES)
using AllSizes = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                std::integral_constant<int, 3>, std::integral_constant<int, 4>,
                                std::integral_constant<int, 5>, std::integral_constant<int, 6>,
                                std::integral_constant<int, 7>>;
#else  // fewer than six joints, six, and more
using AllSizes = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 6>,
                                std::integral_constant<int, 7>>;
#endif
TYPED_TEST_SUITE(NearestPoseOf, AllSizes);

TYPED_TEST(NearestPoseOf, ReachesWhatTheArmReaches) {
  for (unsigned k = 0; k < 20; ++k) {
    RandomArm<TestFixture::dof> arm(k);
    const auto q = arm.joints();
    const auto near = arm.joints(0.02);
    const auto rows = arm.solver().rows(arm.pose(q), TestFixture::both(), std::array{(q + near).eval()});
    EXPECT_EQ(rows.status, Status::solved) << k;
    EXPECT_LT(linear_distance(arm.pose(rows[0].q), arm.pose(q)), 1e-10);
  }
}

/// Errors are what the row's joints miss the pose by; rows stand in order; no joints close to them are
/// nearer.
TYPED_TEST(NearestPoseOf, RowsAreMinimaInOrder) {
  const double length = 0.7;
  for (unsigned k = 0; k < 10; ++k) {
    RandomArm<TestFixture::dof> arm(k);
    const Pose<double> goal = arm.any_pose();
    const auto rows = arm.solver().rows(goal, TestFixture::both(length));
    ASSERT_FALSE(rows.empty());
    double before = 0;
    for (const auto& row : rows) {
      EXPECT_NEAR(row.position_error, linear_distance(arm.pose(row.q), goal), 1e-12);
      EXPECT_NEAR(row.orientation_error, angular_distance(arm.pose(row.q), goal), 1e-7);
      EXPECT_GE(this->miss(row, length), before);
      before = this->miss(row, length);
      // Half a turn is a ridge, where the descent may stand still.
      if (row.orientation_error > 3) continue;
      for (int i = 0; i < 20; ++i)
        EXPECT_GT(this->miss(arm.pose(row.q + arm.joints(1e-3)), goal, length), before - 1e-9) << k;
    }
  }
}

TYPED_TEST(NearestPoseOf, NoSampledJointsAreNearer) {
  const double length = 0.7;
  int nearer = 0;
  for (unsigned k = 0; k < 10; ++k) {
    RandomArm<TestFixture::dof> arm(k);
    const Pose<double> goal = arm.any_pose();
    const double best = this->miss(arm.solver().rows(goal, TestFixture::both(length))[0], length);
    for (int i = 0; i < 2000; ++i)
      nearer += this->miss(arm.pose(arm.joints(3.14)), goal, length) < best - 1e-9 ? 1 : 0;
  }
  EXPECT_EQ(nearer, 0);
}

/// A part that comes first is at least as near as if it did not.
TYPED_TEST(NearestPoseOf, WhatComesFirstIsNearest) {
  for (unsigned k = 0; k < 10; ++k) {
    RandomArm<TestFixture::dof> arm(k);
    const Pose<double> goal = arm.any_pose();
    auto options = TestFixture::both();
    const auto balanced = arm.solver().rows(goal, options);
    options.prefer = Prefer::position;
    const auto position = arm.solver().rows(goal, options);
    EXPECT_LE(position[0].position_error, balanced[0].position_error + 1e-6) << k;
    options.prefer = Prefer::orientation;
    const auto orientation = arm.solver().rows(goal, options);
    EXPECT_LE(orientation[0].orientation_error, balanced[0].orientation_error + 1e-6) << k;
  }
}

/// Joints drawn within limits are a bound; a pose made from them is reached.
TYPED_TEST(NearestPoseOf, StaysWithinLimits) {
  for (unsigned k = 0; k < 10; ++k) {
    RandomArm<TestFixture::dof> arm(k);
    auto options = TestFixture::both();
    options.limits.lower.setConstant(-0.4);
    options.limits.upper.setConstant(0.3);
    const Pose<double> far = arm.any_pose();
    const auto rows = arm.solver().rows(far, options);
    ASSERT_FALSE(rows.empty());
    double sampled = 1e9;
    for (int i = 0; i < 500; ++i) {
      const auto q = arm.joints(0.3);
      sampled = std::min(sampled, this->miss(arm.pose(q), far, 0.7));
    }
    EXPECT_LT(this->miss(rows[0], 0.7), sampled + 1e-9) << k;
    for (const auto& row : rows) {
      EXPECT_TRUE((row.q.array() >= -0.4).all() && (row.q.array() <= 0.3).all()) << row.q.transpose();
    }
    const auto inside = arm.joints(0.29);
    EXPECT_EQ(arm.solver().rows(arm.pose(inside), options, std::array{inside}).status, Status::solved);
  }
}

TYPED_TEST(NearestPoseOf, BadInputIsInvalid) {
  RandomArm<TestFixture::dof> arm(0);
  const auto expect_invalid = [&](const Pose<double>& pose, const auto& options) {
    const auto rows = arm.solver().rows(pose, options);
    EXPECT_EQ(rows.status, Status::invalid);
    EXPECT_TRUE(rows.empty());
  };
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    Pose<double> pose;
    pose.position.y() = bad;
    expect_invalid(pose, TestFixture::both());
    pose = {};
    pose.orientation.x() = bad;
    expect_invalid(pose, TestFixture::both());
    expect_invalid(Pose<double>{}, TestFixture::both(bad));
  }
  expect_invalid({Eigen::Quaterniond(0, 0, 0, 0), {}}, TestFixture::both());
  expect_invalid(Pose<double>{}, TestFixture::both(-1));
  auto crossed = TestFixture::both();
  crossed.limits.lower[0] = 1;
  crossed.limits.upper[0] = 0.5;
  expect_invalid(Pose<double>{}, crossed);
  crossed.limits.lower[0] = nan;
  expect_invalid(Pose<double>{}, crossed);
}

TEST(NearestPose, WithoutAStartNothingIsKnown) {
  RandomArm<5> arm(0);
  NearestPoseOptions<5> options;
  options.starts = 0;
  EXPECT_EQ(arm.solver().rows(Pose<double>{}, options).status, Status::incomplete);
  // A seed that is no number is no start.
  const Joints<5> nowhere = Joints<5>::Constant(std::nan(""));
  EXPECT_EQ(arm.solver().rows(Pose<double>{}, options, std::array{nowhere}).status, Status::incomplete);
}

/// Two links of a metre that turn in a plane.
struct Planar {
  static Pose<double> pose(const Joints<2>& q) {
    const double sum = q[0] + q[1];
    return {Eigen::Quaterniond(Eigen::AngleAxisd(sum, Eigen::Vector3d::UnitZ())),
            {std::cos(q[0]) + std::cos(sum), std::sin(q[0]) + std::sin(sum), 0}};
  }
  static Eigen::Matrix<double, 6, 2> jacobian(const Joints<2>& q) {
    const Eigen::Vector3d tool = pose(q).position;
    Eigen::Matrix<double, 6, 2> j = Eigen::Matrix<double, 6, 2>::Zero();
    j.col(0) << -tool.y(), tool.x(), 0, 0, 0, 1;
    j.col(1) << -(tool.y() - std::sin(q[0])), tool.x() - std::cos(q[0]), 0, 0, 0, 1;
    return j;
  }
  static auto solver() { return inverse::NearestPose{std::array{true, true}, pose, jacobian}; }
};

/// Straight towards a point three metres away and half a metre above the plane.
TEST(NearestPose, OutOfReachTheArmIsStretched) {
  NearestPoseOptions<2> options;
  options.prefer = Prefer::position;
  const Pose<double> goal{Eigen::Quaterniond::Identity(), {0, 3, 0.5}};
  const auto rows = Planar::solver().rows(goal, options);
  ASSERT_EQ(rows.status, Status::unreachable);
  EXPECT_NEAR(rows[0].position_error, std::hypot(1, 0.5), 1e-9);
  EXPECT_NEAR(rows[0].q[0], 1.5707963267948966, 1e-4);
  EXPECT_NEAR(rows[0].orientation_error, 1.5707963267948966, 1e-4);
}

/// With the position first both elbows are there, the one with the nearer orientation before the other.
TEST(NearestPose, ThePositionFirstHasBothElbows) {
  NearestPoseOptions<2> options;
  options.prefer = Prefer::position;
  const Joints<2> q(0.3, 0.8);
  Pose<double> goal = Planar::pose(q);
  goal.orientation = goal.orientation * Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  const auto rows = Planar::solver().rows(goal, options);
  ASSERT_GE(rows.size(), 2);
  EXPECT_LT((rows[0].q - q).norm(), 1e-6);
  EXPECT_NEAR(rows[0].orientation_error, 0.2, 1e-6);
  EXPECT_LT((rows[1].q - Joints<2>(1.1, -0.8)).norm(), 1e-6);
  EXPECT_LT(rows[1].position_error, 1e-9);
}

/// The limit stops the elbow, and the shoulder makes the best of it.
TEST(NearestPose, AJointAtItsLimit) {
  NearestPoseOptions<2> options;
  options.prefer = Prefer::position;
  options.limits.upper[1] = 0.5;
  options.limits.lower[1] = 0;
  const auto rows = Planar::solver().rows({Eigen::Quaterniond::Identity(), {0.5, 0.5, 0}}, options);
  ASSERT_FALSE(rows.empty());
  EXPECT_DOUBLE_EQ(rows[0].q[1], 0.5);
  EXPECT_NEAR(rows[0].position_error, 2 * std::cos(0.25) - std::sqrt(0.5), 1e-9);
}

TEST(NearestPose, AQuaternionOffItsLengthByRoundingIsTaken) {
  const Joints<2> q(0.3, 0.8);
  Pose<double> goal = Planar::pose(q);
  goal.orientation.coeffs() *= -(1 + 1e-8);
  EXPECT_EQ(Planar::solver().rows(goal, {}, std::array{q}).status, Status::solved);
}

}  // namespace
}  // namespace qvgen::test
