// SPDX-License-Identifier: MIT
#include "xml.h"

namespace qvgen::description {
namespace {

std::string model(const std::string& content) { return "<mujoco model=\"arm\">\n" + content + "</mujoco>\n"; }

/// One body with the given attributes and content.
model::Robot single(const std::string& attributes, const std::string& content = "<joint/>",
                    const std::string& compiler = "", const ReadOptions& options = {}) {
  return read(model("<compiler " + compiler + "/><worldbody><body name=\"b\" " + attributes + ">" + content +
                    "</body></worldbody>"),
              options);
}

std::string before(const std::string& attributes, const std::string& compiler = "") {
  const model::Robot robot = single(attributes, "<joint/>", compiler);
  return robot.joints.empty() ? "" : texts(robot.joints[0].before);
}

TEST(Mjcf, ReadsNestedBodies) {
  const model::Robot arm = read(model(R"(
<compiler angle="radian"/>
<default><joint damping="2"/><default class="slow"><joint damping="3" axis="0 1 0"/></default></default>
<worldbody>
  <body name="base" pos="0 0 1">
    <body name="upper" pos="0.5 0 0" childclass="slow">
      <inertial pos="0 0 0.5" mass="2" diaginertia="0.1 0.2 0.25"/>
      <joint name="j1" range="-1 2" armature="0.125"/>
      <body name="lower" pos="0 0 0.25">
        <joint name="j2" class="main" type="slide" axis="3 0 4" pos="1 0 0" frictionloss="0.5"/>
        <inertial pos="0 0 0" mass="1" fullinertia="1 1 1 0.125 0 0.25"/>
        <site name="attachment_site" pos="0 0 0.1" quat="1 0 0 1"/>
      </body>
    </body>
  </body>
</worldbody>
)"));
  EXPECT_EQ(arm.name, "arm");
  EXPECT_EQ(arm.source, "r.xml");
  EXPECT_EQ(arm.title, "arm, world to attachment_site");
  ASSERT_EQ(arm.joints.size(), 2U);
  EXPECT_EQ(arm.joints[0].variable, "j1");
  EXPECT_EQ(texts(arm.joints[0].before), "1/2, 0, 1");
  EXPECT_EQ(texts(arm.joints[0].axis), "0, 1, 0");
  EXPECT_EQ(to_string(arm.joints[0].drive.viscous_friction), "3");
  EXPECT_EQ(to_string(arm.joints[0].drive.rotor_inertia), "1/8");
  EXPECT_EQ(to_string(arm.joints[0].limits->upper), "2");
  EXPECT_EQ(to_string(arm.joints[0].inertia.inertia[2]), "1/4");
  EXPECT_EQ(arm.joints[1].type, model::JointType::prismatic);
  EXPECT_EQ(texts(arm.joints[1].axis), "3/5, 0, 4/5");
  EXPECT_EQ(texts(arm.joints[1].before), "1, 0, 1/4");
  EXPECT_EQ(texts(arm.joints[1].after), "-1, 0, 0");
  EXPECT_EQ(to_string(arm.joints[1].drive.viscous_friction), "2");
  EXPECT_EQ(to_string(arm.joints[1].drive.coulomb_friction), "1/2");
  EXPECT_EQ(to_string(arm.joints[1].inertia.inertia[3]), "1/8");
  EXPECT_EQ(to_string(arm.joints[1].inertia.inertia[4]), "1/4");
  EXPECT_EQ(texts(arm.tool), "0, 0, 1 by 1/2*pi; 0, 0, 1/10");
}

TEST(Mjcf, Orientations) {
  EXPECT_EQ(before("euler=\"90 0 -45\""), "1, 0, 0 by 1/2*pi; 0, 0, 1 by (-1/4)*pi; 0, 0, 0");
  EXPECT_EQ(before("euler=\"90 0 -45\"", "eulerseq=\"XYZ\""),
            "0, 0, 1 by (-1/4)*pi; 1, 0, 0 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(before("euler=\"1.5708 0 0.1\"", "angle=\"radian\" eulerseq=\"zyx\""),
            "0, 0, 1 by 1/2*pi; 1, 0, 0 by 1/10; 0, 0, 0");
  EXPECT_EQ(before("quat=\"1 0 1 0\""), "0, 1, 0 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(before("quat=\"0 0 1 1\""), "0, 0, 1 by pi; 1, 0, 0 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(before("quat=\"0.5 0.5 -0.5 0.5\""), "0, 1, 0 by (-1/2)*pi; 1, 0, 0 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(before("quat=\"0.707106 0.707107 0 0\""), "1, 0, 0 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(before("quat=\"0.9239 0 0 0.3827\""), "0, 0, 1 by 1/4*pi; 0, 0, 0");
  EXPECT_EQ(before("axisangle=\"1 1 1 120\""), "1/sqrt(3), 1/sqrt(3), 1/sqrt(3) by 2/3*pi; 0, 0, 0");
  EXPECT_EQ(before("xyaxes=\"0 1 0 -2 0 0\""), "0, 0, 1 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(before("xyaxes=\"0 1 0 -2 1 0\""), "0, 0, 1 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(before("zaxis=\"0 -1 0\""), "1, 0, 0 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(before("zaxis=\"0 0 -1\""), "1, 0, 0 by pi; 0, 0, 0");
}

TEST(Mjcf, EveryChangeIsNoted) {
  EXPECT_EQ(
      report(model("<worldbody><body quat=\"0.7071 0.7071 0 0\">\n<joint axis=\"0 0.6 0.8\"/>"
                   "<site name=\"tool\" quat=\"0.92388 0 0.38268 0\"/></body></worldbody>")),
      "3:50: note: quat=\"0.92388 0 0.38268 0\" is read as 45 deg about y, entries change by up to 4.7e-06; "
      "--snap off keeps it\n");
}

TEST(Mjcf, JointsThatStandElsewhere) {
  const model::Robot arm = single(
      "pos=\"0 0 1\"", "<joint type=\"slide\" ref=\"0.5\"/><joint pos=\"1 0 0\" axis=\"0 1 0\" ref=\"30\"/>");
  ASSERT_EQ(arm.joints.size(), 2U);
  EXPECT_EQ(texts(arm.joints[0].before), "0, 0, 1/2");
  EXPECT_EQ(texts(arm.joints[1].before), "0, 1, 0 by -1/6*pi; 1, 0, 0");
  EXPECT_EQ(texts(arm.joints[1].after), "-1, 0, 0");
  EXPECT_EQ(arm.title, "arm, world to b");
}

std::string report_body(const std::string& attributes, const std::string& content,
                        const std::string& head = "") {
  return report(
      model(head + "<worldbody><body name=\"b\" " + attributes + ">\n" + content + "</body></worldbody>"));
}

TEST(Mjcf, Mistakes) {
  EXPECT_EQ(report(model("")),
            "1:1: error: no joint between world and the tips moves; an arm has at least one revolute, "
            "continuous or "
            "prismatic joint\n");
  EXPECT_EQ(
      report_body("quat=\"0 0 0 0\"", "<joint axis=\"0 0 0\" range=\"2 1\"/><freejoint/>"),
      "2:33: error: 'quat' has length zero; give a direction\n"
      "3:14: error: 'axis' has length zero; give a direction\n"
      "3:28: error: the range of 'b' is empty: the lower end is not below the upper; write "
      "range=\"lower upper\"\n"
      "3:34: warning: a joint is free: the body is held where the file has it; with --base 'b' the chain "
      "begins at this body; with --floating it moves freely\n");
  EXPECT_EQ(report_body("quat=\"1 0 0 0\" euler=\"0 0 0\"", "<joint/><joint class=\"fst\"/>",
                        "<default><default class=\"fast\"/></default>"),
            "3:23: error: there is no default class 'fst'; did you mean 'fast'?\n");
  EXPECT_EQ(report_body("quat=\"1 0 0 0\" euler=\"0 0 0\"", "<joint/>"),
            "2:49: error: both 'quat' and 'euler' are given; keep one of them\n");
  EXPECT_EQ(report_body("", "<joint/>",
                        "<compiler coordinate=\"global\" eulerseq=\"xyw\"/><compiler boundmass=\"a\" "
                        "balanceinertia=\"1\" inertiafromgeom=\"never\"/>"),
            "2:23: error: coordinate=\"global\" is not read; load and save the model with MuJoCo 2.3.3 or "
            "older, which "
            "writes local coordinates\n"
            "2:41: error: 'xyw' is no sequence of Euler angles; write three letters, e.g. xyz\n"
            "2:68: error: 'a' is no number; write a decimal number such as 0.1 or 1e-3\n"
            "2:87: error: balanceinertia=\"1\" is neither true nor false; write true or false\n"
            "2:107: error: unknown inertiafromgeom 'never'; write auto, true or false\n");
  EXPECT_EQ(
      report_body("", "<joint stiffness=\"1\"/><composite/>", "<equality><joint/></equality>"),
      "2:11: warning: <joint> of <equality> is not read: joints move freely; remove it if that is right\n"
      "3:19: warning: the spring of a joint is not read; add its force to what the dynamics gives\n"
      "3:23: warning: <composite> is not read: what it makes is left out; have MuJoCo save the model: "
      "mj_saveLastXML writes plain bodies\n");
}

TEST(Mjcf, DefaultsOfSeveralFilesAreOne) {
  const model::Robot arm =
      single("", "<joint class=\"fast\"/>",
             "/><default><joint damping=\"2\"/></default>"
             "<default><joint armature=\"3\"/><default class=\"fast\"/></default><compiler");
  EXPECT_EQ(to_string(arm.joints.at(0).drive.viscous_friction), "2");
  EXPECT_EQ(to_string(arm.joints.at(0).drive.rotor_inertia), "3");
}

TEST(Mjcf, AnOrientationReplacesAnInheritedOne) {
  const model::Robot arm =
      read(model("<default><site euler=\"0 90 0\"/></default><worldbody><body><joint/><site name=\"tool\" "
                 "quat=\"1 1 0 0\"/>"
                 "</body></worldbody>"));
  EXPECT_EQ(texts(arm.tool), "1, 0, 0 by 1/2*pi; 0, 0, 0");
}

TEST(Mjcf, ARangeOfZeroIsNone) {
  EXPECT_FALSE(single("", "<joint range=\"0 0\"/>").joints.at(0).limits.has_value());
  EXPECT_NE(report_body("", "<joint range=\"0 0\" limited=\"true\"/>").find("is empty"), std::string::npos);
}

TEST(Mjcf, BallsAreThreeTurns) {
  const std::string text = model(
      "<worldbody><body name=\"torso\"><body name=\"upper\" pos=\"0 0.2 0.4\">\n"
      "<joint name=\"sh\" type=\"ball\" pos=\"0 0 0.1\"/><body name=\"fore\" pos=\"0.3 0 0\">"
      "<joint name=\"el\" axis=\"0 1 0\"/></body></body></body></worldbody>");
  const model::Robot arm = read(text);
  ASSERT_EQ(arm.joints.size(), 4U);
  EXPECT_EQ(arm.joints[0].variable + arm.joints[1].variable + arm.joints[2].variable, "sh_xsh_ysh_z");
  EXPECT_EQ(texts(arm.joints[0].axis), "1, 0, 0");
  EXPECT_EQ(texts(arm.joints[2].axis), "0, 0, 1");
  EXPECT_EQ(texts(arm.joints[0].before), "0, 1/5, 1/2");
  EXPECT_EQ(report(text),
            "3:1: note: the ball joint 'sh' is read as three turns, sh_x, sh_y and sh_z, each about an axis "
            "that the "
            "one before has turned; with the second at 90 or -90 degrees they lack one of its motions\n");
}

TEST(Mjcf, WhatThreeTurnsCannotHaveOfABallIsSaid) {
  const std::string all =
      report_body("", "<joint name=\"sh\" type=\"ball\" range=\"0 40\" damping=\"0.5\" armature=\"0\"/>");
  EXPECT_NE(all.find("3:37: warning: the range of a ball joint is not read"), std::string::npos) << all;
  EXPECT_NE(all.find("3:52: warning: 'damping' of a ball joint is not read"), std::string::npos) << all;
  EXPECT_EQ(all.find("armature"), std::string::npos) << all;
}

TEST(Mjcf, FreeBodiesAreHeldAndNoTips) {
  const std::string text = model(
      "<worldbody><body name=\"cube\"><freejoint/></body>\n<body name=\"torso\" pos=\"0 0 1\">"
      "<joint name=\"root\" type=\"free\"/><body name=\"arm\" pos=\"1 0 "
      "0\"><joint/></body></body></worldbody>");
  EXPECT_EQ(
      report(text),
      "3:32: warning: the joint 'root' is free: the body is held where the file has it; with --base 'torso' "
      "the chain begins at this body; with --floating it moves freely\n");
  ReadOptions options;
  options.base = "torso";
  EXPECT_EQ(texts(read(text, options).joints.at(0).before), "1, 0, 0");
}

}  // namespace
}  // namespace qvgen::description
