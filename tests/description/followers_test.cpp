// SPDX-License-Identifier: MIT
// Joints that follow others, in TOML and URDF.
#include "model/followers.h"

#include <gtest/gtest.h>

#include "description/reader.h"
#include "description/write.h"
#include "xml.h"

namespace qvgen::description {
namespace {

std::string joint(const std::string& variable, const std::string& more) {
  return "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"" + variable + "\"\n" + more;
}

ReadResult read_joints(const std::string& joints) {
  return read_text("name = \"arm\"\ntitle = \"t\"\n" + joints, "arm.toml");
}

/// Returns the complaint about a description, without its place.
std::string complaint(const std::string& joints) {
  const ReadResult result = read_joints(joints);
  EXPECT_FALSE(result.robot);
  return result.diagnostics.empty() ? "" : result.diagnostics.front().message;
}

TEST(Followers, AreTiedToTheirLeader) {
  const ReadResult result =
      read_joints(joint("a", "follows = \"b\"\nratio = \"-2/3\"\noffset = \"90 deg\"\n") + joint("b", "") +
                  joint("c", "follows = \"b\"\n") + joint("d", ""));
  ASSERT_TRUE(result.robot);
  const model::Robot& robot = *result.robot;
  ASSERT_EQ(robot.joints[0].follows.size(), 1U);
  EXPECT_EQ(robot.joints[0].follows[0].variable, "b");
  EXPECT_EQ(robot.joints[0].follows[0].ratio, cln::cl_RA(-2) / 3);
  ASSERT_EQ(robot.joints[0].before.turns.size(), 1U);
  EXPECT_EQ(to_string(robot.joints[0].before.turns[0].angle), "1/2*pi");
  EXPECT_TRUE(robot.joints[1].follows.empty());
  EXPECT_EQ(robot.joints[2].follows.at(0).ratio, 1);
  EXPECT_EQ(model::variables(robot), (std::vector<std::string>{"b", "d"}));
  const auto shares = model::shares(robot);
  EXPECT_EQ(shares[0].at(0).driven, 0U);
  EXPECT_EQ(shares[2].at(0).driven, 0U);
  EXPECT_EQ(shares[3].at(0).driven, 1U);
}

TEST(Followers, OffsetsOfSlidesGoAlongTheirAxis) {
  const ReadResult result = read_joints(
      joint("a", "") +
      "[[joint]]\ntype = \"prismatic\"\naxis = \"-y\"\nvariable = \"s\"\nfollows = \"a\"\nratio = 0.1\n"
      "origin = [1, 2, 3]\nrpy = [\"90 deg\", 0, 0]\noffset = 0.5\n");
  ASSERT_TRUE(result.robot);
  // -y of the turned frame is -z.
  EXPECT_EQ(to_string(result.robot->joints[1].before.translation[2]), "5/2");
}

TEST(Followers, LimitsBecomeTheLeaders) {
  const ReadResult result =
      read_joints(joint("a", "limits = [-1, 2]\n") +
                  joint("b", "follows = \"a\"\nratio = -2\noffset = 1\nlimits = [-2, 2]\n"));
  ASSERT_TRUE(result.robot);
  // -2 <= 1 - 2 a <= 2: a from -1/2 to 3/2.
  EXPECT_EQ(to_string(result.robot->joints[0].limits->lower), "-1/2");
  EXPECT_EQ(to_string(result.robot->joints[0].limits->upper), "3/2");
  EXPECT_FALSE(result.robot->joints[1].limits);
  EXPECT_EQ(complaint(joint("a", "limits = [2, 3]\n") + joint("b", "follows = \"a\"\nlimits = [0, 1]\n")),
            "the limits of 'b' and of 'a', which it follows, leave no value that is within both");
}

TEST(Followers, MistakesAreReported) {
  const std::string leader = joint("theta1", "");
  EXPECT_EQ(complaint(leader + joint("b", "follows = \"theta2\"\n")),
            "'b' follows 'theta2', which is no joint of the chain");
  EXPECT_EQ(complaint(leader + joint("b", "follows = \"b\"\n")), "'b' follows 'b': no joint leads itself");
  EXPECT_EQ(complaint(leader + joint("b", "follows = \"theta1\"\n") + joint("c", "follows = \"b\"\n")),
            "'c' follows 'b', which follows another itself");
  EXPECT_EQ(complaint(joint("a", "follows = \"b\"\n") + joint("b", "follows = \"a\"\n")),
            "'a' follows 'b', which follows another itself");
  EXPECT_EQ(complaint(leader + joint("b", "follows = \"theta1\"\nratio = 0\n")),
            "with a ratio of 0 the joint does not move");
  EXPECT_EQ(complaint(leader + joint("b", "follows = \"theta1\"\nratio = \"sqrt(2)\"\n")),
            "the ratio is not rational");
  EXPECT_EQ(complaint(leader + joint("b", "follows = \"theta1\"\nratio = \"1/0\"\n")), "division by zero");
  EXPECT_EQ(complaint(leader + joint("b", "follows = \"theta1\"\nratio = \"x\"\n")), "undefined symbol 'x'");
  EXPECT_EQ(complaint(leader + joint("b", "ratio = 2\n")), "'ratio' without 'follows'");
  EXPECT_EQ(complaint(leader + joint("b", "offset = 2\n")), "'offset' without 'follows'");
  EXPECT_EQ(complaint(leader + joint("b", "follows = 3\n")), "'follows' is a number");
}

std::string urdf(const std::string& mimic) {
  const auto revolute = [](const std::string& name, const std::string& from, const std::string& to,
                           const std::string& more) {
    return "<joint name=\"" + name + "\" type=\"revolute\"><parent link=\"" + from + "\"/><child link=\"" +
           to + "\"/><axis xyz=\"0 0 1\"/><limit lower=\"-3\" upper=\"3\" effort=\"1\" velocity=\"1\"/>" +
           more + "</joint>\n";
  };
  return "<robot name=\"arm\">\n<link name=\"base\"/><link name=\"a\"/><link name=\"b\"/><link "
         "name=\"c\"/>\n" +
         revolute("first-joint", "base", "a", "") + revolute("second", "a", "b", mimic) +
         revolute("third", "b", "c", "") + "</robot>";
}

TEST(Followers, AreTheMimicJointsOfAUrdf) {
  const ReadResult result =
      read_text(urdf("<mimic joint=\"first-joint\" multiplier=\"-0.5\" offset=\"1.5708\"/>"), "arm.urdf");
  ASSERT_TRUE(result.robot);
  const model::Joint& second = result.robot->joints[1];
  ASSERT_EQ(second.follows.size(), 1U);
  EXPECT_EQ(second.follows[0].variable, result.robot->joints[0].variable);
  EXPECT_EQ(second.follows[0].ratio, cln::cl_RA(-1) / 2);
  EXPECT_EQ(to_string(second.before.turns.at(0).angle), "1/2*pi");
  // Written and read again: the same.
  const ReadResult again = read_text(write_text(*result.robot), "arm.toml");
  ASSERT_TRUE(again.robot);
  EXPECT_EQ(write_text(*again.robot), write_text(*result.robot));
  ASSERT_EQ(again.robot->joints[1].follows.size(), 1U);
  EXPECT_EQ(again.robot->joints[1].follows[0].ratio, second.follows[0].ratio);
}

TEST(Followers, NoneIsAdvisedToFollowItself) {
  const ReadResult result = read_joints(joint("arm", "") + joint("finger_2", "follows = \"finger_1\"\n"));
  ASSERT_FALSE(result.diagnostics.empty());
  EXPECT_EQ(result.diagnostics.front().hint, "take a chain with both, or make it a joint of its own");
}

TEST(Followers, MistakesOfAUrdfAreReported) {
  const auto message = [](const std::string& mimic) {
    const ReadResult result = read_text(urdf(mimic), "arm.urdf");
    EXPECT_FALSE(result.robot) << mimic;
    for (const Diagnostic& each : result.diagnostics)
      if (each.severity == Diagnostic::error) return each.message;
    return std::string();
  };
  EXPECT_EQ(message("<mimic joint=\"gripper\"/>"),
            "'second' follows 'gripper', which is no joint of the chain");
  EXPECT_EQ(message("<mimic multiplier=\"2\"/>"), "the joint 'second' mimics none");
  EXPECT_EQ(message("<mimic joint=\"third\" multiplier=\"0\"/>"),
            "with a multiplier of 0 the joint 'second' does not move");
  EXPECT_EQ(message("<mimic joint=\"second\"/>"), "'second' follows 'second': no joint leads itself");
}

}  // namespace
}  // namespace qvgen::description
