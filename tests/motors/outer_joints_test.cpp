// SPDX-License-Identifier: MIT
// Several given joints: rows have their values and reach the pose, the joints that the pose was made from are
// there.
#include <limits>

#include <gtest/gtest.h>
#include <qvgen/robots/rail_seven/batch.h>

#include "outer_arms.h"

namespace qvgen::test {
namespace {

/// Rail and last joint given.
struct RailSevenByTheLast : RailSeven {
  static constexpr int given[] = {0, 7};
  static constexpr auto& info = robots::rail_seven::inverse_info_given_rail_theta7;
  template <class... More>
  static auto solve(const Vector& at, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::rail_seven::inverse_kinematics_given_rail_theta7(pose, at[0], at[7], more...);
  }
  template <class... More>
  static auto near(const Vector& at, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::rail_seven::inverse_kinematics_near_given_rail_theta7(pose, at[0], at[7], more...);
  }
};

template <class Arm>
class OuterJoints : public testing::Test {
 protected:
  Arm arm_;
  std::mt19937 random_{17};
};
using OuterArms = testing::Types<RailSeven, RailSevenByTheLast, Gantry>;
TYPED_TEST_SUITE(OuterJoints, OuterArms);

TYPED_TEST(OuterJoints, AreToldByTheInfo) {
  EXPECT_EQ(TypeParam::info.given_joint, 0);
  EXPECT_EQ(TypeParam::info.more_given, static_cast<int>(std::size(TypeParam::given)) - 1);
}

TYPED_TEST(OuterJoints, StayWhereTheyAreGivenAndTheOthersReachThePose) {
  for (int k = 0; k < 300; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 2);
    const auto pose = TypeParam::pose(q);
    const auto found = TypeParam::solve(q, pose);
    ASSERT_EQ(found.status, Status::solved);
    bool is_there = false;
    for (const auto& row : found) {
      EXPECT_LT(this->arm_.error_of(row.q, pose), 1e-9);
      for (const int i : TypeParam::given) EXPECT_EQ(row.q[i], q[i]);
      is_there = is_there || this->arm_.is_same(row.q, q);
    }
    EXPECT_TRUE(is_there);
  }
}

TYPED_TEST(OuterJoints, TakeSeedsLimitsAndRoundedPoses) {
  for (int k = 0; k < 100; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 2);
    auto pose = TypeParam::pose(q);
    const auto seeded = TypeParam::solve(q, pose, q);
    ASSERT_FALSE(seeded.empty());
    EXPECT_TRUE(this->arm_.is_same(seeded[0].q, q));
    const auto near = TypeParam::near(q, pose, q);
    ASSERT_EQ(near.size(), 1);
    EXPECT_LT((near[0].q - q).norm(), 1e-7);
    JointLimits<TypeParam::dof> limits{q.array() - 0.1, q.array() + 0.1};
    const auto inside = TypeParam::solve(q, pose, q, limits);
    ASSERT_GE(inside.size(), 1);  // more next to singular poses
    EXPECT_LT((inside[0].q - q).norm(), 1e-7);
    EXPECT_EQ(TypeParam::solve(q, pose, limits).size(), static_cast<std::size_t>(inside.size()));
    EXPECT_EQ(TypeParam::near(q, pose, q, limits).size(), 1);
    limits.lower[0] = q[0] + 0.05;  // the given value is outside
    EXPECT_TRUE(TypeParam::solve(q, pose, q, limits).empty());
    EXPECT_EQ(TypeParam::near(q, pose, q, limits).status, Status::unreachable);
    // Four digits of a quaternion, and the matrix.
    EXPECT_EQ(
        TypeParam::solve(q, pose).size(),
        TypeParam::solve(
            q, qvgen::Pose<double>{Eigen::Quaterniond(pose.orientation.coeffs() * (1 + 1e-9)), pose.position})
            .size());
  }
}

TYPED_TEST(OuterJoints, AreNoneForWhatIsNoNumber) {
  auto q = TypeParam::Vector::Constant(0.3).eval();
  auto pose = TypeParam::pose(q);
  auto odd = q;
  odd[0] = nan;
  EXPECT_EQ(TypeParam::solve(odd, pose).status, Status::invalid);
  EXPECT_EQ(TypeParam::near(odd, pose, q).status, Status::invalid);
  odd[0] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(TypeParam::solve(odd, pose).empty());
  odd = q;
  odd[4] = nan;
  EXPECT_EQ(TypeParam::solve(q, pose, odd).status, Status::invalid);
  pose.position[1] = 100;
  EXPECT_EQ(TypeParam::solve(q, pose).status, Status::unreachable);
  pose.orientation.coeffs() *= 3;
  EXPECT_EQ(TypeParam::solve(q, pose).status, Status::invalid);
}

TEST(RailSevenBatch, HasTheBitsOfSingleCalls) {
  namespace arm = robots::rail_seven;
  constexpr std::size_t count = 60;
  constexpr int capacity = arm::inverse_info_given_rail_theta7.capacity;
  std::vector<double> poses(7 * count), given(2 * count), seeds(8 * count), q(8 * capacity * count);
  std::vector<int> counts(count);
  std::vector<Status> states(count);
  std::mt19937 random(3);
  const RailSeven robot;
  std::vector<RailSeven::Vector> all;
  for (std::size_t k = 0; k < count; ++k) {
    all.push_back(robot.random_motors(random, 2));
    const auto pose = arm::forward_kinematics(all[k]);
    const double numbers[] = {pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                              pose.orientation.z(), pose.position.x(),    pose.position.y(),
                              pose.position.z()};
    for (std::size_t i = 0; i < 7; ++i) poses[i * count + k] = numbers[i];
    for (Eigen::Index i = 0; i < 8; ++i) seeds[static_cast<std::size_t>(i) * count + k] = all[k][i];
    given[k] = all[k][0];
    given[count + k] = all[k][7];
  }
  const BatchOfSolutions found{{q.data(), count}, {counts.data(), count}, {states.data(), count}, {}, {}};
  const Batch<const double> poses_of(poses.data(), count), given_of(given.data(), count),
      seeds_of(seeds.data(), count);
  const auto expect_same = [&](std::size_t k, const auto& single) {
    ASSERT_EQ(counts[k], single.size());
    EXPECT_EQ(states[k], single.status);
    for (int s = 0; s < single.size(); ++s)
      for (int i = 0; i < 8; ++i)
        EXPECT_EQ(q[static_cast<std::size_t>(s * 8 + i) * count + k], single[s].q[i]);
  };
  const auto pose = [&](std::size_t k) {
    const auto at = [&](std::size_t i) { return poses[i * count + k]; };
    return Pose<double>{Eigen::Quaterniond(at(0), at(1), at(2), at(3)), Vector3<double>(at(4), at(5), at(6))};
  };
  arm::inverse_kinematics_given_rail_theta7(poses_of, given_of, found);
  for (std::size_t k = 0; k < count; ++k) expect_same(k, RailSevenByTheLast::solve(all[k], pose(k)));
  arm::inverse_kinematics_given_rail_theta7(poses_of, given_of, seeds_of, arm::Limits(), found);
  for (std::size_t k = 0; k < count; ++k)
    expect_same(k, RailSevenByTheLast::solve(all[k], pose(k), all[k], JointLimits<8>(arm::Limits())));
}

}  // namespace
}  // namespace qvgen::test
