// SPDX-License-Identifier: MIT
// What a derivation sees of an arm does not depend on the notation.
#include "canonical/arm.h"

#include <gtest/gtest.h>

#include "description/reader.h"
#include "model/arithmetic.h"

namespace qvgen::canonical {
namespace {

model::Robot robot(const std::string& text) {
  const description::ReadResult result =
      description::read_text("name = \"arm\"\ntitle = \"arm\"\n" + text, "arm.toml");
  EXPECT_TRUE(result.robot.has_value()) << (result.diagnostics.empty() ? "" : result.diagnostics[0].message);
  return result.robot.value_or(model::Robot{});
}

std::string text_of(const model::Displacement& displacement) {
  std::string text;
  for (const auto& component : displacement.translation) text += model::to_string(component) + " ";
  for (const auto& turn : displacement.turns)
    text += "about (" + model::to_string(turn.axis[0]) + " " + model::to_string(turn.axis[1]) + " " +
            model::to_string(turn.axis[2]) + ") by " + model::to_string(turn.angle) + " ";
  return text;
}

/// Everything but the phases.
std::string geometry_of(const Arm& arm) {
  std::string text = text_of(arm.robot.base);
  for (const model::Joint& joint : arm.robot.joints)
    text += "| " + text_of(joint.before) + "joint " + text_of(joint.after);
  return text + "| " + text_of(arm.robot.tool);
}

const std::string table = R"toml(convention = "standard"
[[dh]]
theta = "theta1"
variable = "theta1"
d = 0.3
alpha = "40 deg"
[[dh]]
theta = "theta2@A@"
variable = "theta2"
a = "l2"
[[dh]]
theta = "theta3@B@"
variable = "theta3"
a = 0.1
alpha = "0.3"
)toml";

std::string with(std::string text, const std::string& a, const std::string& b) {
  text.replace(text.find("@A@"), 3, a);
  return text.replace(text.find("@B@"), 3, b);
}

TEST(CanonicalArm, RightAngledArmsStayAsTheyAreDescribed) {
  const model::Robot plain = robot(R"toml([[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
link = ["l1", 0, "1/3"]
[[joint]]
type = "prismatic"
axis = "-y"
variable = "d2"
rpy = [0, "90 deg", 0]
)toml");
  const Arm arm = for_kinematics(plain);
  EXPECT_FALSE(arm.has_phases());
  EXPECT_EQ(geometry_of(arm), geometry_of({plain, {}}));
}

TEST(CanonicalArm, ZerosOfJointsAreTheirPhases) {
  const Arm at_zero = for_kinematics(robot(with(table, "", "")));
  EXPECT_FALSE(at_zero.has_phases());
  for (const char* offset : {" + 79.35 deg", " - 0.7", " + 90 deg", " - 30 deg"}) {
    const Arm turned = for_kinematics(robot(with(table, offset, "")));
    EXPECT_TRUE(turned.has_phases()) << offset;
    EXPECT_EQ(geometry_of(turned), geometry_of(at_zero)) << offset;
  }
}

TEST(CanonicalArm, OppositeOffsetsCancelInTheSum) {
  const Arm arm = for_kinematics(robot(with(table, " - 1.2345", " + 1.2345")));
  EXPECT_EQ(arm.phases[1] + arm.phases[2], exact::Angle{});
}

TEST(CanonicalArm, TwistsInRadiansAreKeptAsWritten) {
  const Arm arm = for_kinematics(robot(with(table, "", "")));
  EXPECT_EQ(model::to_string(arm.robot.joints[1].before.turns.at(0).angle), "turn(2/9)");
  EXPECT_EQ(model::to_string(arm.robot.tool.turns.at(0).angle), "angle(3/10)");
}

TEST(CanonicalArm, QuotientsAndRootsOfSymbolsAreDefined) {
  const Arm arm = for_kinematics(robot(R"toml([[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
link = ["l1/l2", 0, "sqrt(l1^2 + l2^2)"]
)toml"));
  ASSERT_EQ(arm.robot.definitions.size(), 2U);
  EXPECT_EQ(model::to_string(arm.robot.definitions.at("value(l1/l2)")), "l1/l2");
}

TEST(CanonicalArm, ObliqueAxesWithRootsComeToLieAlongZ) {
  const Arm arm = for_kinematics(robot(R"toml([[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
[[joint]]
type = "revolute"
axis = ["1/sqrt(3)", "1/sqrt(3)", "1/sqrt(3)"]
variable = "theta2"
link = [0.1, 0, 0]
)toml"));
  for (const model::Joint& joint : arm.robot.joints) {
    EXPECT_TRUE(joint.axis[0].is_literal_zero() && joint.axis[1].is_literal_zero());
    EXPECT_EQ(joint.axis[2].number(), 1);
  }
}

}  // namespace
}  // namespace qvgen::canonical
