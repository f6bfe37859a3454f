// SPDX-License-Identifier: MIT
// Batches of arms with motors: the rows and the bits of single calls.
#include <gtest/gtest.h>
#include <qvgen/robots/bevel_arm/batch.h>

#include "arms.h"

namespace qvgen::test {
namespace {

constexpr std::size_t count = 100;

/// Poses of random motors, some singular and one that is none, and room for solutions.
template <class Arm, int capacity>
struct Rows {
  Rows()
      : poses(7 * count),
        motors(Arm::dof * count),
        q(Arm::dof * capacity * count),
        counts(count),
        states(count) {
    std::mt19937 random(3);
    const Arm arm;
    for (std::size_t k = 0; k < count; ++k) {
      typename Arm::Vector at = arm.random_motors(random, 3);
      if (k % 10 == 0) at.tail(3).setZero();
      const auto pose = Arm::pose(at);
      const double numbers[7] = {pose.orientation.w(),
                                 pose.orientation.x(),
                                 pose.orientation.y(),
                                 pose.orientation.z(),
                                 k == 7 ? 30 : pose.position.x(),
                                 pose.position.y(),
                                 pose.position.z()};
      for (std::size_t i = 0; i < 7; ++i) poses[i * count + k] = numbers[i];
      for (std::size_t i = 0; i < Arm::dof; ++i) motors[i * count + k] = at[static_cast<Eigen::Index>(i)];
    }
  }
  [[nodiscard]] qvgen::Pose<double> pose(std::size_t k) const {
    const auto at = [&](std::size_t i) { return poses[i * count + k]; };
    return {Eigen::Quaterniond(at(0), at(1), at(2), at(3)), Vector3<double>(at(4), at(5), at(6))};
  }
  [[nodiscard]] typename Arm::Vector seed(std::size_t k) const {
    return Arm::Vector::NullaryExpr(
        [&](Eigen::Index i) { return motors[static_cast<std::size_t>(i) * count + k]; });
  }
  BatchOfSolutions found() {
    return {{q.data(), count}, {counts.data(), count}, {states.data(), count}, {}, {}};
  }

  template <class Found>
  void expect_same(std::size_t k, const Found& single) const {
    ASSERT_EQ(counts[k], single.size()) << k;
    EXPECT_EQ(states[k], single.status);
    for (int s = 0; s < single.size(); ++s)
      for (int i = 0; i < Arm::dof; ++i)
        EXPECT_EQ(q[static_cast<std::size_t>(s * Arm::dof + i) * count + k], single[s].q[i]) << k;
  }

  std::vector<double> poses, motors, q;
  std::vector<int> counts;
  std::vector<Status> states;
};

TEST(MotorBatch, HasTheBitsOfSingleCalls) {
  namespace arm = robots::bevel_arm;
  Rows<BevelArm, arm::inverse_info.capacity> rows;
  const Batch<const double> poses(rows.poses.data(), count), seeds(rows.motors.data(), count);
  arm::inverse_kinematics(poses, rows.found());
  for (std::size_t k = 0; k < count; ++k) rows.expect_same(k, arm::inverse_kinematics(rows.pose(k)));
  arm::inverse_kinematics(poses, seeds, rows.found());
  for (std::size_t k = 0; k < count; ++k)
    rows.expect_same(k, arm::inverse_kinematics(rows.pose(k), rows.seed(k)));
  arm::inverse_kinematics(poses, seeds, arm::Limits(), rows.found());
  for (std::size_t k = 0; k < count; ++k)
    rows.expect_same(k, arm::inverse_kinematics(rows.pose(k), rows.seed(k), arm::Limits()));
}

}  // namespace
}  // namespace qvgen::test
