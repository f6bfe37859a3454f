// SPDX-License-Identifier: MIT
#include "description/names.h"

#include <random>
#include <set>

#include "description/tree/tree.h"
#include "xml.h"

// Whatever a file calls its robot and its joints: the names in the code are valid, differ from each other,
// and each change is noted. Names in capitals once were an endless loop.
namespace qvgen::description {
namespace {

std::string named(const std::string& robot, const std::vector<std::string>& joints) {
  std::string text = "<robot name=\"" + robot + "\"><link name=\"l0\"/>";
  for (std::size_t i = 0; i < joints.size(); ++i)
    text += "<link name=\"l" + std::to_string(i + 1) + "\"/>\n<joint name=\"" + joints[i] +
            "\" type=\"continuous\"><parent link=\"l" + std::to_string(i) + "\"/><child link=\"l" +
            std::to_string(i + 1) + "\"/></joint>";
  return text + "</robot>";
}

TEST(Names, JointsInCapitalsAndOthers) {
  const auto name = [](const std::string& text) { return tree::identifier(text, {}); };
  EXPECT_EQ(name("elbow"), "elbow");
  EXPECT_EQ(name("LF_HAA"), "LF_HAA_joint");
  EXPECT_EQ(name("M_elbow"), "joint_M_elbow");
  EXPECT_EQ(name("EIGEN_X"), "joint_EIGEN_X");
  EXPECT_EQ(name("J1"), "J1");
  EXPECT_EQ(name("2nd"), "joint_2nd");
  EXPECT_EQ(name("class"), "class_joint");
  EXPECT_EQ(name("q"), "q_joint");
  EXPECT_EQ(name("--"), "joint");
  EXPECT_EQ(name(std::string(64, 'a')), std::string(64, 'a'));
  EXPECT_EQ(name(std::string(40, 'a') + "_joint_" + std::string(18, 'b')),
            std::string(31, 'a') + "_" + std::string(7, 'a') + "_joint_" + std::string(18, 'b'));
  EXPECT_EQ(tree::identifier("L1", {"L1"}), "L1_joint");
  EXPECT_EQ(tree::identifier("turn", {"turn", "turn_1"}), "turn_2");
}

TEST(Names, RobotsAreInLowerCase) {
  EXPECT_EQ(tree::robot_identifier("UF_ROBOT"), "uf_robot");
  EXPECT_EQ(tree::robot_identifier("GEN3-7DOF"), "gen3_7dof");
  EXPECT_EQ(tree::robot_identifier("7bot"), "robot_7bot");
  EXPECT_EQ(tree::robot_identifier("M_1"), "m_1");
  EXPECT_EQ(tree::robot_identifier("detail"), "detail_robot");
  EXPECT_EQ(tree::robot_identifier(""), "robot");
}

TEST(Names, ChangesAreNotedAndTheOptionWins) {
  EXPECT_EQ(report(named("UF_ROBOT", {"LF_HAA"})),
            "1:14: note: the robot 'UF_ROBOT' is 'uf_robot' in the code; names of robots have small letters, "
            "digits "
            "and '_' there; --name gives another\n"
            "2:1: note: the joint 'LF_HAA' is 'LF_HAA_joint' in the code; names have letters, digits and '_' "
            "there, "
            "at most 64, and are no macros\n");
  EXPECT_EQ(report(named("UF_ROBOT", {"j"}), {.name = "xarm"}), "");
  EXPECT_EQ(report(named("UF_ROBOT", {"j"}), {.name = "XARM"}),
            "1:1: error: --name XARM: 'XARM' may be a macro of C or C++; names in capitals are theirs; write "
            "'xarm'\n");
  EXPECT_EQ(
      report("<mujoco model=\"RIZON\"><worldbody><body name=\"b\"><joint name=\"j\"/>"
             "</body></worldbody></mujoco>"),
      "1:16: note: the robot 'RIZON' is 'rizon' in the code; names of robots have small letters, digits and "
      "'_' there; --name gives another\n");
}

TEST(Names, ARobotWithoutANameHasItsFiles) {
  const std::string mjcf =
      "<mujoco><worldbody><body name=\"b\"><joint name=\"j\"/></body></worldbody></mujoco>";
  std::string urdf = named("", {"j"});
  urdf.erase(urdf.find(" name=\"\""), 8);
  for (const std::string& text : {mjcf, urdf}) {
    const auto name = [&](const std::string& file) {
      const ReadResult result = read_text(text, file);
      return result.robot ? result.robot->name + "," + result.robot->title
                          : to_string(result.diagnostics.at(0));
    };
    EXPECT_EQ(name("models/My-Arm 6.xml"), "my_arm_6,my_arm_6");
    EXPECT_EQ(name("7bot.urdf"), "robot_7bot,robot_7bot");
    EXPECT_EQ(name(""), "robot,robot");
  }
}

/// Returns a random name of letters that have led to clashes: few, so that many names meet.
std::string random_name(std::mt19937& random) {
  static const std::vector<std::string> parts{"M_", "EIGEN_", "L", "LF_HAA", "1",     "12", "_",    "-",
                                              "j",  "int",    "q", "é",      "joint", " ",  "elbow"};
  std::string name;
  const std::size_t count =
      std::uniform_int_distribution<std::size_t>(0, random() % 10 == 0 ? 60 : 3)(random);
  for (std::size_t i = 0; i < count; ++i) name += parts[random() % parts.size()];
  return name;
}

TEST(Names, AnyTextsGiveValidNamesThatDiffer) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    std::vector<std::string> taken;
    for (int joint = 0; joint < 16; ++joint) {
      const std::string text = random_name(random);
      taken.push_back(tree::identifier(text, taken));
      ASSERT_EQ(check_identifier(taken.back()).message, "") << "'" << text << "'";
    }
    ASSERT_EQ(std::set<std::string>(taken.begin(), taken.end()).size(), taken.size());
    const std::string robot = random_name(random);
    ASSERT_EQ(check_robot_name(tree::robot_identifier(robot)).message, "") << "'" << robot << "'";
  }
}

}  // namespace
}  // namespace qvgen::description
