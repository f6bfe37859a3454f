// SPDX-License-Identifier: MIT
// The table of Denavit and Hartenberg of any arm, read again, has the arm's forward kinematics: by a
// reference that shares no code with the generator.
#include "canonical/dh_table.h"

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/reader.h"
#include "description/write.h"
#include "model/replace.h"
#include "reference/load.h"

namespace qvgen {
namespace {

using model::DhConvention;

model::Robot read(const std::string& text) {
  const auto result = description::read_text(text, "arm.toml");
  for (const auto& each : result.diagnostics) ADD_FAILURE() << to_string(each) << '\n' << text;
  return result.robot.value();
}

std::string content_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Random values of all symbols.
reference::Values values_of(const model::Robot& robot, std::mt19937& random) {
  reference::Values values;
  std::uniform_real_distribution<double> lengths(-1, 1);
  for (const model::Parameter& each : robot.geometry) values[each.name] = lengths(random);
  return values;
}

/// Returns the table's text after comparing it with the description's; empty if there is no table.
std::string compare(const std::string& text, DhConvention convention, std::mt19937& random) {
  const model::Robot robot = read(text);
  const auto table = canonical::dh_table(robot, convention);
  if (!table) return "";
  const std::string written = description::write_dh_text(robot, *table);
  EXPECT_EQ(table->convention, convention);
  const model::Robot again = read(written);
  EXPECT_EQ(again.joints.size(), robot.joints.size());
  // Symbols that cancel are no longer there.
  reference::Values values = values_of(robot, random);
  const reference::Chain before = reference::load_text(text, values),
                         after = reference::load_text(written, values);
  std::uniform_real_distribution<double> angles(-3, 3);
  for (int i = 0; i < 5; ++i) {
    Eigen::VectorXd q(before.size());
    for (double& x : q) x = angles(random);
    const auto a = reference::forward_kinematics(before, q), b = reference::forward_kinematics(after, q);
    // The feet of common normals of axes that are nearly parallel are far away.
    double size = 1;
    for (const auto& frame : reference::frames(after, q)) size = std::max(size, frame.translation().norm());
    EXPECT_LT((a.matrix() - b.matrix()).cwiseAbs().maxCoeff(), 2e-14 * size) << text << '\n' << written;
  }
  return written;
}

TEST(DhTable, OfEveryRobot) {
  std::mt19937 random(1);
  int tables = 0, robots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() != ".toml") continue;
    ++robots;
    for (const DhConvention convention : {DhConvention::standard, DhConvention::modified})
      tables += compare(content_of(entry.path()), convention, random).empty() ? 0 : 1;
    if (testing::Test::HasFailure()) FAIL() << entry.path();
  }
  EXPECT_GT(robots, 30);
  EXPECT_EQ(tables, 2 * (robots - 1));  // general_6r has symbols for its twists
}

std::string random_vector(std::mt19937& random, bool symbols, int joint, const char* name) {
  std::string result;
  for (int k = 0; k < 3; ++k) {
    const auto kind = random() % 4;
    const std::string entry = kind == 0 && symbols ? fmt::format("\"{}{}{}\"", name, joint, "xyz"[k])
                              : kind < 2           ? "0"
                                         : fmt::format("{}", static_cast<int>(random() % 2000) * 1e-3 - 1);
    result += (k == 0 ? "" : ", ") + entry;
  }
  return "[" + result + "]";
}

/// Turns by right angles, by degrees, or by decimals of a radian.
std::string random_turns(std::mt19937& random, bool right) {
  std::string result;
  for (auto k = random() % 3; k > 0; --k) {
    const auto kind = right ? 0 : random() % 3;
    const int number = static_cast<int>(random() % 360) - 180;
    const std::string angle = kind == 0   ? fmt::format("\"{} deg\"", 90 * (number / 60))
                              : kind == 1 ? fmt::format("\"{} deg\"", number)
                                          : fmt::format("{}", number * 1e-2);
    result += fmt::format("{}{{ axis = \"{}{}\", angle = {} }}", result.empty() ? "" : ", ",
                          random() % 2 == 0 ? '+' : '-', "xyz"[random() % 3], angle);
  }
  return "[" + result + "]";
}

std::string random_arm(std::mt19937& random, int kind) {
  const bool symbols = kind % 2 == 0, right = kind % 3 == 0;
  const int joints = 1 + static_cast<int>(random() % 7);
  std::string text = "name = \"arm\"\ntitle = \"a random arm\"\n";
  for (const char* frame : {"base", "tool"})
    text += fmt::format("[{}]\ntranslation = {}\nturns = {}\n", frame,
                        random_vector(random, symbols, 0, frame), random_turns(random, right));
  for (int i = 1; i <= joints; ++i) {
    const bool oblique = !right && random() % 4 == 0;
    const std::string axis =
        oblique ? "[\"3/5\", 0, \"-4/5\"]"
                : fmt::format("\"{}{}\"", random() % 2 == 0 ? '+' : '-', "xyz"[random() % 3]);
    text += fmt::format(
        "[[joint]]\ntype = \"{}\"\naxis = {}\nvariable = \"q{}\"\norigin = {}\nturns = {}\nlink = {}\n",
        random() % 4 == 0 ? "prismatic" : "revolute", axis, i, random_vector(random, symbols, i, "o"),
        random_turns(random, right), random_vector(random, symbols, i, "k"));
  }
  return text;
}

TEST(DhTable, OfRandomArms) {
  std::mt19937 random(2);
  for (int i = 0; i < 150 && !testing::Test::HasFailure(); ++i) {
    const std::string text = random_arm(random, i);
    for (const DhConvention convention : {DhConvention::standard, DhConvention::modified})
      EXPECT_FALSE(compare(text, convention, random).empty());
  }
}

/// Four numbers a joint are what it takes: arms without symbols need no further row, and the frame before a
/// standard table is that of the first joint.
TEST(DhTable, NumbersTakeARowAJoint) {
  std::mt19937 random(3);
  for (int i = 1; i < 100; i += 2) {
    const model::Robot robot = read(random_arm(random, i));
    for (const DhConvention convention : {DhConvention::standard, DhConvention::modified})
      EXPECT_EQ(canonical::dh_table(robot, convention)->rows.size(), robot.joints.size());
  }
}

TEST(DhTable, ComesBackAsItWasWritten) {
  const std::string table =
      "name = \"arm\"\ntitle = \"a table\"\ndefaults = { l2 = 0.5 }\nsymbols = [\"d3\"]\nconvention = "
      "\"standard\"\n"
      "\n[[dh]]\nvariable = \"theta1\"\ntheta = \"theta1\"\nd = 0.1\nalpha = \"-90 deg\"\n"
      "\n[[dh]]\nvariable = \"theta2\"\ntheta = \"theta2\"\na = \"l2\"\nlimits = [-2, \"90 deg\"]\n"
      "\n[[dh]]\nvariable = \"theta3\"\ntheta = \"theta3 + 1/2*pi\"\nd = \"d3\"\na = 0.02\nalpha = \"30 "
      "deg\"\n";
  std::mt19937 random(4);
  const std::string written = compare(table, DhConvention::standard, random);
  EXPECT_EQ(written.substr(written.find("name")), table);
}

TEST(DhTable, SymbolsForConstantAnglesHaveNone) {
  const model::Robot robot = read(
      "name = \"arm\"\ntitle = \"a symbol\"\nconvention = \"standard\"\n"
      "[[dh]]\nvariable = \"theta1\"\ntheta = \"theta1\"\nalpha = \"alpha1\"\n");
  EXPECT_FALSE(canonical::dh_table(robot, DhConvention::standard));
}

}  // namespace
}  // namespace qvgen
