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
      "3:28: error: the range of 'b behind a joint' is empty: the lower end is not below the upper; write "
      "range=\"lower upper\"\n"
      "3:34: error: the joint 'b' is of type free; a chain has hinges and slides: choose --base behind it\n");
  EXPECT_EQ(report_body("quat=\"1 0 0 0\" euler=\"0 0 0\"", "<joint/><joint class=\"fst\"/>",
                        "<default><default class=\"fast\"/></default>"),
            "3:23: error: there is no default class 'fst'; did you mean 'fast'?\n");
  EXPECT_EQ(report_body("quat=\"1 0 0 0\" euler=\"0 0 0\"", "<joint/>"),
            "2:49: error: both 'quat' and 'euler' are given; keep one of them\n");
  EXPECT_EQ(
      report_body("", "<joint/><frame/>",
                  "<compiler coordinate=\"global\" eulerseq=\"xyw\"/><include file=\"a\"/>"),
      "2:23: error: coordinate=\"global\" is not read; have MuJoCo save the model, or write "
      "coordinate=\"local\"\n"
      "2:41: error: 'xyw' is no sequence of Euler angles; write three letters, e.g. xyz\n"
      "2:47: error: <include> is not followed; put the other file's content here\n"
      "3:9: error: <frame> is not read; have MuJoCo save the model: mj_saveLastXML writes plain bodies\n");
  EXPECT_EQ(report_body("", "<joint stiffness=\"1\"/><geom/>", "<equality><joint/></equality>"),
            "2:1: warning: <equality> is not read: joints move freely; remove it if that is right\n"
            "3:19: warning: the spring of a joint is not read; add its force to what the dynamics gives\n"
            "3:23: warning: inertia that follows from geoms is not read; add <inertial>, or have MuJoCo save "
            "the model: "
            "mj_saveLastXML writes it\n");
}

}  // namespace
}  // namespace qvgen::description
