// SPDX-License-Identifier: MIT
// The C header of the inverse kinematics gives what the C++ functions behind it give.
#include <limits>

#include <gtest/gtest.h>
#include <qvgen/robots/inclined_seven/inverse.h>
#include <qvgen/robots/inclined_seven/kinematics.h>
#include <qvgen/robots/jaco2.h>
#if defined(QVGEN_ALL_ARMS)
#include <qvgen/robots/seven_joints/inverse.h>
#include <qvgen/robots/seven_joints/kinematics.h>
#endif

#include "inverse_calls.h"
#include "same_bits.h"

namespace {

namespace jaco2 = qvgen::robots::jaco2;
using Joints = jaco2::JointVector<double>;
using Numbers = Eigen::Matrix<double, 7, 1>;

Numbers numbers_of(const qvgen::Pose<double>& pose) {
  const auto& [orientation, position] = pose;
  Numbers numbers;
  numbers << orientation.w(), orientation.x(), orientation.y(), orientation.z(), position;
  return numbers;
}

template <class Found, class Rows>
void expect_rows(const Found& cxx, int count, const Rows& c) {
  ASSERT_EQ(count, cxx.size());
  EXPECT_EQ(c.status, static_cast<int>(cxx.status));
  for (int i = 0; i < count; ++i) {
    expect_same_bits(cxx[i].q, c.q[i]);
    EXPECT_EQ(c.branches[i], cxx[i].branch);
  }
}

TEST(InverseInC, AllSolutions) {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    const auto q = any<Joints>(random), seed = any<Joints>(random);
    const auto pose = jaco2::forward_kinematics(q);
    rows found{};
    int count = jaco2_in_c(numbers_of(pose).data(), nullptr, &found);
    EXPECT_EQ(found.capacity, jaco2::inverse_info.capacity);
    EXPECT_GT(count, 0);
    ASSERT_NO_FATAL_FAILURE(expect_rows(jaco2::inverse_kinematics(pose), count, found));
    count = jaco2_in_c(numbers_of(pose).data(), seed.data(), &found);
    ASSERT_NO_FATAL_FAILURE(expect_rows(jaco2::inverse_kinematics(pose, seed), count, found));
  }
  rows found{};
  EXPECT_EQ(jaco2_in_c(Numbers::Constant(std::nan("")).eval().data(), nullptr, &found), 0);
  EXPECT_EQ(found.status, static_cast<int>(qvgen::Status::invalid));
}

TEST(InverseInC, WithinLimits) {
  std::mt19937 random(2);
  const Joints lower = Joints::Constant(-2), upper = Joints::Constant(3);
  int fewer = 0;
  for (int i = 0; i < 200; ++i) {
    const auto q = any<Joints>(random), seed = any<Joints>(random);
    const auto pose = jaco2::forward_kinematics(q);
    rows found{};
    int count = jaco2_within_in_c(numbers_of(pose).data(), seed.data(), lower.data(), upper.data(), &found);
    const jaco2::Limits own(lower, upper);
    ASSERT_NO_FATAL_FAILURE(expect_rows(jaco2::inverse_kinematics(pose, seed, own), count, found));
    fewer += count < jaco2::inverse_kinematics(pose).size() ? 1 : 0;
    count = jaco2_within_in_c(numbers_of(pose).data(), seed.data(), nullptr, upper.data(), &found);
    const jaco2::Limits mixed(jaco2::Limits().lower, upper);
    ASSERT_NO_FATAL_FAILURE(expect_rows(jaco2::inverse_kinematics(pose, seed, mixed), count, found));
  }
  EXPECT_GT(fewer, 20);
}

TEST(InverseInC, NearASeed) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const auto q = any<Joints>(random);
    const auto pose = jaco2::forward_kinematics(q);
    Joints next = q + 0.01 * any<Joints>(random);
    const auto cxx = jaco2::inverse_kinematics_near(pose, next);
    int status = -1;
    ASSERT_EQ(jaco2_near_in_c(numbers_of(pose).data(), next.data(), &status), cxx.size());
    EXPECT_EQ(status, static_cast<int>(cxx.status));
    ASSERT_EQ(cxx.size(), 1);
    EXPECT_EQ(next, cxx[0].q);
  }
  Joints seed = Joints::Zero();
  int status = -1;
  EXPECT_EQ(jaco2_near_in_c(Numbers::Constant(std::nan("")).eval().data(), seed.data(), &status), 0);
  EXPECT_EQ(seed, Joints::Zero());
}

#if defined(QVGEN_ALL_ARMS)
TEST(InverseInC, AJointThatIsGiven) {
  namespace seven = qvgen::robots::seven_joints;
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i) {
    const auto q = any<seven::JointVector<double>>(random), seed = any<seven::JointVector<double>>(random);
    const auto pose = seven::forward_kinematics(q);
    const Numbers numbers = numbers_of(pose);
    seven_rows found{};
    int count = seven_in_c(numbers.data(), q[4], seed.data(), &found);
    EXPECT_EQ(found.capacity, seven::inverse_info_given_theta5.capacity);
    EXPECT_GT(count, 0);
    ASSERT_NO_FATAL_FAILURE(
        expect_rows(seven::inverse_kinematics_given_theta5(pose, q[4], seed), count, found));
    count = seven_within_in_c(numbers.data(), q[4], seed.data(), &found);
    ASSERT_NO_FATAL_FAILURE(
        expect_rows(seven::inverse_kinematics_given_theta5(pose, q[4], seed, seven::Limits()), count, found));
    const auto near = seven::inverse_kinematics_near_given_theta5(pose, q[4], q);
    seven::JointVector<double> next = q;
    int status = -1;
    ASSERT_EQ(seven_near_in_c(numbers.data(), q[4], next.data(), &status), near.size());
    EXPECT_EQ(status, static_cast<int>(near.status));
    ASSERT_EQ(near.size(), 1);
    EXPECT_EQ(next, near[0].q);
  }
}
#endif

/// A part of a pose, with two joints given: rows, next to a seed, within limits. Rows have the inclination.
TEST(InverseInC, APartOfAPose) {
  namespace seven = qvgen::robots::inclined_seven;
  using Joints = seven::JointVector<double>;
  const auto up_at = [](const Joints& q) -> Eigen::Vector3d {
    return seven::forward_kinematics(q).orientation.conjugate() * Eigen::Vector3d::UnitZ();
  };
  std::mt19937 random(5);
  int fewer = 0, outside = 0;
  for (int i = 0; i < 50; ++i) {
    const Joints q = any<Joints>(random), seed = any<Joints>(random);
    const auto pose = seven::forward_kinematics(q);
    const qvgen::PositionAndInclination<double> task{pose.position, up_at(q)};
    const double given[] = {q[0], q[6]};
    const double *at = task.position.data(), *up = task.up.data();
    seven_rows found{};
    int count = inclined_in_c(at, up, given, seed.data(), &found);
    EXPECT_EQ(found.capacity, seven::inverse_info_given_rail_q7.capacity);
    ASSERT_NO_FATAL_FAILURE(
        expect_rows(seven::inverse_kinematics_given_rail_q7(task, q[0], q[6], seed), count, found));
    EXPECT_GT(count, 0);
    for (int k = 0; k < count; ++k) {
      const Joints row(found.q[k]);
      EXPECT_LT((seven::forward_kinematics(row).position - task.position).norm(), 1e-9);
      EXPECT_LT((up_at(row) - task.up).norm(), 1e-9);
    }
    const int all = count;
    count = inclined_in_c(at, up, given, nullptr, &found);
    ASSERT_NO_FATAL_FAILURE(
        expect_rows(seven::inverse_kinematics_given_rail_q7(task, q[0], q[6]), count, found));
    count = inclined_pose_in_c(numbers_of(pose).data(), given, seed.data(), &found);
    ASSERT_NO_FATAL_FAILURE(
        expect_rows(seven::inverse_kinematics_given_rail_q7(pose, q[0], q[6], seed), count, found));
    const seven::Limits limits(q.array() - 1, q.array() + 2);
    count =
        inclined_within_in_c(at, up, given, seed.data(), limits.lower.data(), limits.upper.data(), &found);
    ASSERT_NO_FATAL_FAILURE(
        expect_rows(seven::inverse_kinematics_given_rail_q7(task, q[0], q[6], seed, limits), count, found));
    fewer += count < all ? 1 : 0;
    Joints next = q + 0.01 * any<Joints>(random), kept = next;
    const auto near = seven::inverse_kinematics_near_given_rail_q7(task, q[0], q[6], next);
    int status = -1;
    ASSERT_EQ(inclined_near_in_c(at, up, given, next.data(), &status), near.size());
    EXPECT_EQ(status, static_cast<int>(near.status));
    ASSERT_EQ(near.size(), 1);
    EXPECT_EQ(next, near[0].q);
    const Joints beyond = q.array() + 1e-3;
    ASSERT_EQ(inclined_near_within_in_c(at, up, given, limits.lower.data(), limits.upper.data(), kept.data(),
                                        &status),
              1);
    EXPECT_EQ(kept, near[0].q);
    outside += inclined_near_within_in_c(at, up, given, beyond.data(), limits.upper.data(), kept.data(),
                                         &status) == 0
                   ? 1
                   : 0;
    EXPECT_EQ(kept, near[0].q);
  }
  EXPECT_GT(fewer, 10);
  EXPECT_EQ(outside, 50);
  const double odd[] = {0, std::nan(""), 1}, place[] = {0.1, 0.2, 0.3}, given[] = {0, 0};
  seven_rows found{};
  EXPECT_EQ(inclined_in_c(place, odd, given, nullptr, &found), 0);
  EXPECT_EQ(found.status, static_cast<int>(qvgen::Status::invalid));
}

TEST(InverseInC, LittleRoom) {
  const Joints q(0.1, 0.7, 0.5, 0.3, -0.8, 1.1);
  const auto pose = jaco2::forward_kinematics(q);
  const auto cxx = jaco2::inverse_kinematics(pose);
  ASSERT_GE(cxx.size(), 2);
  rows few{};
  EXPECT_EQ(jaco2_with_room(numbers_of(pose).data(), 1, &few), cxx.size());
  expect_same_bits(cxx[0].q, few.q[0]);
  EXPECT_EQ(few.q[1][0], 0);
}

}  // namespace
