// SPDX-License-Identifier: MIT
// Mistakes in [[loop]] tables: each is reported with its line, what is wrong and what would be right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(LoopDescription, RefusesTypesThatAreNotDerived) {
  EXPECT_THAT(
      first_error(two_links +
                  "[[loop]]\ntype = \"weld\"\nbetween = [\"a\", \"b\"]\nat = [[0, 0, 0], [0, 0, 0]]\n" + tip),
      HasSubstr("unknown type of loop 'weld'; write pin, ball or rod"));
}

TEST(LoopDescription, WantsToKnowWhichJointsAreDriven) {
  std::string text = two_links + rod("[\"a\", \"b\"]") + tip;
  text.replace(text.find("actuated = [\"a\"]\n"), 17, "");
  EXPECT_THAT(first_error(text), HasSubstr("actuated"));
  std::string twice = two_links + rod("[\"a\", \"b\"]") + tip;
  twice.replace(twice.find("[\"a\"]"), 5, "[\"a\", \"a\"]");
  EXPECT_THAT(first_error(twice), HasSubstr("m.toml:3:18: error: 'actuated' names this joint twice"));
}

TEST(LoopDescription, RefusesDrivenJointsWithoutLoops) {
  EXPECT_THAT(first_error(two_links + tip), HasSubstr("m.toml:3:1: error: 'actuated' without [[loop]]"));
}

}  // namespace
}  // namespace qvgen::test::loops
