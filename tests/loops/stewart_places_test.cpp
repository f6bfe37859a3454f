// SPDX-License-Identifier: MIT
// All assemblies of a platform on six cylinders from their lengths, as they are generated.
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/stewart/assembly.h>

#include "reference/loops.h"

namespace qvgen::test::loops {
namespace {

namespace arm = qvgen::robots::stewart;
using Q = arm::JointVector<double>;
using arm::Driven;

class StewartPlaces : public testing::Test {
 protected:
  Q assembled() {
    std::uniform_real_distribution<double> slide(-0.15, 0.15), turn(-0.4, 0.4);
    Driven x;
    x << slide(random_), slide(random_), 0.5 + slide(random_), turn(random_), turn(random_), turn(random_);
    return arm::assemble_from_outputs(x)[0].q;
  }
  static Driven legs_of(const Q& q) { return q(arm::driven_joints); }
  /// Distance of the tip's poses.
  static double between(const Q& a, const Q& b) {
    return (arm::pose_of_top(a).isometry().matrix() - arm::pose_of_top(b).isometry().matrix()).norm();
  }

  const reference::LoopMechanism reference_ = reference::load_loops(QVGEN_PLATFORMS "stewart.toml");
  std::mt19937 random_{6};
};

TEST_F(StewartPlaces, EveryRowClosesTheLoopsAndTheSampledOneIsThere) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const Q q = assembled();
    const auto found = arm::assemble(legs_of(q));
    ASSERT_EQ(found.status, Status::solved);
    bool has_sampled = false;
    for (const auto& row : found) {
      EXPECT_LT(reference::gaps(reference_, row.q).cwiseAbs().maxCoeff(), 1e-13);
      EXPECT_EQ(legs_of(row.q), legs_of(q));
      EXPECT_FALSE(found.meets(row));
      has_sampled = has_sampled || (row.q - q).norm() < 1e-10;
      for (const auto& other : found)
        if (&other != &row) {
          EXPECT_GT(between(row.q, other.q), 1e-6);
        }
    }
    EXPECT_TRUE(has_sampled);
  }
}

TEST_F(StewartPlaces, TheNearestToASeedIsFirst) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS / 4; ++k) {
    const Q q = assembled();
    Q seed = q;
    seed[3] += 2 * M_PI + 0.01;
    const auto found = arm::assemble(legs_of(q), seed);
    ASSERT_EQ(found.status, Status::solved);
    Q expected = q;
    expected[3] += 2 * M_PI;
    EXPECT_LT((found[0].q - expected).norm(), 1e-10);
  }
}

TEST_F(StewartPlaces, BothSidesOfThePlatformAreFound) {
  const Q q = assembled();
  int below = 0;
  for (const auto& row : arm::assemble(legs_of(q))) below += row.q[2] < 0;
  EXPECT_GT(below, 0);
}

TEST_F(StewartPlaces, SaysWhatLengthsAreNone) {
  const Driven legs = legs_of(assembled());
  const auto with = [&](double length) {
    Driven changed = legs;
    changed[2] = length;
    return arm::assemble(changed);
  };
  EXPECT_EQ(with(40).status, Status::unreachable);
  EXPECT_EQ(with(-0.3).status, Status::unreachable);
  EXPECT_EQ(with(std::numeric_limits<double>::quiet_NaN()).status, Status::invalid);
  EXPECT_EQ(with(std::numeric_limits<double>::infinity()).status, Status::invalid);
  for (const double length : {40.0, -0.3}) EXPECT_TRUE(with(length).empty());
  const Q nowhere = Q::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(arm::assemble(legs, nowhere).status, Status::invalid);
}

}  // namespace
}  // namespace qvgen::test::loops
