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
      "has a value of its own; its force acts by the tendon's 'coef'; what ties the joints by <equality>, "
      "or a motor for each, would tell them apart\n";
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
  EXPECT_NE(
      report(text, options)
          .find("the motors of 'j1' act by tendons, but 'j2', which they move too, is not among the joints"),
      std::string::npos)
      << report(text, options);
}

/// A finger of two joints, j_NAME0 and j_NAME1.
std::string finger(const std::string& name) {
  const auto link = [&](int i) {
    return fmt::format("<body name=\"{0}{1}\" pos=\"1 0 0\"><joint name=\"j_{0}{1}\"/><geom size=\"0.1\"/>",
                       name, i);
  };
  return link(0) + link(1) + "</body></body>";
}

/// Two fingers, whose joints random tendons pull, as rational factors by the joints' names.
struct Fingers {
  std::map<std::string, std::map<std::string, cln::cl_RA>> tendons;
  std::string text;

  Fingers(unsigned seed, int count, const std::string& sections) {
    std::mt19937 random(seed);
    std::string content;
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i) {
      std::string joints;
      names.push_back(fmt::format("t{}", i));
      for (const char* joint : {"j_a0", "j_a1", "j_b0", "j_b1"}) {
        const int thousandths = static_cast<int>(random() % 4000) - 2000;
        if (thousandths == 0 || (count == 4 && random() % 3 == 0)) continue;
        tendons[names.back()][joint] = cln::cl_RA(thousandths) / 1000;
        joints += fmt::format("<joint joint=\"{}\" coef=\"{:.3f}\"/>", joint, thousandths / 1000.0);
      }
      content += "<fixed name=\"" + names.back() + "\">" + joints + "</fixed>";
    }
    text = "<mujoco model=\"hand\"><worldbody>" + finger("a") + finger("b") + "</worldbody>\n<tendon>" +
           content + "</tendon>\n" + actuators(names) + sections + "</mujoco>\n";
  }
};

/// Motors of both fingers' joints, which branch: the length of a tendon is its motor's value and nothing
/// else. By the same numbers a motor's force, which acts on joints by 'coef', is its own and no other's.
TEST(MjcfMotors, JointsThatBranchFollowTheirMotorsExactly) {
  int solved = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const Fingers fingers(seed, 4, "");
    ReadOptions options;
    options.tips = {"all"};
    options.floating = seed % 2 == 0;
    const ReadResult result = read_text(fingers.text, "r.xml", options);
    ASSERT_TRUE(result.robot) << fingers.text;
    if (result.robot->motors.empty()) continue;  // random tendons that depend on one another
    ++solved;
    const auto shares = model::shares(*result.robot);
    const auto motors = model::variables(*result.robot);
    for (const auto& [tendon, factors] : fingers.tendons) {
      std::vector<cln::cl_RA> length(motors.size(), 0);
      for (std::size_t i = 0; i < shares.size(); ++i) {
        const auto factor = factors.find(result.robot->joints[i].variable);
        for (const model::Share& share : shares[i])
          if (factor != factors.end())
            length[share.driven] = length[share.driven] + factor->second * share.ratio;
      }
      for (std::size_t k = 0; k < motors.size(); ++k)
        EXPECT_TRUE(length[k] == (motors[k] == tendon ? 1 : 0))
            << tendon << " by " << motors[k] << fingers.text;
    }
  }
  EXPECT_GT(solved, 40);
}

/// Beside loops motors are joints, and lengths equations of joints: fewer of them than joints, too.
TEST(MjcfMotors, LengthsBesideLoopsAreEquationsOfJoints) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const int count = 1 + static_cast<int>(seed % 3);
    const Fingers fingers(seed, count,
                          "<equality><connect body1=\"a1\" body2=\"b1\" anchor=\"0 1 0\"/></equality>");
    const ReadResult result = read_text(fingers.text, "r.xml");
    ASSERT_TRUE(result.robot) << to_string(result.diagnostics.front()) << fingers.text;
    const auto& joints = result.robot->joints;
    ASSERT_EQ(joints.size(), 4U + static_cast<unsigned>(count));
    ASSERT_EQ(result.loops.gears.size(), static_cast<unsigned>(count));
    for (const auto& [tendon, factors] : fingers.tendons) {
      std::map<std::string, cln::cl_RA> length = factors;
      for (const model::Gear& gear : result.loops.gears) {
        const cln::cl_RA factor = length[joints[gear.joint].variable];
        length.erase(joints[gear.joint].variable);
        for (const auto& [leader, ratio] : gear.leaders)
          length[joints[leader].variable] = length[joints[leader].variable] + factor * ratio;
      }
      for (const auto& [name, factor] : length)
        EXPECT_TRUE(factor == (name == tendon ? 1 : 0)) << tendon << " by " << name << fingers.text;
    }
    std::vector<std::string> actuated;
    for (const std::size_t joint : result.loops.actuated) actuated.push_back(joints[joint].variable);
    std::sort(actuated.begin(), actuated.end());
    const std::vector<std::string> all{"t0", "t1", "t2"};
    EXPECT_EQ(actuated, std::vector(all.begin(), all.begin() + count));
  }
}

/// Tips that leave out a joint which the motors move as well.
TEST(MjcfMotors, LimbsWithSomeOfTheJointsAreTold) {
  const Fingers fingers(3, 4, "");
  ReadOptions options;
  options.tips = {"a1"};
  EXPECT_NE(
      report(fingers.text, options)
          .find("the motors of 'j_a0' act by tendons, but 'j_b0', which they move too, is not among the "
                "joints: it has a value of its own"),
      std::string::npos)
      << report(fingers.text, options);
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
