// SPDX-License-Identifier: MIT
// The written description has the numbers, and all else as it was.
#include "identify/written.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/evaluate.h"
#include "random_arm.h"
#include "simulated.h"

namespace qvgen::test {
namespace {

using Eigen::VectorXd;
using testing::HasSubstr;
using testing::Not;

/// Parameters of some arm with so many links.
VectorXd some_values(const std::string& joints) {
  return parameters_of(reference::load_text(ArmWriter(7).text(joints)));
}

void expect_values(const std::string& text, const VectorXd& values) {
  EXPECT_LT((parameters_of(reference::load_text(text)) - values).norm(), 1e-12 * values.norm()) << text;
  read_arm(text);
}

TEST(Written, TakesThePlaceOfWhatWasThere) {
  const std::string before = ArmWriter(8).text("RPR");
  const VectorXd values = some_values("RPR");
  const std::string after = identify::written(before, read_arm(before), values, "from a log");
  expect_values(after, values);
  EXPECT_EQ(after.rfind("# from a log\n# an arm of a test\n", 0), 0U);
  EXPECT_THAT(after, HasSubstr("[[joint]]  # number 2"));
}

TEST(Written, OfATableInMillimetresWithFreeInertias) {
  const std::string before = R"(name = "arm"
title = "arm"
unit = "mm"
inertia = "free"   # unknown
drives = "free"
convention = "standard"

[defaults]
m1 = 3
length = 0.3

[[dh]]
variable = "q1"
theta = "q1"
d = "1000*length"   # stays
alpha = "90 deg"

[[dh]]
a = 20

[[dh]]
variable = "q2"
theta = "q2"
a = 250
inertia = [
  1, 2,  # by hand
  3]
# the end
)";
  const VectorXd values = some_values("RR");
  const std::string after = identify::written(before, read_arm(before), values, "");
  // The tests' own reader has metres alone; centres are the only lengths that are written.
  const model::Robot robot = read_arm(after);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const model::Inertia& inertia = robot.joints[static_cast<std::size_t>(i)].inertia;
    EXPECT_NEAR(model::to_double(model::evaluate(inertia.mass)), values[10 * i], 1e-12);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(model::to_double(model::evaluate(inertia.centre_of_mass[k])),
                  values[10 * i + 1 + static_cast<Eigen::Index>(k)] / values[10 * i], 1e-12);
  }
  EXPECT_THAT(after, HasSubstr("d = \"1000*length\"   # stays"));
  EXPECT_THAT(after, HasSubstr("# the end"));
  EXPECT_THAT(after, Not(HasSubstr("free")));
  EXPECT_THAT(after, Not(HasSubstr("by hand")));
  EXPECT_THAT(after, Not(HasSubstr("m1")));
}

TEST(Written, OffsetsStandInComments) {
  const std::string before = ArmWriter(8).text("R");
  VectorXd values = some_values("R");
  values[13] = 0.25;
  EXPECT_THAT(identify::written(before, read_arm(before), values, ""),
              HasSubstr("# constant force of the drive, which no description takes: 0.25\n"));
}

TEST(Written, ModelsTakeTheSameNumbers) {
  const std::string before = ArmWriter(8).text("RR");
  const VectorXd values = some_values("RR");
  const model::Robot robot = identify::with_values(read_arm(before), values);
  EXPECT_NEAR(robot.joints[1].inertia.mass.number() == 0 ? 0 : 1, 1, 0);
  EXPECT_TRUE(robot.inertia_parameters.empty());
}

TEST(Written, JointsInOneLineAreRefused) {
  const std::string before =
      "name = \"arm\"\ntitle = \"arm\"\njoint = [{type = \"revolute\", axis = \"+z\", variable = \"q1\"}]\n";
  EXPECT_THROW(identify::written(before, read_arm(before), some_values("R"), ""), std::runtime_error);
}

const char* const urdf = R"(<robot name="arm"><!-- by hand -->
  <link name="base"><inertial><mass value="9"/></inertial></link>
  <link name="one"/>
  <link name="two">
    <visual><geometry><mesh filename="two.stl"/></geometry></visual>
    <inertial>
      <mass value="3"/><origin xyz="0 0 0.1" rpy="0.1 0 0"/>
      <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <link name="tool">
    <inertial><mass value="0.5"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <link name="finger"><inertial><mass value="0.1"/><inertia ixx="1e-3" iyy="1e-3" izz="1e-3" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="q1" type="continuous"><parent link="base"/><child link="one"/><axis xyz="0 0 1"/></joint>
  <joint name="q2" type="continuous"><parent link="one"/><child link="two"/><origin xyz="0.3 0 0"/><axis xyz="0 1 0"/>
    <dynamics friction="7" damping="8"/></joint>
  <joint name="hold" type="fixed"><parent link="two"/><child link="tool"/><origin xyz="0 0 0.2"/></joint>
  <joint name="grip" type="prismatic"><parent link="tool"/><child link="finger"/><axis xyz="0 1 0"/><limit lower="0" upper="0.1" effort="1" velocity="1"/></joint>
</robot>
)";

/// Standard parameters of all links, then the drives', as the description has them.
VectorXd described(const model::Robot& robot) {
  const auto number = [](const model::Expression& e) { return model::to_double(model::evaluate(e, {})); };
  reference::Chain chain;
  for (const model::Joint& joint : robot.joints) {
    reference::Joint link;
    link.mass = number(joint.inertia.mass);
    const auto& [xx, yy, zz, xy, yz, xz] = joint.inertia.inertia;
    for (std::size_t k = 0; k < 3; ++k)
      link.centre_of_mass[static_cast<Eigen::Index>(k)] = number(joint.inertia.centre_of_mass[k]);
    link.inertia << number(xx), number(xy), number(xz), number(xy), number(yy), number(yz), number(xz),
        number(yz), number(zz);
    link.viscous_friction = number(joint.drive.viscous_friction);
    link.coulomb_friction = number(joint.drive.coulomb_friction);
    chain.joints.push_back(link);
  }
  return parameters_of(chain);
}

TEST(WrittenUrdf, HasTheNumbersAndAllElse) {
  VectorXd values = some_values("RR");
  const description::ReadOptions options{.tip = "tool"};
  const std::string after = identify::written_urdf(urdf, options, values, "from a log");
  const auto read = description::read_text(after, "arm.urdf", options);
  ASSERT_TRUE(read.robot) << to_string(read.diagnostics.front()) << after;
  const VectorXd rotors =
      VectorXd::Unit(values.size(), 20) * values[20] + VectorXd::Unit(values.size(), 24) * values[24];
  EXPECT_LT((described(*read.robot) + rotors - values).norm(), 1e-9 * values.norm()) << after;
  for (const char* kept : {"<!-- by hand -->", "two.stl", "<mass value=\"9\"/>", "<mass value=\"0.1\"/>",
                           "<!-- from a log -->", "<link name=\"one\">", "q2: rotor inertia"})
    EXPECT_THAT(after, HasSubstr(kept));
  for (const char* gone : {"<mass value=\"3\"/>", "<mass value=\"0.5\"/>", "friction=\"7\""})
    EXPECT_THAT(after, Not(HasSubstr(gone)));
  EXPECT_THROW(identify::written_urdf("name = \"arm\"", options, values, ""), std::runtime_error);
}

}  // namespace
}  // namespace qvgen::test
