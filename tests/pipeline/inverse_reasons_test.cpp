// SPDX-License-Identifier: MIT
// Why arms have no inverse kinematics. Six joints of which two turn about one line: no pose has finitely many
// solutions, and that is all that is said. Joints that close a loop are no arm.
#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/reader.h"
#include "pipeline/pipeline.h"
#include "pipeline/products/inverse_derivation.h"

namespace qvgen::pipeline {
namespace {

std::string joint(int i, const std::string& type, char axis, const std::string& link) {
  return fmt::format("[[joint]]\ntype = \"{}\"\naxis = \"+{}\"\nvariable = \"q{}\"\nlink = [{}]\n", type,
                     axis, i, link);
}

/// Random joints at right angles; the turns `first` and the one behind it have one line, along which the
/// joint before them slides.
std::string arm(unsigned seed, int first) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  std::string text = "name = \"wrist\"\ntitle = \"Two turns about one line\"\n";
  const char line = "xyz"[below(3)];
  for (int i = 0; i < 6; ++i) {
    const bool is_on_line = i == first || i == first + 1;
    const bool slides = i + 1 == first;
    const std::string any = fmt::format("0.{}, 0.{}, 0.{}", below(9), below(9), below(9));
    const std::string along = line == 'x' ? "0.1, 0, 0" : line == 'y' ? "0, 0.1, 0" : "0, 0, 0.1";
    text += joint(i, slides ? "prismatic" : "revolute", is_on_line || slides ? line : "xyz"[below(3)],
                  i == first ? along : any);
  }
  return text;
}

TEST(ReasonsOfInverse, ThatNoPoseHasFinitelyManySolutionsIsSaidAlone) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const std::string text = arm(seed, 1 + static_cast<int>(seed % 4));
    const auto read = description::read_text(text, "wrist.toml");
    ASSERT_TRUE(read.robot) << text;
    EXPECT_THAT(derive_inverse(*read.robot).reasons,
                testing::ElementsAre("at every pose some joints can move without moving the tool: the "
                                     "Jacobian's determinant vanishes everywhere"))
        << text;
  }
}

/// A four-bar's joints stand in a row like an arm's, but are not free.
TEST(ReasonsOfInverse, JointsInARowThatCloseALoopAreNoArm) {
  std::string text = "name = \"bars\"\ntitle = \"Four bars in a row\"\nactuated = [\"q0\"]\n";
  for (int i = 0; i < 3; ++i) text += joint(i, "revolute", 'z', "0.4, 0, 0");
  text += "[[tip]]\nname = \"point\"\njoint = \"q1\"\n";
  text += "[[loop]]\ntype = \"pin\"\nbetween = [\"q2\", \"base\"]\nat = [[0.3, 0, 0], [0.5, 0, 0]]\n";
  const auto read = description::read_text(text, "bars.toml");
  ASSERT_TRUE(read.robot);
  model::Robot open = *read.robot;
  open.has_loops = false;
  const std::vector<RobotOutput> outputs = generate({*read.robot, open}, {"inverse"});
  const auto has_inverse = [](const OutputFile& file) { return file.path.ends_with("inverse.h"); };
  EXPECT_TRUE(std::none_of(outputs[0].files.begin(), outputs[0].files.end(), has_inverse));
  EXPECT_TRUE(std::any_of(outputs[1].files.begin(), outputs[1].files.end(), has_inverse))
      << "with free joints";
  EXPECT_THAT(outputs[0].missing,
              testing::Contains(testing::Field(
                  &Missing::reason, "the joints close loops: each limb has it, as a robot of its own")));
}

}  // namespace
}  // namespace qvgen::pipeline
