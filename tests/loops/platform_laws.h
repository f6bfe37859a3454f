// SPDX-License-Identifier: MIT
// Laws of platforms on legs, of whatever kind. `Arm` names the functions of a generated mechanism; q has the
// values of all its joints.
#pragma once

#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/inverse/solutions.h>

namespace qvgen::test::platforms {

/// Next to a seed the place is found for its legs, in few steps and without a dead centre.
template <class Arm>
void expect_followed(const typename Arm::Q& q, std::mt19937& random) {
  typename Arm::Q seed = q;
  for (double& value : seed) value += std::uniform_real_distribution<double>(-0.03, 0.03)(random);
  const auto found = Arm::follow(Arm::legs_of(q), seed);
  ASSERT_TRUE(found.closed);
  EXPECT_FALSE(found.crossed);
  EXPECT_LE(found.steps, 6);
  EXPECT_LT(found.gap, 1e-12);
  EXPECT_LT((found.q - q).norm(), 1e-10);
}

/// Legs that cannot meet, and numbers that are none, are said.
template <class Arm>
void expect_refused(const typename Arm::Q& q, typename Arm::Driven place) {
  typename Arm::Driven legs = Arm::legs_of(q);
  legs[0] = 40;
  EXPECT_FALSE(Arm::follow(legs, q).closed);
  legs[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Arm::follow(legs, q).closed);
  place[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Arm::assemble_from_outputs(place).status, Status::invalid);
}

}  // namespace qvgen::test::platforms
