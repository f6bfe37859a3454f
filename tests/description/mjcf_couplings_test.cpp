// SPDX-License-Identifier: MIT
// Joints of an MJCF that <equality> ties: what they follow, against MuJoCo's own equation in numbers, and
// what is refused.
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "model/evaluate.h"
#include "xml.h"

namespace qvgen::description {
namespace {

std::string chain(const std::string& sections, const std::vector<double>& references = {0, 0, 0, 0}) {
  return hinges(references, sections);
}

std::string equality(const std::string& content) { return "<equality>" + content + "</equality>\n"; }
std::string tied(const std::string& follower, const std::string& leader, const std::string& coefficients) {
  return "<joint joint1=\"" + follower + "\" joint2=\"" + leader + "\" polycoef=\"" + coefficients + "\"/>";
}

/// How far a hinge about z is turned from the file's pose, by what was read of it and the values of joints.
double turned(const model::Robot& robot, std::size_t joint, const std::vector<double>& values) {
  double angle = robot.joints[joint].follows.empty() ? values[joint] : 0;
  for (const model::Turn& turn : robot.joints[joint].before.turns)
    angle += model::to_double(model::evaluate(turn.angle));
  for (const model::Lead& lead : robot.joints[joint].follows)
    angle += cln::double_approx(lead.ratio) * values[static_cast<std::size_t>(lead.variable.back() - '0')];
  return angle;
}

TEST(MjcfCouplings, AJointFollowsAnother) {
  const model::Robot arm = read(chain(equality(tied("j2", "j1", "0.5 -2 0 0 0"))));
  ASSERT_EQ(arm.joints.size(), 4U);
  ASSERT_EQ(arm.joints[2].follows.size(), 1U);
  EXPECT_EQ(arm.joints[2].follows[0].variable, "j1");
  EXPECT_EQ(arm.joints[2].follows[0].ratio, -2);
  EXPECT_EQ(texts(arm.joints[2].before), "0, 0, 1 by 1/2; 1, 0, 0");
  EXPECT_TRUE(arm.joints[1].follows.empty());
}

TEST(MjcfCouplings, WithoutCoefficientsItHasItsValue) {
  const model::Robot arm = read(chain(equality("<joint joint1=\"j0\" joint2=\"j3\"/>")));
  ASSERT_EQ(arm.joints[0].follows.size(), 1U);
  EXPECT_EQ(arm.joints[0].follows[0].variable, "j3");
  EXPECT_EQ(arm.joints[0].follows[0].ratio, 1);
}

/// j2 = 2 j1 + 1 and j3 = 3 j2 give j3 = 6 j1 + 3.
TEST(MjcfCouplings, FollowersOfFollowersFollowTheFirst) {
  const model::Robot arm = read(chain(equality(tied("j3", "j2", "0 3") + tied("j2", "j1", "1 2"))));
  ASSERT_EQ(arm.joints[3].follows.size(), 1U);
  EXPECT_EQ(arm.joints[3].follows[0].variable, "j1");
  EXPECT_EQ(arm.joints[3].follows[0].ratio, 6);
  EXPECT_EQ(texts(arm.joints[3].before), "0, 0, 1 by 3; 1, 0, 0");
}

TEST(MjcfCouplings, DegreesAreOfTheFileAndCoefficientsInRadians) {
  const model::Robot arm = read(
      "<mujoco model=\"arm\"><worldbody><body><joint name=\"a\" ref=\"90\"/><body><joint "
      "name=\"b\"/></body></body>"
      "</worldbody>" +
      equality(tied("b", "a", "1.5708 0.5")) + "</mujoco>");
  // b = pi/2 + (a - pi/2)/2
  ASSERT_EQ(arm.joints[1].follows.size(), 1U);
  EXPECT_EQ(texts(arm.joints[1].before), "0, 0, 1 by 1/4*pi; 0, 0, 0");
}

/// The joint follows that the tendons name last: 2 (j3 - r3) + (j1 - r1) = a0 + a1 (j0 - r0).
TEST(MjcfCouplings, TendonsTieSums) {
  const std::string tendons =
      "<tendon><fixed name=\"one\"><joint joint=\"j1\" coef=\"1\"/><joint joint=\"j3\" coef=\"2\"/></fixed>"
      "<fixed name=\"two\"><joint joint=\"j0\" coef=\"4\"/></fixed></tendon>";
  const model::Robot arm =
      read(chain(tendons + equality("<tendon tendon1=\"one\" tendon2=\"two\" polycoef=\"0.5 3\"/>")));
  ASSERT_EQ(arm.joints[3].follows.size(), 2U);
  EXPECT_EQ(arm.joints[3].follows[0].variable, "j0");
  EXPECT_EQ(arm.joints[3].follows[0].ratio, 6);
  EXPECT_EQ(arm.joints[3].follows[1].variable, "j1");
  EXPECT_EQ(arm.joints[3].follows[1].ratio, cln::cl_RA("-1/2"));
  EXPECT_EQ(texts(arm.joints[3].before), "0, 0, 1 by 1/4; 1, 0, 0");
}

/// MuJoCo's equation y - y0 = a0 + a1 (x - x0), for random references and relations.
TEST(MjcfCouplings, KeepsMuJoCosEquation) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-2, 2);
  std::uniform_int_distribution<std::size_t> joint(0, 3);
  int followers = 0;
  for (int k = 0; k < 200; ++k) {
    std::vector<double> references(4), values(4);
    for (std::size_t i = 0; i < 4; ++i) {
      references[i] = std::round(number(random) * 1e4) / 1e4;
      values[i] = number(random);
    }
    const std::size_t first = joint(random), second = joint(random), third = joint(random);
    if (first == second || first == third || second == third) continue;
    const double a0 = std::round(number(random) * 1e3) / 1e3, a1 = std::round(number(random) * 1e3) / 1e3;
    const auto name = [](std::size_t i) { return "j" + std::to_string(i); };
    const std::string coefficients = fmt::format("{} {}", a0, a1);
    ReadOptions as_written;
    as_written.snap.mode = SnapOptions::off;
    const model::Robot arm = read(chain(equality(tied(name(first), name(second), coefficients) +
                                                 tied(name(second), name(third), "0.25 -1.5")),
                                        references),
                                  as_written);
    ASSERT_EQ(arm.joints.size(), 4U);
    const double x = turned(arm, third, values), y = turned(arm, second, values),
                 z = turned(arm, first, values);
    EXPECT_NEAR(x, values[third] - references[third], 1e-12);
    EXPECT_NEAR(y, 0.25 - 1.5 * x, 1e-12);
    EXPECT_NEAR(z, a0 + a1 * y, 1e-12);
    followers += arm.joints[first].follows.empty() ? 0 : 1;
  }
  EXPECT_GT(followers, 50);
}

TEST(MjcfCouplings, MistakesOfRelationsAreRefused) {
  EXPECT_EQ(report(chain(equality(tied("j2", "j1", "0 1 0 0 0 0")))),
            "7:52: error: 'polycoef' has 6 numbers; give one to five, e.g. polycoef=\"0 1\"\n");
  EXPECT_EQ(report(chain(equality(tied("j2", "j1", "0 1") + tied("j2", "j0", "0 1")))),
            "7:11: error: the joint 'j2' is tied twice; keep one of the relations\n");
  EXPECT_EQ(report(chain(equality(tied("j2", "j1", "0 1") + tied("j1", "j2", "0 1")))),
            "7:11: error: the joint 'j2' follows joints that follow it; keep one of the relations\n"
            "7:58: error: the joint 'j1' follows joints that follow it; keep one of the relations\n");
}

TEST(MjcfCouplings, WhatTiesNoTwoJointsIsTold) {
  EXPECT_EQ(
      report(chain(equality("<joint joint1=\"j2\" polycoef=\"0.5\"/>"))),
      "7:11: warning: <equality> holds the joint 'j2', which is read as free; with --fixed j2 it is held at "
      "zero\n");
  EXPECT_EQ(report(chain(equality(tied("j2", "finger", "0 1")))),
            "7:11: warning: 'j2' follows 'finger', which is no joint of the chain: it is read as free; take "
            "a chain "
            "with both if it shall follow\n");
  ReadOptions to_the_end;
  to_the_end.tip = "b3";
  EXPECT_EQ(report(chain(equality("<weld body1=\"b1\"/>")), to_the_end),
            "7:11: warning: <weld> of <equality> is not read: joints move freely; loops belong to whole "
            "robots, without --tip\n");
  EXPECT_EQ(report(chain("<tendon><fixed name=\"t\"/></tendon>\n")),
            "7:1: warning: <tendon> is not read; add its forces to what the dynamics gives\n");
  EXPECT_EQ(report(chain(equality("<joint joint1=\"j2\" joint2=\"j1\" active=\"false\"/>"))), "");
}

/// MuJoCo's limits give way: a file whose limits contradict its relation is read, with the leader's.
TEST(MjcfCouplings, LimitsThatContradictARelationAreTold) {
  const std::string text =
      "<mujoco model=\"arm\"><compiler angle=\"radian\"/><worldbody><body><joint name=\"a\" range=\"0 "
      "1.5\"/><body>"
      "<joint name=\"b\" range=\"0 2\"/></body></body></worldbody>\n" +
      equality(tied("b", "a", "-1.6 1")) + "</mujoco>";
  const ReadResult result = read_text(text, "r.xml", {});
  ASSERT_TRUE(result.robot);
  ASSERT_TRUE(result.robot->joints[0].limits);
  EXPECT_EQ(model::to_double(model::evaluate(result.robot->joints[0].limits->upper)), 1.5);
  EXPECT_NE(report(text).find(
                "warning: the limits of 'b' and of 'a', which it follows, leave no value that is within "
                "both: those of 'a' count"),
            std::string::npos)
      << report(text);
}

/// A hostile file: a thousand joints, each of which follows the one before.
TEST(MjcfCouplings, LongChainsOfFollowersEnd) {
  std::string relations;
  for (int i = 1; i < 1000; ++i)
    relations += tied("j" + std::to_string(i), "j" + std::to_string(i - 1), "0.1 1.1");
  const std::string said = report(chain(equality(relations), std::vector<double>(400, 0.0)));
  EXPECT_FALSE(said.empty());
}

}  // namespace
}  // namespace qvgen::description
