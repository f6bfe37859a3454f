// SPDX-License-Identifier: MIT
// Motors of an MJCF that act on fixed tendons: what joints follow, against the lengths of the tendons in
// numbers, and where joints keep values of their own.
#include <random>

#include <fmt/format.h>

#include "model/evaluate.h"
#include "model/followers.h"
#include "xml.h"

namespace qvgen::description {
namespace {

using Coefficients = std::array<double, 3>;

std::string chain(const std::string& sections, const Coefficients& references = {0, 0, 0}) {
  return hinges({references.begin(), references.end()}, sections);
}

std::string tendon(const std::string& name, const Coefficients& coefficients,
                   const std::string& attributes = "") {
  std::string joints;
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    if (coefficients[i] != 0) joints += fmt::format("<joint joint=\"j{}\" coef=\"{}\"/>", i, coefficients[i]);
  return "<fixed name=\"" + name + "\" " + attributes + ">" + joints + "</fixed>";
}
std::string tendons(const std::string& content) { return "<tendon>" + content + "</tendon>\n"; }
std::string actuators(const std::vector<std::string>& on_tendons,
                      const std::vector<std::string>& on_joints = {}) {
  std::string text = "<actuator>";
  for (const std::string& name : on_tendons) text += "<motor tendon=\"" + name + "\"/>";
  for (const std::string& name : on_joints) text += "<motor joint=\"" + name + "\"/>";
  return text + "</actuator>\n";
}

std::string relation(const model::Robot& arm, std::size_t joint) {
  return model::relation_text(arm.joints.at(joint).follows);
}

constexpr Coefficients sum{0, 1, 1}, difference{0, 1, -1};

TEST(MjcfMotors, ADifferentialFollowsItsMotors) {
  const model::Robot arm =
      read(chain(tendons(tendon("left", sum, "range=\"-1 2\" damping=\"0.5\" armature=\"0.01\"") +
                         tendon("right", difference)) +
                 actuators({"left", "right"}, {"j0"})));
  EXPECT_EQ(relation(arm, 1), "1/2 left + 1/2 right");
  EXPECT_EQ(relation(arm, 2), "1/2 left - 1/2 right");
  EXPECT_TRUE(arm.joints[0].follows.empty());
  ASSERT_EQ(arm.motors.size(), 2U);
  EXPECT_EQ(model::to_double(model::evaluate(arm.motors[0].limits->upper)), 2);
  EXPECT_EQ(model::to_double(model::evaluate(arm.motors[0].drive.viscous_friction)), 0.5);
  EXPECT_EQ(model::to_double(model::evaluate(arm.motors[0].drive.rotor_inertia)), 0.01);
  EXPECT_FALSE(arm.motors[1].limits);
}

/// A belt that couples the elbow to the shoulder, which has a motor of its own.
TEST(MjcfMotors, AJointWithAMotorOfItsOwnIsKnown) {
  const model::Robot arm =
      read(chain(tendons(tendon("belt", {0.5, 2, 0})) + actuators({"belt"}, {"j0", "j2"})));
  EXPECT_EQ(relation(arm, 1), "1/2 belt - 1/4 j0");
  EXPECT_EQ(arm.motors.size(), 1U);
}

TEST(MjcfMotors, AClassGivesATendonItsAttributes) {
  const model::Robot arm = read(chain("<default><tendon armature=\"0.25\"/></default>" +
                                      tendons(tendon("belt", {0, 2, 0})) + actuators({"belt"})));
  ASSERT_EQ(arm.motors.size(), 1U);
  EXPECT_EQ(model::to_double(model::evaluate(arm.motors[0].drive.rotor_inertia)), 0.25);
}

/// A gripper's fingers, which <equality> ties: the tendon's length is the finger's value.
TEST(MjcfMotors, ALengthThatIsAJointsValueIsThatJoint) {
  const std::string text = chain(tendons(tendon("split", {0, 0.5, 0.5})) + actuators({"split"}) +
                                 "<equality><joint joint1=\"j2\" joint2=\"j1\"/></equality>\n");
  const model::Robot arm = read(text);
  EXPECT_TRUE(arm.motors.empty());
  EXPECT_EQ(relation(arm, 2), "j1");
  EXPECT_EQ(report(text), "");
}

TEST(MjcfMotors, JointsThatFollowTiedOnesFollowMotors) {
  const model::Robot arm =
      read(chain(tendons(tendon("split", {0, 1, 0.5})) + actuators({"split"}) +
                 "<equality><joint joint1=\"j2\" joint2=\"j1\" polycoef=\"0 -1\"/></equality>\n"));
  EXPECT_EQ(relation(arm, 1), "2 split");
  EXPECT_EQ(relation(arm, 2), "-2 split");
}

TEST(MjcfMotors, ATendonMayBeCalledAsAJoint) {
  const model::Robot arm = read(chain(tendons(tendon("j0", {0, 2, 0})) + actuators({"j0"})));
  EXPECT_EQ(relation(arm, 1), "1/2 j0_1");
  EXPECT_TRUE(arm.joints[0].follows.empty());
}

/// The lengths of random tendons, by the joints that follow random motors.
TEST(MjcfMotors, KeepsTheLengthsOfRandomTendons) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-2, 2);
  std::uniform_int_distribution<int> kind(0, 3);
  const auto rounded = [&] { return std::round(number(random) * 1e3) / 1e3; };
  int solved = 0;
  for (int k = 0; k < 200; ++k) {
    const int count = 1 + k % 3;
    const Coefficients references{rounded(), rounded(), rounded()};
    std::vector<Coefficients> all;
    std::vector<std::string> names, driven;
    std::string text;
    for (int i = 0; i < count; ++i) {
      Coefficients coefficients{};
      for (std::size_t joint = 0; joint < 3; ++joint) {
        const bool may_be_none = static_cast<int>(joint) < 3 - count;  // those with motors of their own
        coefficients.at(joint) = may_be_none && kind(random) == 0 ? 0 : rounded();
      }
      all.push_back(coefficients);
      names.push_back("t" + std::to_string(i));
      text += tendon(names.back(), coefficients);
    }
    for (int i = count; i < 3; ++i) driven.push_back("j" + std::to_string(i - count));
    ReadOptions as_written;
    as_written.snap.mode = SnapOptions::off;
    const model::Robot arm = read(chain(tendons(text) + actuators(names, driven), references), as_written);
    ASSERT_EQ(arm.joints.size(), 3U);
    std::map<std::string, double> values;
    for (const std::string& variable : model::variables(arm)) values[variable] = number(random);
    Coefficients q{};
    for (std::size_t i = 0; i < 3; ++i) {
      const model::Joint& joint = arm.joints[i];
      q.at(i) = references.at(i) + (joint.follows.empty() ? values.at(joint.variable) : 0);
      for (const model::Turn& turn : joint.before.turns)
        q.at(i) += model::to_double(model::evaluate(turn.angle));
      for (const model::Lead& lead : joint.follows)
        q.at(i) += cln::double_approx(lead.ratio) * values.at(lead.variable);
    }
    for (const model::Motor& motor : arm.motors) {
      const auto& c = all.at(static_cast<std::size_t>(motor.variable.back() - '0'));
      EXPECT_NEAR(c[0] * q[0] + c[1] * q[1] + c[2] * q[2], values.at(motor.variable), 1e-8) << k;
      ++solved;
    }
  }
  EXPECT_GT(solved, 380);
}

TEST(MjcfMotors, JointsThatMotorsDoNotTellApartAreTold) {
  const std::string told =
      "7:11: warning: the motor of the tendon 't0' moves 'j1', 'j2', which motors do not tell apart: each "
      "has a "
      "value of its own; its force acts on a joint by the tendon's 'coef'\n";
  EXPECT_EQ(report(chain(tendons(tendon("t0", sum)) + actuators({"t0"}))), told);
  // More motors than joints, and motors that pull alike.
  for (const Coefficients& other : {sum, Coefficients{0, -2, -2}})
    EXPECT_NE(report(chain(tendons(tendon("t0", sum) + tendon("t1", other)) + actuators({"t0", "t1"})))
                  .find(told.substr(5)),
              std::string::npos);
  EXPECT_NE(
      report(chain(tendons(tendon("t0", sum)) + actuators({"t0"}, {"j1", "j2"}))).find("do not tell apart"),
      std::string::npos);
}

TEST(MjcfMotors, AChainWithSomeOfTheJointsIsTold) {
  ReadOptions options;
  options.tip = "b1";
  const std::string text =
      chain(tendons(tendon("left", sum) + tendon("right", difference)) + actuators({"left", "right"}));
  EXPECT_NE(report(text, options)
                .find("the motors of 'j1' act by tendons, but the chain has not all of their joints"),
            std::string::npos)
      << report(text, options);
}

TEST(MjcfMotors, JointsThatBranchHaveValuesOfTheirOwn) {
  const auto finger = [](const std::string& name) {
    return "<body name=\"" + name + "\" pos=\"1 0 0\"><joint name=\"j_" + name +
           "\"/><geom size=\"0.1\"/></body>";
  };
  const std::string text = "<mujoco model=\"hand\"><worldbody>" + finger("a") + finger("b") +
                           "</worldbody>\n" +
                           tendons("<fixed name=\"t\"><joint joint=\"j_a\" coef=\"2\"/></fixed>") +
                           actuators({"t"}) + "</mujoco>\n";
  ReadOptions options;
  options.tips = {"all"};
  EXPECT_NE(report(text, options).find("the motors of 'j_a' act by tendons, but the robot's joints branch"),
            std::string::npos)
      << report(text, options);
}

/// Friction whose direction would be no sum of the motors': the file is read without them.
TEST(MjcfMotors, JointsWithCoulombFrictionHaveValuesOfTheirOwn) {
  const std::string text = "<default><joint frictionloss=\"0.1\"/></default>" +
                           tendons(tendon("left", sum) + tendon("right", difference)) +
                           actuators({"left", "right"});
  const ReadResult result = read_text(chain(text), "r.xml", {});
  ASSERT_TRUE(result.robot);
  EXPECT_TRUE(result.robot->motors.empty());
  EXPECT_NE(report(chain(text))
                .find("'j1' would follow several and has Coulomb friction: it has a value of its own"),
            std::string::npos)
      << report(chain(text));
  const std::string alone =
      "<default><joint frictionloss=\"0.1\"/></default>" + tendons(tendon("t", {0, 2, 0})) + actuators({"t"});
  EXPECT_EQ(relation(read(chain(alone)), 1), "1/2 t");
}

TEST(MjcfMotors, WhatIsNoTendonOfTheFileIsLeftOut) {
  EXPECT_EQ(report(chain(actuators({"none"}))), "");
  EXPECT_EQ(report(chain(tendons("<fixed name=\"t\"><joint joint=\"nobody\" coef=\"1\"/></fixed>") +
                         actuators({"t"}))),
            "");
  EXPECT_EQ(report(chain(tendons("<spatial name=\"t\"/>") + actuators({"t"}))),
            "6:1: warning: <tendon> is not read; add its forces to what the dynamics gives\n");
}

/// A hostile file: hundreds of tendons that share joints.
TEST(MjcfMotors, ManyTendonsEnd) {
  std::string text;
  std::vector<std::string> names;
  for (int i = 0; i < 500; ++i) {
    names.push_back("t" + std::to_string(i));
    text += tendon(names.back(), {1, 0.001 * i, 1});
  }
  EXPECT_NE(report(chain(tendons(text) + actuators(names))).find("do not tell apart"), std::string::npos);
}

}  // namespace
}  // namespace qvgen::description
