// SPDX-License-Identifier: MIT
// Equations of rods, which are derived from the lines of the rods: they are the derivatives of the gaps. And
// a rod that tells no angle.
#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "derive/inverse/names.h"
#include "derive/loops/assembly_plan.h"
#include "derive/loops/constraints.h"
#include "derive/loops/named_angles.h"
#include "description/reader.h"
#include "model/private_names.h"
#include "symbolic/model.h"

namespace qvgen::test::loops_rods {
namespace {

model::Mechanism mechanism_of_file(const std::string& name) {
  const auto result = description::read_file(std::string(QVGEN_LOOP_ROBOTS) + "/" + name + ".toml");
  if (!result.robot) throw std::runtime_error(description::to_string(result.diagnostics.front()));
  return {*result.robot, result.tips, result.loops};
}

/// GiNaC differentiates the gap itself; joints need not close the loop.
TEST(Rods, LinesOfRodsAreDerivativesOfTheirGaps) {
  using GiNaC::ex;
  using symbolic::symbol;
  namespace names = derive::inverse::names;
  for (const char* name : {"ankle", "excavator", "planar_3rrr", "delta", "leg", "../platforms/stewart"}) {
    const auto mechanism = mechanism_of_file(name);
    const auto robot = derive::loops::with_named_angles(model::with_private_names(mechanism.robot));
    auto scope = derive::loops::scope_of(robot, mechanism.loops);
    auto rods = derive::loops::cycles_of(mechanism, robot, scope);
    rods.erase(std::remove_if(rods.begin(), rods.end(),
                              [](const auto& each) { return each.type != model::LoopType::rod; }),
               rods.end());
    const auto constraints = derive::loops::constraints_of(robot, rods);
    const auto entries = constraints.jacobian.expanded(), bias = constraints.bias.expanded();
    std::size_t row = 0;
    for (const auto& joint : robot.joints) {
      for (const auto& each : {joint.variable, "rate_" + joint.variable}) scope.length(each);
      scope.turn(joint.variable);
    }
    const auto by = [&](const ex& value, const std::string& x) -> ex {
      const auto c = symbol(names::cosine(x)), s = symbol(names::sine(x));
      return c * value.diff(s) - s * value.diff(c) + value.diff(symbol(x));
    };
    for (const auto& gap : constraints.gap.expanded()) {
      ex rate = 0, second = 0;
      for (std::size_t j = 0; j < robot.joints.size(); ++j) {
        const std::string& x = robot.joints[j].variable;
        rate += symbol("rate_" + x) * by(gap.value, x);
        EXPECT_TRUE(scope.is_zero(entries[row * robot.joints.size() + j].value - by(gap.value, x)))
            << name << x;
      }
      for (const auto& joint : robot.joints)
        second += symbol("rate_" + joint.variable) * by(rate, joint.variable);
      EXPECT_TRUE(scope.is_zero(bias[row++].value - second)) << name;
    }
  }
}

/// A slide on a crank's axis, whose rod is as long wherever the crank is.
TEST(Rods, OnAnAxisTellNoAngleAboutIt) {
  const auto result = description::read_text(R"(
name = "press"
title = "a slide on a crank's axis"
actuated = ["crank"]
[[joint]]
type = "revolute"
axis = "+z"
variable = "crank"
[[joint]]
type = "prismatic"
axis = "+z"
variable = "slide"
parent = "base"
[[tip]]
name = "end"
[[loop]]
type = "rod"
between = ["crank", "slide"]
at = [[0.05, 0, 0], [0, 0, 0]]
length = 0.15
)",
                                             "press.toml");
  ASSERT_TRUE(result.robot);
  const model::Mechanism mechanism{*result.robot, result.tips, result.loops};
  EXPECT_EQ(derive::loops::assembly_plan(mechanism, {0}).plan.capacity, 2);
  const std::vector<std::string> reasons = derive::loops::assembly_plan(mechanism, {1}).reasons;
  ASSERT_FALSE(reasons.empty());
  EXPECT_NE(reasons[0].find("begins on the axis of crank, so that its length does not tell the angle"),
            std::string::npos)
      << reasons[0];
}

}  // namespace
}  // namespace qvgen::test::loops_rods
