// SPDX-License-Identifier: MIT
// Arms with a joint held at a value that the caller gives: no length in their axes' frames may vanish with
// it.
#include <gtest/gtest.h>

#include "derive/inverse/problem.h"
#include "derive/inverse/screw.h"
#include "description/reader.h"
#include "random_robot.h"

namespace qvgen::derive::inverse {
namespace {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

void expect_frame(const Screw& screw, const Scope& scope) {
  EXPECT_TRUE(scope.is_zero(dot(screw.axis, screw.first))) << screw.variable;
  EXPECT_TRUE(scope.is_zero(dot(screw.first, screw.first) - 1)) << screw.variable;
  EXPECT_TRUE(scope.is_zero(cross(screw.axis, screw.first) - screw.second)) << screw.variable;
}

bool divides_by(const ex& value, const HeldAngle& held) {
  const ex divisor = held.left_out(value).normal().denom();
  return divisor.has(held.cosine) || divisor.has(held.sine);
}

TEST(HeldJoint, FramesOfAxesAreDividedByNothingThatTurnsWithIt) {
  int turned = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    const auto read = description::read_text(test::random_description(seed), "random.toml");
    ASSERT_TRUE(read.robot) << seed;
    const Problem whole = problem_of(*read.robot, model::Task::pose);
    for (std::size_t held = 0; held < read.robot->joints.size(); ++held) {
      if (read.robot->joints[held].type != model::JointType::revolute) continue;
      const Problem problem = with_held(whole, held);
      Scope scope(problem.robot, held_parameter(problem));
      symbolic::Program constants;
      for (const Screw& screw : chain_of(problem.robot, scope, constants).screws) {
        expect_frame(screw, scope);
        for (const ex& part :
             {screw.first.x, screw.first.y, screw.first.z, screw.second.x, screw.second.y, screw.second.z}) {
          EXPECT_FALSE(divides_by(part, *scope.held())) << "seed " << seed << ", " << screw.variable;
          turned += part.has(scope.held()->cosine) ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(turned, 100);
}

}  // namespace
}  // namespace qvgen::derive::inverse
