// SPDX-License-Identifier: MIT
#include "description/reader.h"

#include <gtest/gtest.h>

#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

model::Robot read(const std::string& text) {
  const ReadResult result = read_text("name = \"a\"\ntitle = \"A\"\n" + text, "a.toml");
  for (const auto& diagnostic : result.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  return result.robot.value_or(model::Robot{});
}

std::string texts(const model::Vector3& v) {
  return to_string(v[0]) + ", " + to_string(v[1]) + ", " + to_string(v[2]);
}

std::string names(const std::vector<model::Parameter>& parameters) {
  std::string text;
  for (const auto& parameter : parameters) text += (text.empty() ? "" : " ") + parameter.name;
  return text;
}

const std::string revolute = "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"t1\"\n";

TEST(Reader, ReadsTheNativeForm) {
  const model::Robot robot = read(R"(
source = "nowhere"
[[joint]]
type = "revolute"
axis = "-y"
variable = "theta1"
origin = ["0", 0, "h1"]
link = ["0", "-d2", 0.5]
limits = ["-170 deg", "170 deg"]
[[joint]]
type = "prismatic"
axis = ["3/5", 0, 0.8]
variable = "d3"
)");
  EXPECT_EQ(robot.source, "nowhere");
  ASSERT_EQ(robot.joints.size(), 2U);
  EXPECT_EQ(robot.joints[0].type, model::JointType::revolute);
  EXPECT_EQ(texts(robot.joints[0].axis), "0, -1, 0");
  EXPECT_EQ(texts(robot.joints[0].before.translation), "0, 0, h1");
  EXPECT_EQ(texts(robot.joints[0].after.translation), "0, -d2, 1/2");
  EXPECT_EQ(to_string(robot.joints[0].limits->upper), "17/18*pi");
  EXPECT_EQ(robot.joints[1].type, model::JointType::prismatic);
  EXPECT_EQ(texts(robot.joints[1].axis), "3/5, 0, 4/5");
  EXPECT_EQ(names(robot.geometry), "h1 d2");
  EXPECT_TRUE(robot.inertia_parameters.empty());
  EXPECT_TRUE(robot.joints[0].inertia.mass.is_literal_zero());
}

TEST(Reader, ReadsFloatsAsTheyAreWritten) {
  const model::Robot robot =
      read(revolute + "origin = [0.1, 1e-3, -1_0.000_1]\nlink = [0.30000000000000004, +2.5, 7]\n");
  EXPECT_EQ(texts(robot.joints[0].before.translation), "1/10, 1/1000, -100001/10000");
  EXPECT_EQ(robot.joints[0].after.translation[0].number(),
            cln::cl_RA("30000000000000004/100000000000000000"));
  EXPECT_EQ(to_string(robot.joints[0].after.translation[1]), "5/2");
}

TEST(Reader, AcceptsIrrationalUnitAxes) {
  const model::Robot robot = read(
      "[[joint]]\ntype = \"revolute\"\nvariable = \"t1\"\naxis = [\"sqrt(3)/2\", \"sin(30 deg)\", 0]\n"
      "[[joint]]\ntype = \"revolute\"\nvariable = \"t2\"\naxis = [\"1/sqrt(3)\", \"-1/sqrt(3)\", "
      "\"sqrt(1/3)\"]\n");
  EXPECT_EQ(to_string(robot.joints[0].axis[0]), "sqrt(3)/2");
}

TEST(Reader, ReadsFrames) {
  const model::Robot robot = read(revolute + R"(
turns = [{ axis = "+x", angle = "90 deg" }, { axis = "-z", angle = "beta" }]
[base]
translation = [0, 0, "z0"]
rpy = [0, "45 deg", "pi"]
[tool]
translation = [0, 0, 0.1]
)");
  ASSERT_EQ(robot.base.turns.size(), 2U);
  EXPECT_EQ(texts(robot.base.turns[0].axis), "0, 0, 1");
  EXPECT_EQ(to_string(robot.base.turns[0].angle), "pi");
  EXPECT_EQ(texts(robot.base.turns[1].axis), "0, 1, 0");
  EXPECT_EQ(texts(robot.joints[0].before.turns.at(1).axis), "0, 0, -1");
  EXPECT_EQ(texts(robot.tool.translation), "0, 0, 1/10");
  EXPECT_EQ(names(robot.geometry), "beta z0");
}

TEST(Reader, SortsSymbolsIntoGeometryAndInertia) {
  const model::Robot robot = read(revolute + R"(
origin = [0, 0, "h1"]
mass = "m1"
centre_of_mass = [0, 0, "-h1/2"]
inertia = ["Ixx", "Iyy", 1, 0, 0, "Ixz"]
viscous_friction = "fv"
[defaults]
h1 = 0.5
m1 = "3/2"
Ixx = 1
Iyy = 1
Ixz = 0.1
fv = 0
)");
  EXPECT_EQ(names(robot.geometry), "h1");
  EXPECT_EQ(names(robot.inertia_parameters), "m1 Ixx Iyy Ixz fv");
  EXPECT_EQ(to_string(*robot.inertia_parameters[0].default_value), "3/2");
  EXPECT_TRUE(robot.joints[0].inertia.inertia[3].is_literal_zero());
  EXPECT_EQ(to_string(robot.joints[0].inertia.inertia[5]), "Ixz");
}

TEST(Reader, NamesFreeParameters) {
  const model::Robot robot = read("inertia = \"free\"\ndrives = \"free\"\n" + revolute + "mass = 2\n");
  EXPECT_EQ(names(robot.inertia_parameters), "c1x c1y c1z I1xx I1yy I1zz I1xy I1yz I1xz Ia1 Fv1 Fc1");
  EXPECT_EQ(to_string(robot.joints[0].inertia.mass), "2");
  EXPECT_EQ(to_string(robot.joints[0].drive.coulomb_friction), "Fc1");
}

TEST(Reader, FreesTheTensorOfOneLink) {
  const model::Robot robot = read(revolute + "inertia = \"free\"\nmass = 1\n");
  EXPECT_EQ(names(robot.inertia_parameters), "I1xx I1yy I1zz I1xy I1yz I1xz");
}

TEST(Reader, KeepsTheSymbolsThatAreDeclaredWithoutDefaults) {
  const model::Robot robot = read("symbols = [\"h1\"]\n" + revolute + "origin = [0, 0, \"h1\"]\n");
  EXPECT_FALSE(robot.geometry.at(0).default_value);
}

TEST(Reader, ReadsScrews) {
  const model::Robot robot = read(R"(
[[screw]]
type = "revolute"
variable = "t1"
axis = "+z"
point = ["a", 0, 0]
[[screw]]
type = "prismatic"
variable = "d2"
axis = "+x"
[home]
translation = ["a + b", 0, 0]
rpy = ["90 deg", 0, 0]
[tool]
translation = [0, "c", 0]
)");
  EXPECT_EQ(texts(robot.joints[0].before.translation), "a, 0, 0");
  EXPECT_TRUE(model::is_literal_zero(robot.joints[1].before.translation));
  EXPECT_EQ(texts(robot.tool.translation), "b, 0, c");
  EXPECT_EQ(robot.tool.turns.size(), 1U);
}

TEST(Reader, LeavesOutInferableTypesOfRows) {
  const model::Robot robot = read(R"(
convention = "standard"
[[dh]]
variable = "t1"
theta = "t1 + 90 deg"
d = "h1"
[[dh]]
variable = "d2"
d = "d2"
)");
  EXPECT_EQ(robot.joints[0].type, model::JointType::revolute);
  EXPECT_EQ(robot.joints[0].before.turns.size(), 1U);
  EXPECT_EQ(robot.joints[1].type, model::JointType::prismatic);
  EXPECT_EQ(names(robot.geometry), "h1");
}

TEST(Reader, ZerosOfATableStayLiteral) {
  const model::Robot robot =
      read("convention = \"modified\"\n[[dh]]\nvariable = \"t1\"\ntheta = \"t1\"\nalpha = \"0 deg\"\n");
  EXPECT_TRUE(robot.joints[0].before.turns.empty());
  EXPECT_TRUE(model::is_literal_zero(robot.joints[0].after.translation));
}

TEST(Reader, AcceptsPointMassesAndRods) {
  read(revolute + "mass = 1\n");
  const ReadResult rod =
      read_text("name = \"a\"\ntitle = \"A\"\n" + revolute + "mass = 1\ninertia = [1, 1, 0.0001]\n", "a");
  EXPECT_TRUE(rod.diagnostics.empty());
}

TEST(Reader, AcceptsUnphysicalInertiaWhenToldTo) {
  read("accept_unphysical_inertia = true\n" + revolute + "mass = -1\ninertia = [1, 1, 3]\n");
}

TEST(Reader, FindsClashesBetweenFiles) {
  const std::string text = "title = \"A\"\nname = \"a\"\n" + revolute;
  const auto clashes = check_together({read_text(text, "one.toml"), read_text(text, "two.toml")});
  ASSERT_EQ(clashes.size(), 1U);
  EXPECT_EQ(to_string(clashes[0]),
            "two.toml:2:8: error: the robot name 'a' is taken by one.toml; give each robot of a run a name "
            "of its own");
}

}  // namespace
}  // namespace qvgen::description
