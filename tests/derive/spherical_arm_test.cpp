// SPDX-License-Identifier: MIT
// Which arms have an arm angle: found from the model, whatever frames and zeros it is written in. What is
// found is certified on the way: joints of the described arm are among the solutions.
#include <gtest/gtest.h>

#include "../inverse/families/seven_arms.h"
#include "description/reader.h"
#include "pipeline/products/arm_angle.h"

namespace qvgen::test {
namespace {

pipeline::RobotOutput made_of(const std::string& arm) {
  const auto read = description::read_text("name = \"arm\"\ntitle = \"arm\"\n" + arm, "arm.toml");
  EXPECT_TRUE(read.robot) << (read.diagnostics.empty() ? "" : read.diagnostics.front().message);
  pipeline::RobotOutput output{"arm"};
  if (read.robot) pipeline::generate_arm_angle(*read.robot, output);
  return output;
}

bool has_arm_angle(const std::string& arm) {
  const pipeline::RobotOutput output = made_of(arm);
  return output.files.size() == 2 && output.missing.empty();
}

std::string reason(const std::string& arm) {
  const pipeline::RobotOutput output = made_of(arm);
  EXPECT_TRUE(output.files.empty());
  return output.missing.size() == 1 ? output.missing.front().reason : "";
}

/// Shoulder, elbow and wrist by Denavit and Hartenberg's table, what precedes it left open.
std::string table(const std::string& keys, const std::string& phase, const std::string& upper,
                  const std::string& offset = "0", const std::string& shift = "0") {
  return keys + "convention = \"standard\"\n" +
         "dh = [{ theta = \"q1\", variable = \"q1\", d = 0.34, alpha = \"-90 deg\" },\n"
         "{ theta = \"q2" +
         phase +
         "\", variable = \"q2\", alpha = \"90 deg\" },\n"
         "{ theta = \"q3\", variable = \"q3\", d = " +
         upper + ", a = " + offset +
         ", alpha = \"90 deg\" },\n"
         "{ theta = \"-q4" +
         phase + "\", variable = \"q4\", d = " + shift +
         ", alpha = \"-90 deg\" },\n"
         "{ theta = \"q5\", variable = \"q5\", d = 0.4, alpha = \"-90 deg\" },\n"
         "{ theta = \"q6" +
         phase +
         "\", variable = \"q6\", alpha = \"90 deg\" },\n"
         "{ theta = \"q7\", variable = \"q7\", d = 0.126 }]\n";
}

TEST(SphericalArm, IsFoundInAnyFramesAndZeros) {
  EXPECT_TRUE(has_arm_angle(seven_arms[1].text()));
  EXPECT_TRUE(has_arm_angle(seven_arms[4].text()));
  EXPECT_TRUE(has_arm_angle(table("", "", "0.4")));
  EXPECT_TRUE(has_arm_angle(table("", " + 90 deg", "0.4")));
  EXPECT_TRUE(has_arm_angle(table("", " - 37 deg", "0.4", "0.03")));
  EXPECT_TRUE(has_arm_angle(table("", "", "0.4", "0.03", "0.05"))) << "elbow beside the plane";
  EXPECT_TRUE(
      has_arm_angle(table("base = { translation = [1, 2, 0.3], rpy = [\"20 deg\", \"35 deg\", 0] }\n"
                          "tool = { translation = [0.1, 0, 0.2], rpy = [0, \"50 deg\", 0] }\n",
                          " + 12 deg", "0.4")));
}

TEST(SphericalArm, LengthsMayBeSymbols) {
  EXPECT_TRUE(has_arm_angle(table("", "", "\"l1\"", "\"a1\"")));
  EXPECT_TRUE(has_arm_angle(table("defaults = { l1 = 0.42 }\n", " + 30 deg", "\"l1\"")));
}

TEST(SphericalArm, WhatIsNoneIsToldWhy) {
  EXPECT_EQ(reason(seven_arms[0].text()),
            "no arm angle: the axes of joints 5, 6 and 7 do not meet in one point");
  const std::string through = reason(table("", "", "0"));
  EXPECT_NE(through.find("the axis of joint 4 goes through the shoulder"), std::string::npos) << through;
  // A rail: nothing is said, nobody would look for an arm angle.
  const pipeline::RobotOutput rail = made_of(seven_arms[2].text());
  EXPECT_TRUE(rail.files.empty() && rail.missing.empty());
}

}  // namespace
}  // namespace qvgen::test
