// SPDX-License-Identifier: MIT
// Mistakes in [[loop]] tables: each is reported with its line, what is wrong and what would be right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../description/folder.h"
#include "description/reader.h"

namespace qvgen::test::loops {
namespace {

using testing::HasSubstr;

/// A crank and a rocker on the base; line 13 is the first behind them.
const std::string two_links =
    "name = \"m\"\ntitle = \"m\"\nactuated = [\"a\"]\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\n"
    "variable = \"a\"\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"b\"\nparent = \"base\"\n";
const std::string tip = "[[tip]]\nname = \"end\"\n";

std::string rod(const std::string& between, const std::string& at = "[[1, 0, 0], [1, 0, 0]]",
                const std::string& length = "1") {
  return "[[loop]]\ntype = \"rod\"\nbetween = " + between + "\nat = " + at + "\nlength = " + length + "\n";
}

std::string first_error(const std::string& text) {
  const auto result = description::read_text(text, "m.toml");
  return result.diagnostics.empty() ? "" : description::to_string(result.diagnostics.front());
}

TEST(LoopDescription, ReadsClosuresWithTheJointsThatAreDriven) {
  const auto result = description::read_text(two_links + rod("[\"a\", \"b\"]") + tip, "m.toml");
  ASSERT_TRUE(result.robot.has_value()) << first_error(two_links + rod("[\"a\", \"b\"]") + tip);
  ASSERT_EQ(result.loops.closures.size(), 1U);
  EXPECT_EQ(result.loops.closures[0].type, model::LoopType::rod);
  EXPECT_EQ(result.loops.closures[0].links[1], 1U);
  EXPECT_EQ(result.loops.actuated, std::vector<std::size_t>{0});
}

/// A platform on a planar joint: its own name means its last part between links, all parts in lists.
TEST(LoopDescription, NamesComposedJointsByTheirOwnNames) {
  const auto read = [](const std::string& link, const std::string& outputs) {
    return description::read_text("name = \"m\"\ntitle = \"m\"\nactuated = [\"a\"]\noutputs = [" + outputs +
                                      "]\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"a\"\n"
                                      "[[joint]]\ntype = \"planar\"\nvariable = \"p\"\nparent = \"base\"\n" +
                                      rod("[\"a\", \"" + link + "\"]") + tip,
                                  "m.toml");
  };
  const auto own = read("p", "\"p\""), parts = read("p_z", "\"p_x\", \"p_y\", \"p_z\"");
  ASSERT_EQ(own.loops.closures.size(), 1U);
  EXPECT_EQ(own.loops.closures[0].links[1], 3U);
  EXPECT_EQ(own.loops.closures[0].links, parts.loops.closures[0].links);
  EXPECT_EQ(own.loops.outputs, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(own.loops.outputs, parts.loops.outputs);
  const auto twice = read("p", "\"p_y\", \"p\"");
  ASSERT_EQ(twice.diagnostics.size(), 1U);
  EXPECT_THAT(description::to_string(twice.diagnostics[0]),
              HasSubstr("m.toml:4:19: error: 'outputs' names this joint twice"));
}

TEST(LoopDescription, NamesALinkThatIsNotThereWithItsPlace) {
  const std::string error = first_error(two_links + rod("[\"a\", \"bb\"]") + tip);
  EXPECT_THAT(error, HasSubstr("m.toml:15:"));
  EXPECT_THAT(error, HasSubstr("there is no joint with the variable 'bb'"));
  EXPECT_THAT(error, HasSubstr("did you mean 'b'?"));
}

TEST(LoopDescription, RefusesALoopWithinOneLink) {
  const std::string error = first_error(two_links + rod("[\"b\", \"b\"]") + tip);
  EXPECT_THAT(error, HasSubstr("m.toml:15:"));
  EXPECT_THAT(error, HasSubstr("a loop within one link"));
}

TEST(LoopDescription, RefusesPointsThatAreNone) {
  EXPECT_THAT(first_error(two_links + rod("[\"a\", \"b\"]", "[[1, 0], [1, 0, 0]]") + tip),
              HasSubstr("m.toml:16:7: error: a point of 'at' is no list of three entries"));
  EXPECT_THAT(first_error(two_links + rod("[\"a\", \"b\"]", "[[1, 0, 0]]") + tip),
              HasSubstr("'at' is no list of 2 entries"));
}

TEST(LoopDescription, RefusesATurnAsALength) {
  EXPECT_THAT(first_error(two_links + rod("[\"a\", \"b\"]", "[[1, 0, 0], [1, 0, 0]]", "\"a\"") + tip),
              HasSubstr("joint a turns: it is no length"));
}

TEST(LoopDescription, RefusesRodsWithoutLength) {
  EXPECT_THAT(first_error(two_links + rod("[\"a\", \"b\"]", "[[1, 0, 0], [1, 0, 0]]", "0") + tip),
              HasSubstr("the length of a rod is not above 0"));
}

TEST(LoopDescription, RefusesTypesThatThereAreNot) {
  EXPECT_THAT(
      first_error(two_links +
                  "[[loop]]\ntype = \"gear\"\nbetween = [\"a\", \"b\"]\nat = [[0, 0, 0], [0, 0, 0]]\n" + tip),
      HasSubstr("m.toml:14:8: error: unknown type of loop 'gear'; write pin, ball, rod, weld or slide"));
}

TEST(LoopDescription, KeysBelongToTheirTypes) {
  const auto loop = [](const std::string& type, const std::string& keys) {
    return two_links + "[[loop]]\ntype = \"" + type +
           "\"\nbetween = [\"a\", \"b\"]\nat = [[0, 0, 0], [0, 0, 0]]\n" + keys + tip;
  };
  EXPECT_THAT(first_error(loop("slide", "")), HasSubstr("axis = \"+x\", along which the second link slides"));
  EXPECT_THAT(first_error(loop("weld", "axis = \"+x\"\n")),
              HasSubstr("m.toml:17:1: error: 'axis' belongs to a pin or a slide; leave it out"));
  EXPECT_THAT(first_error(loop("ball", "rpy = [0, 0, 1]\n")),
              HasSubstr("m.toml:17:1: error: 'rpy' belongs to a weld or a slide; leave it out"));
  const auto slide =
      description::read_text(loop("slide", "axis = \"+x\"\nrpy = [0, 0, \"90 deg\"]\n"), "m.toml");
  ASSERT_TRUE(slide.robot.has_value());
  EXPECT_EQ(slide.loops.closures[0].turns.size(), 1U);
}

TEST(LoopDescription, NamesDrivenJointsOnce) {
  std::string text = two_links + rod("[\"a\", \"b\"]") + tip;
  text.replace(text.find("actuated = [\"a\"]\n"), 17, "");
  const auto open = description::read_text(text, "m.toml");
  ASSERT_TRUE(open.robot.has_value());  // they are derived where there is no choice
  EXPECT_TRUE(open.loops.actuated.empty());
  std::string twice = two_links + rod("[\"a\", \"b\"]") + tip;
  twice.replace(twice.find("[\"a\"]"), 5, "[\"a\", \"a\"]");
  EXPECT_THAT(first_error(twice), HasSubstr("m.toml:3:18: error: 'actuated' names this joint twice"));
}

TEST(LoopDescription, RefusesDrivenJointsWithoutLoops) {
  EXPECT_THAT(first_error(two_links + tip), HasSubstr("m.toml:3:1: error: 'actuated' without [[loop]]"));
}

/// A four-bar as a URDF, with a fixed flange on the coupler.
const std::string urdf = R"(<robot name="bar">
<link name="ground"/><link name="crank"/><link name="coupler"/><link name="rocker"/><link name="flange"/>
<joint name="m" type="continuous"><parent link="ground"/><child link="crank"/><axis xyz="0 0 1"/></joint>
<joint name="p" type="continuous"><parent link="crank"/><child link="coupler"/>
  <origin xyz="0.1 0 0"/><axis xyz="0 0 1"/></joint>
<joint name="fix" type="fixed"><parent link="coupler"/><child link="flange"/>
  <origin xyz="0.3 0 0" rpy="0 0 1.5707963"/></joint>
<joint name="r" type="continuous"><parent link="ground"/><child link="rocker"/>
  <origin xyz="0.3 0 0"/><axis xyz="0 0 1"/></joint>
</robot>
)";

description::ReadResult beside_urdf(const std::string& toml) {
  const description::Folder folder;
  return folder.write("bar.urdf", urdf).write("bar.toml", toml).read("bar.toml");
}

std::string error_beside_urdf(const std::string& toml) {
  for (const auto& diagnostic : beside_urdf(toml).diagnostics)
    if (diagnostic.severity == description::Diagnostic::error) {
      const std::string text = description::to_string(diagnostic);
      return text.substr(text.rfind('/') + 1);
    }
  return "";
}

const std::string closes_urdf =
    "robot = \"bar.urdf\"\nactuated = [\"m\"]\n[[loop]]\ntype = \"pin\"\nbetween = [\"flange\", \"rocker\"]\n"
    "at = [[0, -0.05, 0], [0.25, 0, 0]]\n";

TEST(LoopsBesideAUrdf, AreClosedBetweenItsLinks) {
  const auto result = beside_urdf(closes_urdf);
  ASSERT_TRUE(result.robot.has_value());
  EXPECT_EQ(result.robot->name, "bar");
  EXPECT_EQ(result.robot->source, "bar.urdf");
  ASSERT_EQ(result.files.size(), 1U);
  ASSERT_EQ(result.loops.closures.size(), 1U);
  const model::Loop& loop = result.loops.closures[0];
  EXPECT_EQ(result.robot->joints[loop.links[0]].variable, "p");  // the flange is a part of the coupler
  EXPECT_EQ(to_string(loop.points[0][0]), "7/20");
  EXPECT_EQ(result.robot->joints[loop.links[1]].variable, "r");
  EXPECT_EQ(result.robot->joints[result.loops.actuated.at(0)].variable, "m");
}

TEST(LoopsBesideAUrdf, MistakesComeWithTheirPlaces) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = closes_urdf;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(error_beside_urdf(with("\"rocker\"", "\"roker\"")),
            "bar.toml:5:22: error: there is no link 'roker'; did you mean 'rocker'?");
  EXPECT_EQ(error_beside_urdf(with("[\"m\"]", "[\"mm\"]")),
            "bar.toml:2:12: error: there is no joint 'mm' that moves; did you mean 'm'?");
  EXPECT_THAT(error_beside_urdf(with("bar.urdf", "no.urdf")), HasSubstr("no.urdf: No such file"));
  EXPECT_THAT(
      error_beside_urdf(with("0.25", "\"l\"")),
      HasSubstr("bar.toml:6:24: error: the name 'l' beside a URDF, which has no symbols; write a number"));
  EXPECT_THAT(error_beside_urdf("robot = \"bar.urdf\"\n"), HasSubstr("[[loop]] tables"));
}

}  // namespace
}  // namespace qvgen::test::loops
