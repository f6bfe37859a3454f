// SPDX-License-Identifier: MIT
// What the tool prints of robots, and whether the documents show the same.
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

#include "command_line.h"

namespace qvgen::test {
namespace {

TEST_F(CommandLine, SaysWhichFunctionsThereAre) {
  const std::string file = write("my_arm.toml", good_arm);
  EXPECT_EQ(run("show my_arm --functions --output " + out()).code, 1);
  EXPECT_EQ(run("generate " + file + " --only kinematics,dynamics --output " + out()).code, 0);
  const ToolRun shown = run("show " + file + " --functions --output " + out());
  EXPECT_EQ(shown.code, 0);
  EXPECT_TRUE(
      has(shown, "forward_kinematics\nhomogeneous_transform\nno dynamics: the description gives no mass"))
      << shown.output;
}

TEST_F(CommandLine, NamesFunctionsWithoutCountsToo) {
  const std::string rest = " --functions --output " QVGEN_SOURCE_DIR "/generated";
  EXPECT_TRUE(has(run("show crx10ia" + rest), "\ninverse_kinematics\ninverse_kinematics_near\n"));
  EXPECT_TRUE(has(run("show iiwa14" + rest), "\ninverse_kinematics_near_given_theta3\n"));
  EXPECT_TRUE(has(run("show iiwa14" + rest), "\ninverse_kinematics_arm_angle\n"));
  EXPECT_TRUE(has(run("show scara" + rest), "\ninverse_kinematics_near\n"));
}

TEST_F(CommandLine, AFolderWithARobotsNameHidesNoRobot) {
  fs::create_directories(folder / "ns");
  fs::create_directories(folder / "nss");
  EXPECT_EQ(run_in(folder, "show ns").code, 0);
  EXPECT_TRUE(has(run_in(folder, "show nss"), "'nss' is a folder; name the files in it"));
  EXPECT_TRUE(has(run_in(folder, "show nso"), "there is no file and no known robot 'nso'"));
}

/// A tool that was copied to another place finds no robots there, but works with files.
TEST_F(CommandLine, AToolWithoutItsRobotsSaysWhereItLooks) {
  fs::copy_file(QVGEN_TOOL, folder / "tool");
  write("my_arm.toml", good_arm);
  EXPECT_EQ(run_in(folder, "check my_arm.toml", "./tool").code, 0);
  for (const char* command : {"list", "generate", "check ur5", "show ur5"}) {
    const ToolRun refused = run_in(folder, command, "./tool");
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_TRUE(has(refused, "/share/qvgen/robots, where this tool looks for them")) << refused.output;
  }
}

TEST_F(CommandLine, ShowsTheClosedForm) {
  const ToolRun text = run("show ss");
  EXPECT_EQ(text.code, 0);
  EXPECT_TRUE(has(text, "w = cos((theta4 + theta6)/2)*cos(theta5/2)")) << text.output;
  const ToolRun latex = run("show ss --latex");
  EXPECT_TRUE(has(latex, "\\begin{align*}"));
  EXPECT_TRUE(has(latex, "\\bar{\\theta_{4}}+\\bar{\\theta_{6}}")) << latex.output;
  EXPECT_EQ(run("show general_6r").code, 1);
}

TEST_F(CommandLine, ShowsTheDerivationOfTheInverseKinematics) {
  const ToolRun text = run("show ns --inverse");
  EXPECT_EQ(text.code, 0);
  EXPECT_TRUE(has(text, "at most 8 solutions"));
  EXPECT_TRUE(has(text, "rho1 = sqrt(p_y^2 + p_x^2)\n"));
  EXPECT_TRUE(has(text, "N_31 = N_21*cos(theta2/2) - N_23*sin(theta2/2)"));
  EXPECT_TRUE(has(text, "theta4 = arg u + arg v"));
  const ToolRun latex = run("show ns --inverse --latex");
  EXPECT_TRUE(has(latex, "M_i &= Q_i Q_{i+1} \\dots Q_{6} = N_i"));
  EXPECT_TRUE(has(latex, "\\paragraph{$d_{3}$: foot of the perpendicular and square root, 2 values.}"));
  const ToolRun puma = run("show puma560 --inverse");
  EXPECT_TRUE(has(puma, "    |middle - 1/2| > 1/2\n")) << puma.output;
  EXPECT_FALSE(has(puma, "swing"));
  const ToolRun iiwa = run("show iiwa14 --inverse");
  EXPECT_TRUE(has(iiwa, "goal_z = p_z - 0.126*(1 - 2*")) << iiwa.output;
  EXPECT_TRUE(has(iiwa, "M_i = Q_i Q_i+1 ... Q_7")) << "the given joint is one of them";
  EXPECT_FALSE(has(iiwa, "pose_")) << iiwa.output;
  EXPECT_FALSE(has(text, "Out of reach"));  // a slide reaches everything
  EXPECT_TRUE(has(run("show irb6640 --inverse"), "Out of reach, before any branch: no theta3"));
  EXPECT_TRUE(has(run("show general_6r --inverse"), "At most 16 solutions, by elimination."));
  const ToolRun none = run("show " + write("eight.toml", eight_joints()) + " --inverse");
  EXPECT_EQ(none.code, 1);
  EXPECT_TRUE(has(none, "8 joints: a pose in space fixes six")) << none.output;
}

TEST_F(CommandLine, ShowsTheEliminationOfAMeasuredArm) {
  const ToolRun result = run("show --inverse " + write("measured.toml", measured_arm));
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result, "\nsix joints of any geometry: elimination")) << result.output;
  EXPECT_TRUE(has(result, "_joint dropped")) << result.output;
}

TEST_F(CommandLine, SaysHowADerivationCallsTheJoints) {
  std::string text = good_arm;
  text.replace(text.find("\"theta2\""), 8, "\"elbow_joint\"");
  const ToolRun result = run("show --inverse " + write("my_arm.toml", text));
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result, "below, joint2 stands for elbow_joint")) << result.output;
  EXPECT_FALSE(has(result, "no inverse kinematics")) << "of an arm that has one\n" << result.output;
}

TEST_F(CommandLine, ShowsTheFactorsOfTheDeterminant) {
  const ToolRun two_links = run("show " + write("my_arm.toml", good_arm) + " --singularities");
  EXPECT_EQ(two_links.code, 0);
  EXPECT_TRUE(has(two_links, "vx, vy of the Jacobian = l1*l2 f1")) << two_links.output;
  EXPECT_TRUE(has(two_links, "elbow: f1 = sin(theta2) = 0")) << two_links.output;
  const ToolRun puma = run("show puma560 --singularities");
  for (const char* name : {"spherical wrist", "shoulder: f1", "elbow: f2", "wrist: f3 = sin(theta5)"})
    EXPECT_TRUE(has(puma, name)) << puma.output;
  EXPECT_TRUE(has(run("show stanford --singularities"), "inner boundary: f2 = d3 = 0"));
}

// The lecture's matrices of example 5.4.
TEST_F(CommandLine, ShowsTheTransformsOfTheLinks) {
  const ToolRun text = run("show rpp --transform");
  EXPECT_EQ(text.code, 0);
  EXPECT_TRUE(has(text, "A_3 =\n  [ 1  0  0   l1  ]\n  [ 0  0  -1  -d3 ]\n  [ 0  1  0   0   ]"))
      << text.output;
  EXPECT_TRUE(has(text, "T = A_1 A_2 A_3\nr_11 = cos(theta1)\n"));
  EXPECT_TRUE(has(text, "p_x = l1*cos(theta1) + d3*sin(theta1)\np_y = l1*sin(theta1) - d3*cos(theta1)"));
  const ToolRun latex = run("show rpp --transform --latex");
  EXPECT_TRUE(has(latex, "\\[A_{3} = \\begin{bmatrix}\n1 & 0 & 0 & l_{1} \\\\")) << latex.output;
  EXPECT_TRUE(has(latex,
                  "\\[T = A_{1} A_{2} A_{3}\\]\n\\allowdisplaybreaks\n\\begin{align*}\nr_{11} &= "
                  "\\cos(\\theta_{1}) \\\\"));
  EXPECT_TRUE(has(run("show poe_6r --transform"), "A_tool =")) << "frames parallel to the base's need one";
  EXPECT_TRUE(has(run("show ur5 --transform"), "cos(theta2 + theta3 + theta4)"));
}

TEST_F(CommandLine, ShowsTheJacobian) {
  EXPECT_TRUE(has(run("show rpp --jacobian"), "\nv_2 = [ 0, 0, d2' ]\n"));
  EXPECT_TRUE(
      has(run("show rpp --jacobian --latex"), "\\[v_{2} = \\begin{bmatrix}\n0 \\\\\n0 \\\\\n\\dot{d_{2}}"));
}

TEST_F(CommandLine, ShowsTheDynamicsOfTheFirstJoints) {
  const ToolRun whole = run("show nn --dynamics");
  EXPECT_EQ(whole.code, 1);
  EXPECT_TRUE(has(whole, "--joints 3 has its first three")) << whole.output;
  const ToolRun part = run("show ns --dynamics --joints 3 --masses end");
  EXPECT_EQ(part.code, 0);
  EXPECT_TRUE(has(part, "tau3 = - [d2*m3*sin(theta2)] theta1''")) << part.output;
  EXPECT_TRUE(has(run("show ns --dynamics --joints 3 --masses end --latex"), "\\ddot{\\theta_{1}} \\\\\n"));
  EXPECT_TRUE(has(run("show ns --dynamics --joints 7"), "ns has 6 joints"));
  EXPECT_TRUE(has(run("show puma560 --exact"), "2159/5000"));
}

TEST_F(CommandLine, ShowsTheWorkspace) {
  EXPECT_TRUE(has(run("show rrr --workspace"), "\nreach from the origin of joint 1: 0.2 to 1.217 m\n"));
  const ToolRun none = run("show ur5 --workspace");
  EXPECT_EQ(none.code, 1);
  EXPECT_TRUE(has(none, "ur5 has no workspace in closed form: its last three axes do not meet"))
      << none.output;
}

TEST_F(CommandLine, ShowsFactorsAloneWhereATwistIsASymbol) {
  const ToolRun shown = run("show general_6r --transform");
  EXPECT_EQ(shown.code, 0);
  EXPECT_TRUE(has(shown, "  -sin(alpha6)  -d6*sin(alpha6) ]\n")) << shown.output;
  EXPECT_TRUE(has(shown, "T = A_1 A_2 A_3 A_4 A_5 A_6\n"));
  EXPECT_FALSE(has(shown, "r_11"));
}

TEST_F(CommandLine, PrintsWhatTheReadmeShows) {
  std::ifstream file(std::string(QVGEN_SOURCE_DIR) + "/runtime/docs/jacobians.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  const ToolRun shown = run("show puma560 --singularities");
  EXPECT_NE(readme.find("```\n" + shown.output + "```"), std::string::npos) << shown.output;
}

/// Words of a line, one space between them.
std::string words(const std::string& line) {
  std::istringstream stream(line);
  std::string all;
  for (std::string word; stream >> word;) all += word + " ";
  return all;
}

TEST_F(CommandLine, CountsAreThoseOfTheReadme) {
  const ToolRun counts = run("counts");
  std::map<std::string, std::string> lines;  // "robot function" -> line
  std::istringstream output(counts.output);
  for (std::string line; std::getline(output, line);) {
    std::istringstream stream(line);
    std::string robot, function;
    if (line.find("  ") != std::string::npos && stream >> robot >> function)
      lines[robot + " " + function] = words(line);
  }
  // Each with the lines that it has at least: a document whose table is not recognised would pass unread.
  const std::map<std::string, int> documents{
      {"README.md", 5}, {"runtime/docs/jacobians.md", 20}, {"generator/README.md", 20}};
  for (const auto& [document, at_least] : documents) {
    std::ifstream readme(std::string(QVGEN_SOURCE_DIR) + "/" + document);
    int found = 0;
    for (std::string line; std::getline(readme, line);) {
      std::istringstream stream(line);
      std::string robot, function;
      stream >> robot >> function;
      const auto known = lines.find(robot + " " + function);
      if (known == lines.end()) continue;
      ++found;
      EXPECT_EQ(words(line), known->second) << document;
    }
    EXPECT_GE(found, at_least) << document;
  }
}

TEST_F(CommandLine, SaysWhatHappensWhereAFactorVanishes) {
  const std::map<std::string, std::vector<std::string>> expected{
      {"rr_planar",
       {"theta2 = 0, arm stretched: workspace boundary; theta2 = pi, arm folded: inner boundary"}},
      {"irb6640", {"the wrist centre on the axis of joint 1", "the axes of joints 4 and 6 in line"}},
      {"puma560", {"the wrist centre in the plane of the axes of joints 1 and 2"}},
      {"rx90", {"theta3 = pi/2, arm folded", "theta3 = -pi/2, arm stretched"}},
      {"rr",
       {"workspace boundary: f2 = cos(theta3) = 0 (joint 3 moves the wrist centre along the slide of joint "
        "2)"}},
      {"rn", {"workspace boundary: f2 = sin(theta3) = 0 (the wrist centre as far along"}},
      {"ur5",
       {"the axes of joints 2, 3 and 4 in one plane; theta3 = 0, arm stretched",
        "the axes of joints 4 and 6 parallel"}}};
  for (const auto& [robot, texts] : expected) {
    const ToolRun shown = run("show " + robot + " --singularities");
    for (const std::string& text : texts) EXPECT_TRUE(has(shown, text)) << text << "\n" << shown.output;
  }
}

}  // namespace
}  // namespace qvgen::test
