// SPDX-License-Identifier: MIT
// The C header of the inverse kinematics gives what the C++ functions behind it give.
#include <limits>

#include <gtest/gtest.h>
#include <qvgen/robots/ns.h>
#include <qvgen/robots/planar_3r.h>
#include <qvgen/robots/puma560.h>

#include "inverse_calls.h"
#include "same_bits.h"

namespace {

namespace puma560 = qvgen::robots::puma560;
namespace ns = qvgen::robots::ns;
namespace planar = qvgen::robots::planar_3r;
using Joints = puma560::JointVector<double>;
using Numbers = Eigen::Matrix<double, 7, 1>;

Numbers numbers_of(const qvgen::Pose<double>& pose) {
  const auto& [orientation, position] = pose;
  Numbers numbers;
  numbers << orientation.w(), orientation.x(), orientation.y(), orientation.z(), position;
  return numbers;
}

template <class Found>
void expect_rows(const Found& cxx, int count, const rows& c) {
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
    const auto pose = puma560::forward_kinematics(q);
    rows found{};
    int count = puma560_in_c(numbers_of(pose).data(), nullptr, &found);
    EXPECT_EQ(found.capacity, puma560::inverse_info.capacity);
    EXPECT_GT(count, 0);
    ASSERT_NO_FATAL_FAILURE(expect_rows(puma560::inverse_kinematics(pose), count, found));
    count = puma560_in_c(numbers_of(pose).data(), seed.data(), &found);
    ASSERT_NO_FATAL_FAILURE(expect_rows(puma560::inverse_kinematics(pose, seed), count, found));
  }
  rows found{};
  EXPECT_EQ(puma560_in_c(Numbers::Constant(std::nan("")).eval().data(), nullptr, &found), 0);
  EXPECT_EQ(found.status, static_cast<int>(qvgen::Status::invalid));
}

TEST(InverseInC, WithinLimits) {
  std::mt19937 random(2);
  const Joints lower = Joints::Constant(-2), upper = Joints::Constant(3);
  int fewer = 0;
  for (int i = 0; i < 200; ++i) {
    const auto q = any<Joints>(random), seed = any<Joints>(random);
    const auto pose = puma560::forward_kinematics(q);
    rows found{};
    int count = puma560_within_in_c(numbers_of(pose).data(), seed.data(), lower.data(), upper.data(), &found);
    const puma560::Limits own(lower, upper);
    ASSERT_NO_FATAL_FAILURE(expect_rows(puma560::inverse_kinematics(pose, seed, own), count, found));
    fewer += count < puma560::inverse_kinematics(pose).size() ? 1 : 0;
    count = puma560_within_in_c(numbers_of(pose).data(), seed.data(), nullptr, upper.data(), &found);
    const puma560::Limits mixed(puma560::Limits().lower, upper);
    ASSERT_NO_FATAL_FAILURE(expect_rows(puma560::inverse_kinematics(pose, seed, mixed), count, found));
  }
  EXPECT_GT(fewer, 20);
}

TEST(InverseInC, NearASeed) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const auto q = any<Joints>(random);
    const auto pose = puma560::forward_kinematics(q);
    Joints next = q + 0.01 * any<Joints>(random);
    const auto cxx = puma560::inverse_kinematics_near(pose, next);
    int status = -1;
    ASSERT_EQ(puma560_near_in_c(numbers_of(pose).data(), next.data(), &status), cxx.size());
    EXPECT_EQ(status, static_cast<int>(cxx.status));
    ASSERT_EQ(cxx.size(), 1);
    EXPECT_EQ(next, cxx[0].q);
  }
  Joints seed = Joints::Zero();
  int status = -1;
  EXPECT_EQ(puma560_near_in_c(Numbers::Constant(std::nan("")).eval().data(), seed.data(), &status), 0);
  EXPECT_EQ(seed, Joints::Zero());
}

TEST(InverseInC, OwnGeometryAndLittleRoom) {
  const ns::JointVector<double> q(0.1, 0.7, 0.5, 0.3, -0.8, 1.1);
  const ns::Geometry g{0.9, 0.35};
  const double constants[]{0.9, 0.35};
  const auto pose = ns::forward_kinematics(q, g);
  const auto cxx = ns::inverse_kinematics(pose, g);
  rows found{};
  ASSERT_EQ(ns_in_c(numbers_of(pose).data(), constants, 8, &found), cxx.size());
  for (int i = 0; i < cxx.size(); ++i) expect_same_bits(cxx[i].q, found.q[i]);
  rows few{};
  EXPECT_EQ(ns_in_c(numbers_of(pose).data(), constants, 2, &few), cxx.size());
  expect_same_bits(cxx[1].q, few.q[1]);
  EXPECT_EQ(few.q[2][0], 0);
  EXPECT_EQ(ns_in_c(numbers_of(pose).data(), nullptr, 8, &found), ns::inverse_kinematics(pose).size());
}

TEST(InverseInC, AJointGiven) {
  const planar::JointVector<double> q(0.4, 0.9, -0.3);
  const auto pose = planar::forward_kinematics(q);
  const auto cxx = planar::inverse_kinematics_given_theta3(pose, q[2], q);
  double found[2][3];
  int status = -1;
  ASSERT_EQ(planar_3r_in_c(numbers_of(pose).data(), q[2], q.data(), found, &status), cxx.size());
  for (int i = 0; i < cxx.size(); ++i) expect_same_bits(cxx[i].q, found[i]);
  EXPECT_LT((cxx[0].q - q).norm(), 1e-12);
}

}  // namespace
