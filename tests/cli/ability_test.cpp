// SPDX-License-Identifier: MIT
// What `show --inverse` says first: what an arm can be asked for, by which structure, how many solutions.
#include <sstream>

#include <gmock/gmock.h>

#include "command_line.h"

namespace qvgen::test {
namespace {

/// A description: "Rz 0 0 0.3; Py" is a turn about z with a link behind it and a slide along y.
std::string arm(const std::string& joints, const std::string& keys = "") {
  std::string text = "name = \"my_arm\"\ntitle = \"arm\"\n" + keys;
  std::istringstream list(joints);
  int number = 0;
  for (std::string item; std::getline(list, item, ';');) {
    std::istringstream words(item);
    std::string kind, x = "0", y = "0", z = "0";
    words >> kind >> x >> y >> z;
    const bool turns = kind[0] == 'R';
    text += "[[joint]]\ntype = \"" + std::string(turns ? "revolute" : "prismatic") + "\"\naxis = \"+" +
            kind[1] + "\"\nvariable = \"q" + std::to_string(++number) + "\"\n" +
            (turns ? "link = [" + x + ", " + y + ", " + z + "]\n" : "");
  }
  return text;
}

class Ability : public CommandLine {
 protected:
  /// The first paragraph.
  std::string of(const std::string& description) {
    const ToolRun shown = run("show --inverse " + write("my_arm.toml", description));
    EXPECT_EQ(shown.code, 0) << shown.output;
    return shown.output.substr(0, shown.output.find("\n\n"));
  }
};

constexpr const char* whole_pose =
    " A whole pose may be asked for too; it is unreachable unless the arm can take it.";
constexpr const char* open_turn = " Below, toolturn is the turn of the tool that is left open.";
constexpr const char* five_joints = "Rz 0 0 0.5; Ry 0.4 0 0; Rz 0 0 0.4; Ry 0 0 0; Rz 0 0 0.1";
constexpr const char* four_joints = "Rz 0 0 0.5; Ry 0.4 0 0; Ry 0.4 0 0; Ry 0.1 0 0";
constexpr const char* palletiser = "Rz 0.2 0 0.5; Ry 0 0 0.8; Ry 0.9 0 0; Ry 0.2 0 -0.1; Rz 0 0 -0.1";
constexpr const char* seven_joints =
    "Rz 0 0 0.34; Ry 0 0 0; Rz 0 0 0.4; Ry 0 0 0; Rz 0 0 0.4; Ry 0 0 0; Rz 0 0 0.1";

TEST_F(Ability, OfFewerThanSixJoints) {
  EXPECT_EQ(of(arm("Rz 0.3 0 0.4; Rz 0.25 0 0; Pz; Rz 0 0 0")),
            "4 joints, asked for a position of the tool point and a turn about the direction that its axes "
            "share: the other joints place a point on the axis of q4. At most 2 solutions." +
                std::string(whole_pose));
  EXPECT_EQ(of(arm("Rz 0 0 0.3; Ry 0 0 0.1")),
            "2 joints, asked for the direction of the tool's axis z: three axes turn the tool; the position "
            "follows. At most 2 solutions." +
                std::string(whole_pose) + open_turn);
  EXPECT_EQ(of(arm(five_joints)),
            "5 joints, asked for a position of the tool point and the direction of the tool's axis x: the "
            "axes of joints 3, 4 and 5 meet in one point: position and orientation decouple. At most 8 "
            "solutions." +
                std::string(whole_pose) + open_turn);
  EXPECT_EQ(of(arm(palletiser, "task = \"position_and_yaw\"\n")),
            "5 joints, asked for a position of the tool point and a turn about the direction that its axes "
            "share: joints 2, 3 and 4 move in one plane and keep the tool level: the others place a point on "
            "the axis of q5. At most 4 solutions." +
                std::string(whole_pose));
  EXPECT_EQ(of(arm("Rz 0 0 0.5; Ry 0.4 0 0; Ry 0.4 0 0")),
            "3 joints, asked for a position of the tool point: three joints place the tool point; the "
            "orientation follows. At most 4 solutions.");
  EXPECT_EQ(of(arm(four_joints)),
            "4 joints, asked for the poses that it can take: the other joints place a point on the axis of "
            "q4. At most 4 solutions.");
  EXPECT_EQ(of(arm("Rz 0 0 0; Px")),
            "2 joints, asked for a position of the tool point: three joints place the tool point; the "
            "orientation follows. At most 2 solutions. Below, toolslide is a slide of the tool, which ends "
            "at zero.");
}

TEST_F(Ability, OfAGivenJoint) {
  const std::string meet = " given by the caller: the axes of joints ";
  const std::string end = " meet in one point: position and orientation decouple. At most 8 solutions.";
  const std::string asked = "7 joints, asked for position and orientation with ";
  EXPECT_EQ(of(arm(seven_joints)), asked + "q3" + meet + "5, 6 and 7" + end);
  EXPECT_EQ(of(arm(seven_joints, "given = \"q5\"\n")), asked + "q5" + meet + "1, 2 and 3" + end);
  EXPECT_EQ(of(arm("Py; Rz 0 0 0.6; Ry 0.4 0.1 0; Ry 0.02 0 0; Rz 0 0 0.4; Ry 0 0 0; Rz 0 0 0.1")),
            asked + "q1" + meet + "5, 6 and 7" + end);
  EXPECT_EQ(of(arm(four_joints, "task = \"position\"\ngiven = \"q3\"\n"))
                .find("4 joints, asked for a "
                      "position of the tool point with q3 given by the caller: "),
            0U);
}

TEST_F(Ability, OfSeveralGivenJoints) {
  const auto shown = [&](const std::string& given) {
    return run("show --inverse " + write("my_arm.toml", arm(seven_joints, "given = \"" + given + "\"\n")))
        .output;
  };
  const auto count = [](const std::string& text) {
    std::size_t number = 0;
    for (std::size_t at = text.find(" given by the caller"); at != std::string::npos;
         at = text.find(" given by the caller", at + 1))
      ++number;
    return number;
  };
  EXPECT_EQ(count(shown("q3, q5")), 2U);
  // The elbow's own angle follows from the distance of the wrist: it cannot be given.
  EXPECT_EQ(count(shown("all")), 6U);
  EXPECT_NE(shown("q3, q4").find("with q4 given: "), std::string::npos);
}

TEST_F(Ability, OfAnArmAngle) {
  const auto says = [&](const std::string& description, const std::string& what) {
    const ToolRun shown = run("show --inverse " + write("my_arm.toml", description));
    return shown.code == 0 && has(shown, what);
  };
  EXPECT_TRUE(says(arm(seven_joints), "By the arm angle too (arm_angle.h), the elbow's turn about the line"));
  const std::string offset_wrist =
      "Rz 0 0 0.34; Ry 0 0 0; Rz 0 0 0.4; Ry 0 0 0; Rz 0 0 0.4; Ry 0.1 0 0; Rz 0 0 0.1";
  EXPECT_TRUE(says(arm(offset_wrist, "given = \"q7\"\n"),
                   "Not by an arm angle: the axes of joints 5, 6 and 7 do not meet in one point."));
  EXPECT_FALSE(says(arm(four_joints), "arm angle"));
}

constexpr const char* five_servos = "Rz 0 0 0.1; Ry 0.1 0 0; Ry 0.1 0 0; Ry 0.05 0 0; Rx 0.1 0 0";

TEST_F(Ability, OfAPositionAndAPitch) {
  const std::string asked = " asked for a position of the tool point and the pitch of the tool's axis ";
  const std::string by_plane =
      "joints 2, 3 and 4 move in one plane: the pitch tells where the axis of q4 is, the others place it. At "
      "most 4 "
      "solutions. A pose may be given too, for its position and pitch; one that is tilted to the side is "
      "unreachable.";
  const std::string task = "task = \"position_and_pitch\"\n";
  EXPECT_EQ(of(arm(four_joints, task)), "4 joints," + asked + "z: " + by_plane);
  EXPECT_EQ(of(arm(five_servos, task + "tool_axis = \"+x\"\n")),
            "5 joints," + asked + "x with q5 given by the caller: " + by_plane);
}

TEST_F(Ability, OfAPositionAndAnInclination) {
  const std::string task = "task = \"position_and_inclination\"\n";
  EXPECT_EQ(
      of(arm(five_servos, task)),
      "5 joints, asked for a position of the tool point and the direction of the first axis as the tool "
      "sees it: joints 2, 3 and 4 move in one plane: the inclination tells q5 and where the axis of q4 "
      "is, the others place it. At most 8 solutions. A pose may be given too; its heading, the turn "
      "about the first axis, is not used.");
  EXPECT_THAT(of(arm(std::string(five_servos) + "; Ry 0.1 0 0", task)),
              testing::HasSubstr("as the tool sees it with q6 given by the caller: "));
  EXPECT_THAT(
      of(arm(five_joints, task)),
      testing::AllOf(testing::HasSubstr("no structure that a closed form needs. At most 16 solutions"),
                     testing::EndsWith("Below, heading is the heading, which is left open.")));
}

constexpr const char* six_joints = "Rz 0 0 0.5; Ry 0.4 0 0; Ry 0.4 0 0; Rx 0.1 0 0; Ry 0 0 0; Rx 0.1 0 0";

TEST_F(Ability, OfAPositionAndADirectionWithAJointGiven) {
  const std::string task = "task = \"position_and_direction\"\n";
  const std::string asked =
      "6 joints, asked for a position of the tool point and the direction of the tool's axis ";
  EXPECT_THAT(of(arm(six_joints, task + "tool_axis = \"+x\"\n")),
              testing::StartsWith(
                  asked + "x with q6 given by the caller: the axes of joints 4, 5 and the tool's own"));
  EXPECT_THAT(
      of(arm(six_joints, task + "given = \"q1\"\n")),
      testing::StartsWith(asked + "z with q1 given by the caller: the axes of joints 4, 5 and 6 meet"));
  EXPECT_THAT(of(arm(six_joints, task + "given = \"q4\"\n")),
              testing::HasSubstr("with q4 given by the caller: no structure that a closed form needs"));
  // q6 turns about the axis: it moves nothing that is asked for, and has to be the one that is given.
  const ToolRun shown =
      run("show --inverse " +
          write("my_arm.toml", arm(six_joints, task + "tool_axis = \"+x\"\ngiven = \"q4\"\n")));
  EXPECT_EQ(shown.code, 1);
  EXPECT_TRUE(has(shown, "at every pose some joints can move without moving the tool")) << shown.output;
  EXPECT_TRUE(has(shown, "there is a closed form with given = \"q6\"")) << shown.output;
}

TEST_F(Ability, WhatIsNotServedIsRefused) {
  const auto refused = [&](const std::string& description, const std::string& reason) {
    const ToolRun shown = run("show --inverse " + write("my_arm.toml", description));
    EXPECT_EQ(shown.code, 1);
    EXPECT_TRUE(has(shown, reason)) << shown.output;
  };
  refused(arm(five_joints, "task = \"position\"\n"),
          "5 joints: the task position fixes 3; name 2 whose values are given");
  refused(arm(five_joints, "given = \"q5\"\n"), "here, 5 joints leave none over");
  refused(arm(six_joints, "task = \"position\"\n"),
          "6 joints: the task position fixes 3; name 3 whose values are given: given = \"q1, q2, q3\"");
  refused(arm(six_joints, "task = \"position_and_yaw\"\n"),
          "it may be asked for pose, position_and_direction or position_and_inclination with a joint given");
  refused(arm(six_joints, "given = \"q5\"\n"),
          "six that are asked for a position and a direction (task = \"position_and_direction\")");
  refused(arm(five_servos, "tool_axis = \"+x\"\n"),
          "it may be asked for task = \"position_and_pitch\", with joint 5 given");
  refused(arm(five_joints, "task = \"position_and_pitch\"\n"), "joints 2, 3 and 4 do not move in one plane");
  refused(arm("Px; Py; Pz; Rz 0 0 0.1; Ry 0.1 0 0", "task = \"position_and_inclination\"\n"),
          "by elimination: more than two of the joints slide");
  refused(
      arm(std::string(seven_joints) + "; Ry 0 0 0.1", "given = \"q3, q4, q5\"\n"),
      "of the 3 joints that may be given 2 are: name these alone, or such that all but one are the first or "
      "the last of the arm");
  refused(arm(std::string(seven_joints) + "; Ry 0 0 0.1"), "8 joints: a pose in space fixes six");
  refused(arm(std::string(seven_joints) + "; Ry 0 0 0.1; Rz 0 0 0.1"),
          "name 3 whose values are given: given = \"q1, q2, q3\"");
}

/// Three axes are parallel, and the sixth passes the fifth: by a quartic only if no two neighbours pass each
/// other at less than a tenth of the arm's size.
TEST_F(Ability, OfAxesThatNearlyMeet) {
  const auto passing_by = [](const std::string& length) {
    return arm("Rz 0.02 0 0.05; Ry -0.26 0 0; Ry 0.25 0 0.06; Ry 0.04 0 -0.04; Rz 0.04 " + length +
               " 0.04; Rx 0.13 0 0");
  };
  EXPECT_THAT(of(passing_by("0")),
              testing::HasSubstr("the axes of joints 2, 3 and 4 are parallel. At most 8"));
  for (const char* length : {"1e-9", "2.4e-7", "1e-5", "1e-3", "1e-2"})
    EXPECT_THAT(of(passing_by(length)), testing::HasSubstr("by elimination")) << length;
  EXPECT_THAT(
      of(arm("Rz 0.2 0 0.05; Ry -0.26 0 0; Ry 0.25 0 0.06; Ry 0.2 0 -0.04; Rz 0.04 0.3 0.04; Rx 0.13 0 0")),
      testing::HasSubstr("by a quartic"));
}

/// Two parallel turns and a slide across them leave no elimination, and that is the reason given.
TEST_F(Ability, OfThreeJointsInAPlaneIsExplained) {
  for (const char* joints :
       {"Rz 0.3 0.1 0.2; Rz 0.2 0.5 0.3; Py; Rx 0.4 0.2 0.6; Rx 0.1 0.7 0.3; Ry 0.2 0.1 0.4",
        "Rz 0.3 0.1 0.2; Rz 0.2 0.5 0.3; Ry 0.5 0.1 0.2; Py; Ry 0.1 0.7 0.3; Rx 0.2 0.1 0.4"}) {
    const ToolRun shown = run("show --inverse " + write("my_arm.toml", arm(joints)));
    EXPECT_NE(shown.code, 0);
    EXPECT_THAT(shown.output,
                testing::HasSubstr("two parallel turns and a slide across them, move in a plane"));
  }
}

}  // namespace
}  // namespace qvgen::test
