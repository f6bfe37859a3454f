// SPDX-License-Identifier: MIT
#include "derive/kinematics/turns.h"

#include <gtest/gtest.h>

#include "dag/evaluate.h"
#include "dag/import.h"
#include "exact/point.h"
#include "symbolic/model.h"

namespace {

using namespace qvgen;
using namespace qvgen::derive;
using symbolic::Quaternion;
using symbolic::Vector;

Turn turn(const Vector& axis, const char* variable) { return {axis, symbolic::symbol(variable)}; }

/// Exact equality at some points.
void expect_equal(const Quaternion& a, const Quaternion& b) {
  symbolic::Program program;
  program.output("w", a.w - b.w);
  program.output("x", a.x - b.x);
  program.output("y", a.y - b.y);
  program.output("z", a.z - b.z);
  const dag::Function difference = dag::import(program);
  for (std::uint64_t seed = 1; seed < 6; ++seed)
    for (const exact::Number& value : dag::evaluate<exact::Number>(difference, exact::ExactPoint(seed)))
      EXPECT_TRUE(value.is_zero());
}

Quaternion product(const std::vector<Turn>& turns) {
  Quaternion result;
  for (const Turn& each : turns) result = result * symbolic::rotation(each.axis, each.angle);
  return result;
}

const Vector x{1, 0, 0};
const Vector y{0, 1, 0};
const Vector z{0, 0, 1};

TEST(EulerTriple, IsTheProductOfItsTurns) {
  for (const Vector& last : {z, -z}) {
    const std::vector<Turn> turns{turn(z, "a"), turn(-y, "b"), turn(last, "c")};
    ASSERT_TRUE(is_euler_triple(turns, 0));
    expect_equal(euler_triple(turns[0], turns[1], turns[2]), product(turns));
  }
}

TEST(EulerTriple, NeedsAPerpendicularMiddle) {
  EXPECT_FALSE(is_euler_triple({turn(z, "a"), turn(y, "b"), turn(x, "c")}, 0));
  EXPECT_FALSE(is_euler_triple(
      {turn(z, "a"), turn({0, GiNaC::numeric(3, 5), GiNaC::numeric(4, 5)}, "b"), turn(z, "c")}, 0));
  EXPECT_FALSE(is_euler_triple({turn(z, "a"), turn(y, "b")}, 0));
}

TEST(AngleSumProduct, IsTheProductOfItsTurns) {
  const std::vector<Turn> turns{turn(y, "a"), turn(z, "b"), turn(-y, "c"), turn(-x, "d"), turn(-y, "e")};
  const auto sum = angle_sum_product(turns, y, 3);
  ASSERT_TRUE(sum);
  expect_equal(*sum, product(turns));
  EXPECT_FALSE(angle_sum_product(turns, y, 1));
  EXPECT_FALSE(angle_sum_product({turn({GiNaC::numeric(3, 5), GiNaC::numeric(4, 5), 0}, "a")}, y, 3));
}

TEST(TurnSequence, MergesParallelNeighboursAndTheHomeRotation) {
  ZeroReferenceChain chain;
  chain.joints = {{model::JointType::revolute, "a", {}, z},
                  {model::JointType::prismatic, "d", {}, x},
                  {model::JointType::revolute, "b", {}, -z}};
  chain.home = symbolic::rotation(z, GiNaC::Pi / 2);
  const TurnSequence sequence = turn_sequence(chain);
  ASSERT_EQ(sequence.turns.size(), 1U);
  EXPECT_TRUE(
      sequence.turns[0].angle.is_equal(symbolic::symbol("a") - symbolic::symbol("b") + GiNaC::Pi / 2));
  EXPECT_TRUE(sequence.home.w.is_equal(1));
}

}  // namespace
