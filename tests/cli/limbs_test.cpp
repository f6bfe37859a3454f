// SPDX-License-Identifier: MIT
// Whole robots in commands of chains: each limb is what its own chain is.
#include "command_line.h"

namespace qvgen::test {
namespace {

const std::string quad = QVGEN_SOURCE_DIR "/tests/floating/quad.urdf";
const std::string hopper = QVGEN_SOURCE_DIR "/tests/floating/hopper.toml";
const std::string four_bar = QVGEN_SOURCE_DIR "/tests/loops/robots/four_bar.toml";

TEST_F(CommandLine, ShowsAWholeRobotAsItsTreeAndItsLimbs) {
  const ToolRun shown = run("show " + quad + " --floating");
  EXPECT_EQ(shown.code, 0);
  EXPECT_TRUE(has(shown,
                  "quad: the base moves freely, 12 joints, 4 tips\n"
                  "  fl_hip_joint turns\n"
                  "    fl_thigh_joint turns\n"
                  "      fl_knee_joint turns -> fl_foot\n"
                  "  fr_hip_joint turns\n"))
      << shown.output;
  for (const std::string tip : {"fl_foot", "fr_foot", "hl_foot", "hr_foot"}) {
    const ToolRun limb = run("show " + quad + " --tip " + tip + " --name quad_" + tip);
    ASSERT_EQ(limb.code, 0) << limb.output;
    EXPECT_TRUE(has(shown, "\nquad_" + tip + ":\n" + limb.output)) << tip << "\n" << limb.output;
  }
  EXPECT_TRUE(has(run("show " + quad + " --tips hl_foot,fr_foot"),
                  "quad: the base stands still, 6 joints, 2 tips\n"));
}

/// The coupler's chain has two joints.
TEST_F(CommandLine, SaysThatOneMotorFollowsNoTwoJoints) {
  const ToolRun made = run("generate " + four_bar + " --only inverse,assembly --output " + out());
  EXPECT_TRUE(has(made,
                  "no inverse_kinematics_of_point: 2 joints lead to the tip (crank, coupler), and one motor "
                  "cannot follow them one by one; solve `assemble` for values of the motor"))
      << made.output;
}

TEST_F(CommandLine, ShowsClosedLoopsAsLatex) {
  const ToolRun shown = run("show " + four_bar + " --latex");
  EXPECT_EQ(shown.code, 0);
  for (const std::string part : {"assemble from crank: 2 assemblies at most.", "\\paragraph{",
                                 "\\begin{align*}", "$\\mathrm{joint}_{1}$ is crank", "\\end{align*}"})
    EXPECT_TRUE(has(shown, part)) << part << "\n" << shown.output;
  EXPECT_FALSE(has(shown, "; circle"));
}

TEST_F(CommandLine, SaysWhatClosedLoopsHaveNot) {
  for (const std::string option : {"--inverse", "--singularities", "--jacobian"}) {
    const ToolRun shown = run("show " + four_bar + " " + option);
    EXPECT_EQ(shown.code, 1);
    EXPECT_TRUE(has(shown, "four_bar has closed loops, and " + option + " is of arms")) << shown.output;
  }
}

TEST_F(CommandLine, ShowsWhatALimbHasNot) {
  const ToolRun shown = run("show " + hopper + " --workspace");
  EXPECT_EQ(shown.code, 1);
  EXPECT_TRUE(has(shown, "hopper_foot has no workspace in closed form"));
  EXPECT_TRUE(has(shown, "hopper_end has no workspace in closed form"));
  const ToolRun forces = run("show " + hopper + " --dynamics");
  EXPECT_EQ(forces.code, 1);
  EXPECT_TRUE(has(forces, "joint forces of a limb alone are not the robot's: name a chain, --tip foot"));
}

TEST_F(CommandLine, ComparesFormulationsOfLimbs) {
  const ToolRun whole = run("compare " + quad + " --tips all --what jacobian --format csv");
  EXPECT_EQ(whole.code, 0) << whole.output;
  const ToolRun limb =
      run("compare " + quad + " --tip hl_foot --name quad_hl_foot --what jacobian --format csv");
  ASSERT_EQ(limb.code, 0) << limb.output;
  EXPECT_TRUE(has(whole, limb.output.substr(limb.output.find('\n') + 1))) << whole.output << limb.output;
  EXPECT_TRUE(
      has(run("compare " + hopper + " --what dynamics"), "hopper_foot: it has no inertia, so no dynamics"));
}

TEST_F(CommandLine, MakesAPageOfTheWholeAndOfEachLimb) {
  const std::string pages = (folder / "pages").string();
  const ToolRun made = run("report " + hopper + " -o " + pages);
  EXPECT_EQ(made.code, 0) << made.output;
  EXPECT_TRUE(has(made, "3 pages in")) << made.output;
  for (const char* page : {"hopper_foot.html", "hopper_end.html", "index.html"})
    EXPECT_TRUE(fs::exists(folder / "pages" / page)) << page;
  std::ifstream file(folder / "pages/hopper.html");
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  for (const std::string part :
       {"<svg", "hopper: the base moves freely, 3 joints, 2 tips\n  hip turns\n    shin slides",
        "href=\"hopper_foot.html\"", "href=\"hopper_end.html\"", "3 joints, 2 limbs."})
    EXPECT_NE(whole.find(part), std::string::npos) << part;
  // Each joint is drawn once: two turns and a slide, with a frame at either tip.
  const auto count = [&](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = whole.find(text, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("class=\"turn\""), 2U);
  EXPECT_EQ(count("class=\"slide\""), 1U);
  EXPECT_EQ(count("class=\"tool-x\""), 2U);
  EXPECT_TRUE(has(run("report " + hopper + " -o " + pages), "0 made, 0 files changed"));
}

TEST_F(CommandLine, ClosedLoopsAreNoLimbs) {
  const ToolRun refused = run("compare " + four_bar);
  EXPECT_EQ(refused.code, 3) << refused.output;
  EXPECT_TRUE(has(refused, "this command takes joints that all are free, and the robot has closed loops"));
}

TEST_F(CommandLine, ReportsMakeAPageOfClosedLoops) {
  const std::string pages = (folder / "pages").string();
  EXPECT_EQ(run("report " + four_bar + " -o " + pages).code, 0);
  EXPECT_TRUE(fs::exists(pages + "/index.html"));
  EXPECT_TRUE(has(run("report " + four_bar + " -o " + pages), "0 made, 0 files changed"));
}

}  // namespace
}  // namespace qvgen::test
