// SPDX-License-Identifier: MIT
// Batches of arms with motors, and of several given joints: the rows and the bits of single calls.
#include <gtest/gtest.h>
#include <qvgen/robots/bevel_arm.h>
#include <qvgen/robots/bevel_arm/batch.h>
#ifdef QVGEN_ALL_ARMS
#include <qvgen/robots/rail_seven.h>
#include <qvgen/robots/rail_seven/batch.h>
#endif

#include "arms.h"

namespace qvgen::test {
namespace {

/// Poses of random motors, and room for solutions.
class Batches {
 public:
  Batches(const Arm& arm, std::size_t count, double size) : arm_(arm), count_(count) {
    std::mt19937 random(3);
    for (std::size_t k = 0; k < count; ++k) motors_.push_back(arm.random_motors(random, size));
    q_.resize(static_cast<std::size_t>(arm.dof * arm.info.capacity) * count);
    counts_.resize(count);
    states_.resize(count);
  }
  VectorXd& motors(std::size_t k) { return motors_[k]; }

  /// Poses as a batch reads them, one that is none among them.
  Batch<const double> poses() {
    poses_.resize(7 * count_);
    for (std::size_t k = 0; k < count_; ++k) {
      const auto pose = pose_at(k);
      const double numbers[] = {pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                                pose.orientation.z(), pose.position.x(),    pose.position.y(),
                                pose.position.z()};
      for (std::size_t i = 0; i < 7; ++i) poses_[i * count_ + k] = numbers[i];
    }
    return {poses_.data(), count_};
  }
  /// Values of some joints of the motors, behind one another.
  Batch<const double> joints(std::vector<double>& room, const std::vector<int>& which) {
    room.clear();
    for (const int i : which)
      for (const VectorXd& q : motors_) room.push_back(q[i]);
    return {room.data(), count_};
  }
  Batch<const double> given() { return joints(given_, arm_.given); }
  Batch<const double> seeds() {
    std::vector<int> all;
    for (int i = 0; i < arm_.dof; ++i) all.push_back(i);
    return joints(seeds_, all);
  }
  BatchOfSolutions found() {
    return {{q_.data(), count_}, {counts_.data(), count_}, {states_.data(), count_}, {}, {}};
  }

  /// Single calls, which are asked for as much as the batch was.
  void expect_single_calls(bool is_seeded, const Bounds* limits) {
    for (std::size_t k = 0; k < count_; ++k) {
      const Asked asked{is_seeded ? &motors_[k] : nullptr, limits};
      const Rows single = arm_.functions.solve(motors_[k], pose_at(k), asked);
      ASSERT_EQ(static_cast<std::size_t>(counts_[k]), single.size) << k;
      EXPECT_EQ(states_[k], single.status);
      for (std::size_t s = 0; s < single.size; ++s)
        for (int i = 0; i < arm_.dof; ++i) {
          const auto row = s * static_cast<std::size_t>(arm_.dof) + static_cast<std::size_t>(i);
          EXPECT_EQ(q_[row * count_ + k], single[s].q[i]) << k;
        }
    }
  }

 private:
  [[nodiscard]] qvgen::Pose<double> pose_at(std::size_t k) const {
    auto pose = arm_.pose(motors_[k]);
    if (k == 7) pose.position.x() = 30;
    return pose;
  }
  const Arm& arm_;
  std::size_t count_;
  std::vector<VectorXd> motors_;
  std::vector<double> poses_, given_, seeds_, q_;
  std::vector<int> counts_;
  std::vector<Status> states_;
};

/// The limits of an arm's motors.
template <class Limits>
Bounds bounds(const Limits& limits) {
  return {limits.lower, limits.upper};
}

TEST(MotorBatch, HasTheBitsOfSingleCalls) {
  namespace robot = robots::bevel_arm;
  Batches batches(arm_named("bevel_arm"), 100, 3);
  for (std::size_t k = 0; k < 100; k += 10) batches.motors(k).tail(3).setZero();  // singular
  const auto poses = batches.poses(), seeds = batches.seeds();
  robot::inverse_kinematics(poses, batches.found());
  batches.expect_single_calls(false, nullptr);
  robot::inverse_kinematics(poses, seeds, batches.found());
  batches.expect_single_calls(true, nullptr);
  robot::inverse_kinematics(poses, seeds, robot::Limits(), batches.found());
  const Bounds limits = bounds(robot::Limits());
  batches.expect_single_calls(true, &limits);
}

#ifdef QVGEN_ALL_ARMS
TEST(RailSevenBatch, HasTheBitsOfSingleCalls) {
  namespace robot = robots::rail_seven;
  Batches batches(arm_named("rail_seven_by_the_last"), 60, 2);
  const auto poses = batches.poses(), given = batches.given(), seeds = batches.seeds();
  robot::inverse_kinematics_given_rail_theta7(poses, given, batches.found());
  batches.expect_single_calls(false, nullptr);
  robot::inverse_kinematics_given_rail_theta7(poses, given, seeds, robot::Limits(), batches.found());
  const Bounds limits = bounds(robot::Limits());
  batches.expect_single_calls(true, &limits);
}
#endif

}  // namespace
}  // namespace qvgen::test
