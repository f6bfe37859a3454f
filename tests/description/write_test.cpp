// SPDX-License-Identifier: MIT
#include "description/write.h"

#include "xml.h"

namespace qvgen::description {
namespace {

constexpr const char* urdf = R"(<robot name="a &quot;b&quot;">
<link name="base"/>
<link name="l1"><inertial><origin xyz="0.1 0 0" rpy="0 0 0.3"/><mass value="2"/>
  <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.25"/></inertial></link>
<link name="l2"><inertial><mass value="1e-3"/></inertial></link>
<link name="tool0"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0 0.25 -3" rpy="0 1.5708 0.1"/>
  <axis xyz="0 1 -1"/><limit lower="-3.5" upper="7"/><dynamics damping="0.5"/></joint>
<joint name="j2" type="prismatic"><parent link="l1"/><child link="l2"/><axis xyz="0 0 -1"/><limit upper="0.5"/></joint>
<joint name="f" type="fixed"><parent link="l2"/><child link="tool0"/><origin xyz="1 0 0" rpy="0 0 0.262"/></joint>
</robot>)";

TEST(Write, ReadsBackAsTheSame) {
  const model::Robot robot = read(urdf);
  const std::string text = write_text(robot);
  const ReadResult again = read_text(text, "a.toml");
  for (const auto& diagnostic : again.diagnostics) ADD_FAILURE() << to_string(diagnostic) << "\n" << text;
  ASSERT_TRUE(again.robot) << text;
  EXPECT_EQ(write_text(*again.robot), text);
  ASSERT_EQ(again.robot->joints.size(), 2U);
  EXPECT_EQ(again.robot->title, robot.title);
  EXPECT_EQ(again.robot->source, robot.source);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(texts(again.robot->joints[i].before), texts(robot.joints[i].before));
    EXPECT_EQ(texts(again.robot->joints[i].axis), texts(robot.joints[i].axis));
    EXPECT_EQ(texts(again.robot->joints[i].inertia.centre_of_mass),
              texts(robot.joints[i].inertia.centre_of_mass));
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_TRUE(model::same(again.robot->joints[i].inertia.inertia[k], robot.joints[i].inertia.inertia[k]));
    EXPECT_EQ(to_string(again.robot->joints[i].limits->upper), to_string(robot.joints[i].limits->upper));
  }
  EXPECT_EQ(texts(again.robot->tool), texts(robot.tool));
}

TEST(Write, DefaultsAndRequestsComeBack) {
  const std::string joint =
      "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nlink = [\"l\", 0, 0]\nmass = \"free\"\n";
  std::string text =
      "name = \"a\"\ntitle = \"a\"\nideal = \"b\"\ntask = \"pose\"\non_request = \"regressor\"\n"
      "defaults = { l = 0.25 }\nsymbols = [\"m1\", \"m2\", \"m3\", \"m4\", \"m5\", \"m6\"]\n";
  for (int i = 1; i <= 6; ++i) text += joint + "variable = \"t" + std::to_string(i) + "\"\n";
  const ReadResult first = read_text(text, "a.toml");
  for (const auto& diagnostic : first.diagnostics)
    if (diagnostic.severity == Diagnostic::error) ADD_FAILURE() << to_string(diagnostic);
  ASSERT_TRUE(first.robot);
  const std::string written = write_text(*first.robot);
  const ReadResult again = read_text(written, "b.toml");
  ASSERT_TRUE(again.robot) << written;
  EXPECT_EQ(again.robot->ideal, "b");
  EXPECT_EQ(again.robot->inverse.task, model::Task::pose);
  EXPECT_EQ(again.robot->on_request, first.robot->on_request);
  ASSERT_EQ(again.robot->geometry.size(), 1U);
  EXPECT_EQ(to_string(*again.robot->geometry.front().default_value), "1/4");
  EXPECT_EQ(again.robot->inertia_parameters.size(), 6U);
  EXPECT_EQ(write_text(*again.robot), written);
}

TEST(Write, LooksLikeTheCommittedOnes) {
  EXPECT_EQ(
      write_text(
          read("<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" "
               "type=\"continuous\"><parent "
               "link=\"a\"/><child link=\"b\"/><origin xyz=\"0 0 0.5\" rpy=\"1.5708 0 0\"/><axis xyz=\"0 0 "
               "-1\"/></joint></robot>")),
      R"(# Lengths in metres, angles in radians unless they say deg, masses in kilograms; every number is exact.
name = "r"
title = "r, a to b"
source = "r.xml"

[[joint]]
type = "revolute"
axis = "-z"
variable = "j"
origin = [0, 0, 0.5]
turns = [{ axis = "+x", angle = "90 deg" }]
)");
}

TEST(Write, TemplatesAreRight) {
  for (const std::string letters : {"R", "RRP", "PPP", "RRRRRRR"})
    for (const bool wrist : {false, true}) {
      const auto text = write_template("my_arm", letters, wrist);
      ASSERT_TRUE(text);
      const ReadResult result = read_text(*text, "a.toml", {.strict = true});
      for (const auto& diagnostic : result.diagnostics)
        ADD_FAILURE() << to_string(diagnostic) << "\n" << *text;
      ASSERT_TRUE(result.robot);
      EXPECT_EQ(result.robot->joints.size(), letters.size() + (wrist ? 3 : 0));
      EXPECT_EQ(result.robot->joints[0].type,
                letters[0] == 'R' ? model::JointType::revolute : model::JointType::prismatic);
    }
  EXPECT_FALSE(write_template("my_arm", "RXP", false));
  EXPECT_FALSE(write_template("my_arm", "", true));
  EXPECT_FALSE(write_template("my_arm", std::string(14, 'R'), true));
}

}  // namespace
}  // namespace qvgen::description
