// SPDX-License-Identifier: MIT
// Equations of rods, which are derived from the lines of the rods: they are the derivatives of the gaps. And
// a rod that tells no angle.
#include <algorithm>
#include <array>
#include <random>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "derive/inverse/lower.h"
#include "derive/inverse/names.h"
#include "derive/loops/assembly_plan.h"
#include "derive/loops/constraints.h"
#include "derive/loops/named_angles.h"
#include "description/reader.h"
#include "model/private_names.h"
#include "symbolic/model.h"
#include "verify/certificate.h"
#include "verify/loops/certify_loops.h"
#include "verify/loops/driven.h"

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

/// Expects a four-bar whose step needs no root, or needs one, and a certificate of its plan. Lengths are
/// those of ground, crank, rod and rocker; ends are turned by angles of the Pythagorean triple 3, 4, 5.
void expect_folding(bool expected, const std::array<GiNaC::numeric, 4>& lengths) {
  const auto text = [](const GiNaC::numeric& number) {
    std::ostringstream stream;
    stream << '"' << number << '"';
    return stream.str();
  };
  const auto turned = [&](const GiNaC::numeric& length) {
    return "[" + text(length * 3 / 5) + ", " + text(length * 4 / 5) + ", 0]";
  };
  SCOPED_TRACE(text(lengths[0]) + text(lengths[1]) + text(lengths[2]) + text(lengths[3]));
  const std::string revolute = "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\n";
  const auto result = description::read_text(
      "name = \"bar\"\ntitle = \"four-bar\"\nactuated = [\"a\"]\n" + revolute + "variable = \"a\"\n" +
          revolute + "variable = \"b\"\nparent = \"base\"\norigin = " + turned(lengths[0]) +
          "\n[[tip]]\nname = \"end\"\n[[loop]]\ntype = \"rod\"\nbetween = [\"a\", \"b\"]\nat = [[" +
          text(lengths[1]) + ", 0, 0], " + turned(lengths[3]) + "]\nlength = " + text(lengths[2]) + "\n",
      "bar.toml");
  ASSERT_TRUE(result.robot) << description::to_string(result.diagnostics.front());
  const model::Mechanism mechanism{*result.robot, result.tips, result.loops};
  const auto assembly = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  ASSERT_TRUE(assembly.found);
  ASSERT_EQ(assembly.plan.steps.size(), 1U);
  EXPECT_EQ(assembly.plan.steps[0].is<derive::inverse::kind::FoldingCircle>(), expected);
  const auto certificate =
      verify::certify_loops(mechanism, assembly, derive::inverse::lower(assembly.plan), 3);
  EXPECT_EQ(certificate.assemblies, 2 * certificate.inputs);
}

/// Antiparallelograms are the other assembly of parallelograms.
TEST(Rods, OfFourBarsWithSidesEqualInPairsNeedNoRoot) {
  std::mt19937 random(3);
  const auto among = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
  };
  const auto length = [&] { return GiNaC::numeric(among(20, 99), among(100, 109)); };
  for (int i = 0; i < 10; ++i) {
    const GiNaC::numeric a = length(), b = length(), off = a + GiNaC::numeric(1, 1000000000000L);
    if (a == b) continue;
    expect_folding(true, {a, b, a, b});  // a parallelogram
    expect_folding(true, {a, b, b, a});  // a kite
    expect_folding(true, {a, a, a, a});  // a rhombus
    expect_folding(false, {a, b, off, b});
    expect_folding(false, {a, b, b, off});
  }
}

/// A head on three turns, which three motors hold by rods.
std::string head_on_three_turns() {
  std::string text =
      "name = \"m\"\ntitle = \"m\"\nactuated = [\"m1\", \"m2\", \"m3\"]\n[[tip]]\nname = \"end\"\njoint = "
      "\"yaw\"\n";
  const auto joint = [&](const std::string& variable, const std::string& axis, const std::string& more) {
    text +=
        "[[joint]]\ntype = \"revolute\"\naxis = \"" + axis + "\"\nvariable = \"" + variable + "\"\n" + more;
  };
  joint("roll", "+x", "origin = [0, 0, 0.3]\n");
  joint("pitch", "+y", "");
  joint("yaw", "+z", "");
  const std::array<std::string, 3> feet{"0.15, 0", "-0.075, 0.135", "-0.075, -0.135"};
  const std::array<std::string, 3> ends{"0.1, 0", "-0.05, 0.09", "-0.05, -0.09"};
  for (std::size_t i = 0; i < 3; ++i)
    joint("m" + std::to_string(i + 1), i == 0 ? "+y" : "+x",
          "parent = \"base\"\norigin = [" + feet[i] + ", 0]\nlink = [0.05, 0.01, 0]\n");
  for (std::size_t i = 0; i < 3; ++i)
    text += "[[loop]]\ntype = \"rod\"\nbetween = [\"m" + std::to_string(i + 1) +
            "\", \"yaw\"]\nat = [[0, 0, 0], [" + ends[i] + ", 0.02]]\nlength = 0.31\n";
  return text;
}

/// The reason says what would have a closed form, and that has one.
TEST(Rods, ThatHoldThreeTurnsSayWhatWouldHaveAClosedForm) {
  const auto read = description::read_text(head_on_three_turns(), "m.toml");
  ASSERT_TRUE(read.robot);
  const model::Mechanism mechanism{*read.robot, read.tips, read.loops};
  const auto refused = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  ASSERT_EQ(refused.reasons.size(), 1U);
  EXPECT_THAT(
      refused.reasons.front(),
      testing::AllOf(
          testing::HasSubstr("roll, pitch, yaw are open; rods that hold the same joints are solved "
                             "together if two hold two turns"),
          testing::HasSubstr("drive some of these joints in place of motors, or name them in `outputs`")));
  const auto other = verify::motor_for_closed_form(mechanism);
  ASSERT_TRUE(other.has_value());
  EXPECT_LT(other->joint, 3U);
  std::vector<std::size_t> driven = mechanism.loops.actuated;
  std::replace(driven.begin(), driven.end(), other->motor, other->joint);
  for (const auto& given : {driven, std::vector<std::size_t>{0, 1, 2}}) {  // these would be outputs
    const auto plan = derive::loops::assembly_plan(mechanism, given);
    ASSERT_TRUE(plan.found);
    const auto certificate = verify::certify_loops(mechanism, plan, derive::inverse::lower(plan.plan), 3);
    EXPECT_GE(certificate.assemblies, 3);
  }
}

}  // namespace
}  // namespace qvgen::test::loops_rods
