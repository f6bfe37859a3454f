// SPDX-License-Identifier: MIT
// Arms of strangers: axes of any direction, more joints than usual.
#include <gtest/gtest.h>

#include "description/reader.h"
#include "pipeline/pipeline.h"
#include "report/formula_sections.h"
#include "report/live_functions.h"

namespace {

using namespace qvgen;
using namespace qvgen::report;

/// One turn about each axis, offsets between them.
model::Robot arm_of(const std::vector<std::string>& axes) {
  std::string text = "name = \"arm\"\ntitle = \"of a stranger\"\n";
  for (std::size_t i = 0; i < axes.size(); ++i)
    text += "[[joint]]\nvariable = \"theta" + std::to_string(i + 1) +
            "\"\ntype = \"revolute\"\naxis = " + axes[i] + "\norigin = [0.1, 0.2, 0." +
            std::to_string(i + 1) + "]\nlink = [0.3, 0, 0.1]\n";
  return *description::read_text(text, "arm.toml").robot;
}

const std::string a = R"([0, "3/5", "4/5"])", b = R"(["4/5", 0, "3/5"])", c = R"(["2/3", "2/3", "1/3"])";
const std::string x = R"("+x")", y = R"("+y")", z = R"("+z")";

TEST(FormulaSections, ClosedFormsThatNobodyReadsAreLeftOut) {
  EXPECT_NE(forward_section(arm_of({a, b, c})).html.find("<math"), std::string::npos);
  const std::string html = forward_section(arm_of({a, b, c, a, b, c})).html;
  EXPECT_EQ(html.find("<math"), std::string::npos);
  EXPECT_NE(html.find("too long to be read"), std::string::npos);
}

TEST(LiveFunctions, AreThoseThatAreGeneratedInCppAlone) {
  const auto functions = [](const model::Robot& robot, bool in_c) {
    return cpp_functions(robot, in_c, nullptr);
  };
  EXPECT_FALSE(functions(arm_of({z, y, z, y, z, y}), true).wanted());
  EXPECT_FALSE(functions(arm_of({x, y, z, y, x, z, y}), true).has_arm_angle) << "no spherical shoulder";
  const model::Robot iiwa =
      *description::read_file(QVGEN_SOURCE_DIR "/generator/robots/iiwa14.toml", {}).robot;
  const CppFunctions by_angle = functions(iiwa, true);
  EXPECT_TRUE(by_angle.has_arm_angle);
  EXPECT_FALSE(by_angle.module.done) << "there is nothing to compile it with";
  EXPECT_FALSE(by_angle.module.reason.empty());
  const model::Robot general =
      *description::read_file(QVGEN_SOURCE_DIR "/generator/robots/crx10ia.toml", {}).robot;
  EXPECT_EQ(functions(general, false).inverse.function, "inverse_kinematics");
}

/// The definition of a function in a robot's C source; empty if it has none.
std::string definition_in(const pipeline::RobotOutput& output, const std::string& function) {
  for (const pipeline::OutputFile& file : output.files) {
    const std::size_t at = file.content.find("void " + function + "(");
    if (file.path.ends_with(".c") && at != std::string::npos)
      return file.content.substr(at, file.content.find("\n}\n", at) - at);
  }
  return "";
}

TEST(LiveFunctions, OfAPageAreTheGeneratedOnes) {
  const model::Robot scara =
      *description::read_file(QVGEN_SOURCE_DIR "/generator/robots/scara.toml", {}).robot;
  const auto whole =
      pipeline::generate({scara}, {"kinematics", "jacobian"}, {}, {}, pipeline::Language::c).front();
  const auto page = pipeline::generate_page_functions(scara);
  for (const char* function : {"scara_forward_kinematics", "scara_jacobian", "scara_singularity_measures"}) {
    EXPECT_NE(definition_in(page, function), "");
    EXPECT_EQ(definition_in(page, function), definition_in(whole, function));
  }
  EXPECT_EQ(definition_in(page, "scara_velocity"), "");
  EXPECT_EQ(page.counts.at("measures").size(), 1U);
}

}  // namespace
