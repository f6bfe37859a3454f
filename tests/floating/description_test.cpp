// SPDX-License-Identifier: MIT
// Bases that float, as they are described: TOML, URDF and MJCF; what cannot be meant is reported with its
// place.
#include <gtest/gtest.h>

#include "description/reader.h"
#include "description/write.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

const std::string toml = R"(name = "r"
title = "r"
[floating_base]
mass = 3
centre_of_mass = [0.1, 0, 0]
inertia = [1, 1.5, 1.2, 0.1, 0, 0]
[[joint]]
type = "revolute"
axis = "+z"
variable = "a"
mass = 1
[[joint]]
type = "prismatic"
axis = "+x"
variable = "b"
parent = "base"
mass = 2
[[tip]]
name = "one"
joint = "a"
[[tip]]
name = "two"
joint = "b"
)";

std::string messages(const ReadResult& result) {
  std::string text;
  for (const Diagnostic& diagnostic : result.diagnostics) text += to_string(diagnostic) + "\n";
  return text;
}

ReadResult floating(const std::string& text, const std::string& base = {}) {
  ReadOptions options;
  options.floating = true;
  options.base = base;
  return read_text(text, "r.xml", options);
}

double number(const model::Expression& e) { return model::to_double(model::evaluate(e)); }

TEST(FloatingBase, IsATableOfTomlAndWrittenBack) {
  const ReadResult result = read_text(toml, "r.toml");
  ASSERT_TRUE(result.robot) << messages(result);
  ASSERT_TRUE(result.robot->floating_base);
  EXPECT_EQ(number(result.robot->floating_base->mass), 3);
  const std::string written = write_text(model::Mechanism{*result.robot, result.tips});
  const ReadResult again = read_text(written, "r.toml");
  ASSERT_TRUE(again.robot) << messages(again);
  EXPECT_EQ(write_text(model::Mechanism{*again.robot, again.tips}), written);
}

TEST(FloatingBase, OfSymbolsIsInertiaOfTheRobot) {
  std::string text = toml;
  text.replace(text.find("mass = 3"), 8, "mass = \"free\"");
  const ReadResult result = read_text(text, "r.toml");
  ASSERT_TRUE(result.robot) << messages(result);
  ASSERT_EQ(result.robot->inertia_parameters.size(), 1U);
  EXPECT_EQ(result.robot->inertia_parameters.front().name, "m0");
}

TEST(FloatingBase, IsNoPartOfItsLimbs) {
  const ReadResult result = read_text(toml, "r.toml");
  ASSERT_TRUE(result.robot);
  EXPECT_FALSE(model::limb(*result.robot, result.tips.front()).floating_base);
}

TEST(FloatingBase, MistakesAreReportedWithTheirPlace) {
  const auto refused = [](std::string text, const std::string& what, const std::string& with,
                          const std::string& message) {
    text.replace(text.find(what), what.size(), with);
    const ReadResult result = read_text(text, "r.toml");
    EXPECT_FALSE(result.robot);
    EXPECT_NE(messages(result).find(message), std::string::npos) << messages(result);
  };
  refused(toml, "[floating_base]", "[base]\ntranslation = [1, 0, 0]\n[floating_base]",
          "r.toml:3:2: error: [base] beside [floating_base]");
  refused(toml, "mass = 3", "mess = 3", "r.toml:4:1: error");
  refused(toml, "mass = 3", "mass = \"90 deg\"", "r.toml:4:");
  ReadOptions options;
  options.floating = true;
  const ReadResult result = read_text(toml, "r.toml", options);
  EXPECT_FALSE(result.robot);
  EXPECT_NE(messages(result).find("--floating"), std::string::npos) << messages(result);
}

TEST(FloatingBase, WarnsOfInertiaThatNoBodyHas) {
  std::string text = toml;
  text.replace(text.find("[1, 1.5, 1.2, 0.1, 0, 0]"), 24, "[1, 5, 1]");
  const ReadResult result = read_text(text, "r.toml");
  EXPECT_NE(messages(result).find("r.toml:3:1: warning: the inertia of the floating base"), std::string::npos)
      << messages(result);
}

const std::string inertial =
    "<inertial><mass value=\"2\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial>";

std::string link(const std::string& name) { return "<link name=\"" + name + "\">" + inertial + "</link>"; }
std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child) {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child +
         "\"/><origin xyz=\"0 0 1\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" "
         "velocity=\"1\"/></joint>";
}

TEST(FloatingBase, IsTheRootOfAUrdfWithAllThatIsFixedToIt) {
  const std::string text = "<robot name=\"r\">" + link("torso") + link("head") + link("arm") + link("leg") +
                           joint("neck", "fixed", "torso", "head") + joint("a", "revolute", "torso", "arm") +
                           joint("b", "revolute", "head", "leg") + "</robot>";
  const ReadResult result = floating(text);
  ASSERT_TRUE(result.robot) << messages(result);
  ASSERT_TRUE(result.robot->floating_base);
  EXPECT_EQ(number(result.robot->floating_base->mass), 4);
  EXPECT_EQ(number(result.robot->floating_base->centre_of_mass[2]), 0.5);
  EXPECT_EQ(result.robot->joints.size(), 2U);
  EXPECT_EQ(result.tips.size(), 2U);
  ReadOptions held;
  held.floating = true;
  held.fixed = {"a"};
  const ReadResult heavier = read_text(text, "r.xml", held);
  ASSERT_TRUE(heavier.robot) << messages(heavier);
  EXPECT_EQ(number(heavier.robot->floating_base->mass), 6);
}

TEST(FloatingBase, IsTheLinkBehindAFloatingJoint) {
  const std::string text = "<robot name=\"r\"><link name=\"world\"/>" + link("torso") + link("arm") +
                           joint("free", "floating", "world", "torso") +
                           joint("a", "revolute", "torso", "arm") + "</robot>";
  const ReadResult result = floating(text);
  ASSERT_TRUE(result.robot) << messages(result);
  EXPECT_EQ(number(result.robot->floating_base->mass), 2);
  EXPECT_EQ(result.robot->joints.size(), 1U);
}

std::string mjcf(const std::string& bodies) {
  return "<mujoco model=\"r\"><worldbody>" + bodies + "</worldbody></mujoco>";
}
std::string body(const std::string& name) {
  return "<body name=\"" + name +
         "\" pos=\"0 0 1\"><freejoint/><inertial pos=\"0 0 0.1\" mass=\"3\" diaginertia=\"1 1 1\"/><body "
         "name=\"" +
         name + "_arm\"><joint name=\"" + name +
         "_j\" axis=\"0 1 0\"/><inertial pos=\"0 0 0.1\" mass=\"1\" diaginertia=\"1 1 1\"/></body></body>";
}

TEST(FloatingBase, IsTheBodyWithAFreeJointOfAnMjcf) {
  const ReadResult result = floating(mjcf(body("torso")));
  ASSERT_TRUE(result.robot) << messages(result);
  EXPECT_EQ(number(result.robot->floating_base->mass), 3);
  EXPECT_EQ(number(result.robot->floating_base->centre_of_mass[2]), 0.1);
  EXPECT_EQ(messages(result).find("free"), std::string::npos) << messages(result);
}

TEST(FloatingBase, IsChosenAmongSeveralFreeBodies) {
  const std::string text = mjcf(body("one") + body("two"));
  const ReadResult result = floating(text);
  EXPECT_FALSE(result.robot);
  EXPECT_NE(messages(result).find("--base one"), std::string::npos) << messages(result);
  const ReadResult chosen = floating(text, "two");
  ASSERT_TRUE(chosen.robot) << messages(chosen);
  EXPECT_EQ(chosen.robot->joints.front().variable, "two_j");
}

/// A crank and a rocker on a torso, and what <equality> ties.
std::string with_loops(const std::string& more, const std::string& equality) {
  const auto turning = [](const std::string& name, const std::string& at) {
    return "<body name='" + name + "' pos='" + at + "'><joint name='" + name +
           "' axis='0 1 0'/><inertial pos='0 0 0.1' mass='1' diaginertia='1 1 1'/></body>";
  };
  return "<mujoco model='r'><worldbody><body name='torso'><freejoint/><inertial pos='0 0 0' mass='5' "
         "diaginertia='1 1 1'/>" +
         turning("crank", "0 0 0") + turning("rocker", "0.3 0 0") + more + "</body></worldbody><equality>" +
         equality + "</equality><actuator><motor joint='crank'/></actuator></mujoco>";
}

/// A rod whose end is on the base gives it half of its mass.
TEST(FloatingBase, HasLoopsAndTheMassOfRodsOnIt) {
  const ReadResult result = floating(
      with_loops("<body name='rod' pos='0 0.1 0.1'><joint name='ball' type='ball'/><inertial pos='0.1 0 0' "
                 "mass='0.5' diaginertia='1e-3 1e-3 1e-3'/></body>",
                 "<connect body1='rod' body2='rocker' anchor='0.2 0 0'/>"));
  ASSERT_TRUE(result.robot) << messages(result);
  ASSERT_EQ(result.loops.closures.size(), 1U) << messages(result);
  EXPECT_EQ(result.loops.closures[0].type, model::LoopType::rod);
  EXPECT_EQ(number(result.robot->floating_base->mass), 5.25);
  EXPECT_NEAR(number(result.robot->floating_base->centre_of_mass[1]), 0.25 * 0.1 / 5.25, 1e-12);
  const ReadResult again =
      read_text(write_text(model::Mechanism{*result.robot, result.tips, result.loops}), "r.toml");
  ASSERT_TRUE(again.robot) << messages(again);
  EXPECT_EQ(again.loops.closures.size(), 1U);
  EXPECT_EQ(number(again.robot->floating_base->mass), 5.25);
}

TEST(FloatingBase, IsTiedToNothing) {
  const ReadResult result = floating(with_loops("", "<connect body1='rocker' anchor='0.3 0 0'/>"));
  EXPECT_FALSE(result.robot);
  EXPECT_NE(messages(result).find("the base floats, and a loop ties it to 'world'"), std::string::npos)
      << messages(result);
}

TEST(FloatingBase, WithoutJointsIsNoRobot) {
  const ReadResult result = floating("<robot name=\"r\">" + link("stone") + "</robot>");
  EXPECT_FALSE(result.robot);
  EXPECT_NE(messages(result).find("nothing moves"), std::string::npos) << messages(result);
}

const std::string before_joints =
    R"(<robot name="r"><link name="torso"/><link name="leg"><inertial><mass value="2"/>
<origin xyz="0 0 0.1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>)";
const std::string origin = R"(<origin xyz="0.1 0.2 0.3" rpy="0 0.5 0"/>)";

/// One of three joints: a slide, or a turn.
std::string one_joint(const std::string& name, const std::string& type, const std::string& ends,
                      const std::string& axis) {
  return "<joint name=\"" + name + "\" type=\"" + type + "\">" + ends + "<axis xyz=\"" + axis +
         "\"/></joint>";
}

TEST(PlanarJoint, IsTwoSlidesAndATurnAboutItsNormal) {
  const std::string planar =
      before_joints + "<joint name=\"p\" type=\"planar\">" + origin +
      "<parent link=\"torso\"/><child link=\"leg\"/><axis xyz=\"0 0 -1\"/></joint></robot>";
  const std::string three =
      before_joints + "<link name=\"i\"/><link name=\"j\"/>" +
      one_joint("p_x", "prismatic", origin + "<parent link=\"torso\"/><child link=\"i\"/>", "1 0 0") +
      one_joint("p_y", "prismatic", "<parent link=\"i\"/><child link=\"j\"/>", "0 1 0") +
      one_joint("p_z", "continuous", "<parent link=\"j\"/><child link=\"leg\"/>", "0 0 -1") + "</robot>";
  const ReadResult found = read_text(planar, "r.urdf"), expected = read_text(three, "r.urdf");
  ASSERT_TRUE(found.robot) << messages(found);
  ASSERT_TRUE(expected.robot) << messages(expected);
  const auto text = [](const ReadResult& r) { return write_text(model::Mechanism{*r.robot, r.tips}); };
  EXPECT_EQ(text(found), text(expected));
  EXPECT_NE(messages(found).find("'p' is read as two slides, p_x and p_y, and a turn, p_z"),
            std::string::npos)
      << messages(found);
  EXPECT_EQ(messages(found).find("no <limit>"), std::string::npos) << messages(found);
}

TEST(PlanarJoint, WithAnObliqueNormalIsReportedWithItsPlace) {
  const ReadResult found = read_text(before_joints +
                                         "<joint name=\"p\" type=\"planar\"><parent link=\"torso\"/><child "
                                         "link=\"leg\"/><axis xyz=\"0 1 1\"/></joint></robot>",
                                     "r.urdf");
  EXPECT_FALSE(found.robot);
  EXPECT_NE(messages(found).find("r.urdf:2:"), std::string::npos) << messages(found);
  EXPECT_NE(messages(found).find("is no coordinate axis"), std::string::npos) << messages(found);
}

/// Two joints, one after the other.
std::string arm_of_two(const std::string& second_type) {
  const std::string limit = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
  return before_joints +
         "<link name=\"foot\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" "
         "ixz=\"0\" iyz=\"0\"/></inertial></link>" +
         one_joint("hip", "revolute", origin + limit + "<parent link=\"torso\"/><child link=\"leg\"/>",
                   "0 1 0") +
         one_joint("knee", second_type, origin + limit + "<parent link=\"leg\"/><child link=\"foot\"/>",
                   "0 0 1") +
         "</robot>";
}

std::string written(const std::string& text, const ReadOptions& options) {
  const ReadResult read = read_text(text, "r.urdf", options);
  EXPECT_TRUE(read.robot) << messages(read);
  return read.robot ? write_text(model::Mechanism{*read.robot, read.tips}) : "";
}

TEST(HeldJoints, GiveTheRobotThatHasThemFixed) {
  for (const bool floats : {false, true}) {
    ReadOptions fixed, held;
    fixed.floating = held.floating = floats;
    held.fixed = {"knee"};
    EXPECT_EQ(written(arm_of_two("revolute"), held), written(arm_of_two("fixed"), fixed));
  }
}

/// So it has its counts and its code.
TEST(TreeWithOneTip, IsTheChainToIt) {
  ReadOptions chain, tree;
  chain.tip = "foot";
  tree.tips = {"foot"};
  EXPECT_EQ(written(arm_of_two("revolute"), tree), written(arm_of_two("revolute"), chain));
}

}  // namespace
}  // namespace qvgen::description
