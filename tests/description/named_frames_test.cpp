// SPDX-License-Identifier: MIT
// Frames that a description names, in TOML, URDF and MJCF.
#include "description/named_frames.h"

#include <gtest/gtest.h>

#include "description/names.h"
#include "description/reader.h"
#include "description/write.h"
#include "xml.h"

namespace qvgen::description {
namespace {

const std::string two_joints =
    "name = \"arm\"\ntitle = \"t\"\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"a\"\n"
    "[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable = \"b\"\n";

ReadResult read_frames(const std::string& frames) { return read_text(two_joints + frames, "arm.toml"); }

/// Returns the complaint about a description, without its place.
std::string complaint(const std::string& frames) {
  const ReadResult result = read_frames(frames);
  EXPECT_FALSE(result.robot);
  return result.diagnostics.empty() ? "" : result.diagnostics.front().message;
}

TEST(NamedFrames, AreFixedToALink) {
  const ReadResult result = read_frames(
      "[[frame]]\nname = \"camera\"\njoint = \"a\"\ntranslation = [\"c\", 0, 0.5]\n"
      "rpy = [0, 0, \"90 deg\"]\n[[frame]]\nname = \"flange\"\n");
  ASSERT_TRUE(result.robot);
  const auto& frames = result.robot->frames;
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].name, "camera");
  EXPECT_EQ(frames[0].joint, 0U);
  EXPECT_EQ(to_string(frames[0].placement.translation[2]), "1/2");
  EXPECT_EQ(frames[0].placement.turns.size(), 1U);
  EXPECT_EQ(frames[1].joint, 1U);
  ASSERT_EQ(result.robot->geometry.size(), 1U);  // a length of the caller's, as in any other frame
  EXPECT_EQ(result.robot->geometry[0].name, "c");
}

TEST(NamedFrames, MistakesAreReported) {
  EXPECT_EQ(complaint("[[frame]]\njoint = \"a\"\n"), "missing key 'name' in [[frame]]");
  EXPECT_EQ(complaint("[[frame]]\nname = \"c\"\njoint = \"bb\"\n"),
            "there is no joint with the variable 'bb'");
  EXPECT_EQ(complaint("[[frame]]\nname = \"c\"\n[[frame]]\nname = \"c\"\n"),
            "the frame 'c': another frame has this name");
  EXPECT_EQ(complaint("[[frame]]\nname = \"link2\"\n"),
            "the frame 'link2': link1, link2, ... are the links' own frames");
  EXPECT_EQ(complaint("[[frame]]\nname = \"two words\"\n").substr(0, 23), "the frame 'two words': ");
  EXPECT_EQ(complaint("[[frame]]\nname = \"c\"\nposition = [0, 0, 1]\n").empty(), false);
}

TEST(NamedFrames, ThereIsALimit) {
  std::string frames;
  for (std::size_t i = 0; i <= most_frames; ++i)
    frames += "[[frame]]\nname = \"f" + std::to_string(i) + "\"\n";
  EXPECT_EQ(complaint(frames), "more than 64 frames");
}

/// Whatever a file calls its links, the names are valid, different, and found at once.
TEST(NamedFrames, NamesAreMadeOfAnyText) {
  std::vector<model::Frame> frames;
  for (const std::string& text :
       {std::string("TOOL"), std::string("tool"), std::string("L_HAND"), std::string("7"), std::string(""),
        std::string("class"), std::string("link3"), std::string(100, 'x'), std::string(100, 'x'),
        std::string("a-b c"), std::string("\xc3\xa9"), std::string("unix"), std::string("M_elbow")}) {
    const std::string name = frame_identifier(text, frames);
    EXPECT_TRUE(check_identifier(name).message.empty()) << text << " -> " << name;
    for (const model::Frame& other : frames) EXPECT_NE(other.name, name);
    frames.push_back({name, 0, {}});
  }
  EXPECT_EQ(frames[0].name, "tool");
  EXPECT_EQ(frames[1].name, "tool_2");
  EXPECT_EQ(frames[2].name, "l_hand");
  EXPECT_EQ(frames[6].name, "link3_frame");
}

constexpr const char* urdf = R"(<robot name="r">
<link name="base"/><link name="mount"/><link name="upper"/><link name="CAMERA"/><link name="lens"/>
<link name="fore"/><link name="finger"/><link name="tool0"/>
<joint name="f0" type="fixed"><parent link="base"/><child link="mount"/></joint>
<joint name="j1" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/></joint>
<joint name="f1" type="fixed"><parent link="upper"/><child link="CAMERA"/><origin xyz="0.1 0 0" rpy="0 0 1.5707963267948966"/></joint>
<joint name="f2" type="fixed"><parent link="CAMERA"/><child link="lens"/><origin xyz="0.2 0 0"/></joint>
<joint name="j2" type="continuous"><parent link="upper"/><child link="fore"/><origin xyz="0 0 1"/><axis xyz="0 1 0"/></joint>
<joint name="j3" type="prismatic"><parent link="fore"/><child link="finger"/><axis xyz="0 1 0"/><limit lower="0" upper="1"/></joint>
<joint name="f3" type="fixed"><parent link="fore"/><child link="tool0"/><origin xyz="0 0 0.3"/></joint>
</robot>)";

/// The tip is the tool, what is fixed to the base does not move, and a finger moves by a joint of its own.
TEST(NamedFrames, FixedLinksOfAUrdfThatHangOnTheChain) {
  const model::Robot robot = read(urdf);
  ASSERT_EQ(robot.frames.size(), 2U);
  EXPECT_EQ(robot.frames[0].name, "camera");
  EXPECT_EQ(robot.frames[0].joint, 0U);
  EXPECT_EQ(robot.frames[1].name, "lens");
  EXPECT_EQ(to_string(robot.frames[1].placement.translation[0]), "1/10");
  EXPECT_EQ(to_string(robot.frames[1].placement.translation[1]), "1/5");
}

TEST(NamedFrames, SitesOfAnMjcfThatHaveNames) {
  const model::Robot robot = read(
      "<mujoco><worldbody><body name=\"a\"><joint name=\"j\" axis=\"0 0 1\"/><site name=\"cam\" pos=\"1 2 "
      "3\"/>"
      "<site pos=\"3 2 1\"/><body name=\"plate\" pos=\"0 0 1\"/></body></worldbody></mujoco>");
  ASSERT_EQ(robot.frames.size(), 1U);  // the plate is the tip
  EXPECT_EQ(robot.frames[0].name, "cam");
  EXPECT_EQ(to_string(robot.frames[0].placement.translation[1]), "2");
}

TEST(NamedFrames, AreWrittenBack) {
  const model::Robot robot = read(urdf);
  const std::string text = write_text(robot);
  const ReadResult again = read_text(text, "a.toml");
  ASSERT_TRUE(again.robot) << text;
  EXPECT_EQ(write_text(*again.robot), text);
  ASSERT_EQ(again.robot->frames.size(), 2U);
  EXPECT_EQ(texts(again.robot->frames[1].placement), texts(robot.frames[1].placement));
}

}  // namespace
}  // namespace qvgen::description
