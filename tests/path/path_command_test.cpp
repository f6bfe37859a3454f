// SPDX-License-Identifier: MIT
// `qvgen path` as its users meet it: a path that an arm was seen to follow is followed, files hold what the
// table says, and bad input gets an answer and leaves nothing.
#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <vector>

#include "command_line.h"

namespace qvgen::test {
namespace {

constexpr const char* header = "x [mm],y [mm],z [mm],roll [deg],pitch [deg],yaw [deg],t [s]\n";

/// A seam before a UR5; `far` makes it leave the reach.
std::string seam(double far) {
  std::ostringstream text;
  text << header;
  for (int i = 0; i <= 40; ++i) {
    const double u = i / 40.0;
    text << 400 + far * u << "," << -300 + 500 * u << "," << 250 + 100 * std::sin(3 * u) << ",180," << 20 * u
         << "," << 30 * u << "," << 0.1 * i << "\n";
  }
  return text.str();
}

class PathCommand : public CommandLine {
 protected:
  [[nodiscard]] ToolRun follow(const std::string& arguments) {
    return run_in(folder, "path " + arguments, QVGEN_TOOL);
  }
  std::string read(const std::string& name) {
    std::ifstream stream(folder / name);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
};

TEST_F(PathCommand, AReachablePathIsFollowedAllTheWay) {
  write("seam.csv", seam(100));
  const ToolRun result = follow("ur5 seam.csv -o motions.csv -o motions.json -o motions.svg -o motions.html");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(has(result, "ur5: 41 poses")) << result.output;
  EXPECT_TRUE(has(result, "joints that follow the whole path from its start")) << result.output;
  EXPECT_EQ(read("motions.csv").rfind("motion,s,t [s],theta1 [rad],", 0), 0U);
  EXPECT_NE(read("motions.csv").find("\n1,40,4,"), std::string::npos);
  EXPECT_NE(read("motions.json").find("\"robot\": \"ur5\""), std::string::npos);
  EXPECT_NE(read("motions.svg").find("<polyline"), std::string::npos);
  EXPECT_NE(read("motions.html").find("id=\"path-data\""), std::string::npos);
}

TEST_F(PathCommand, APathThatLeavesTheReachEndsThere) {
  write("seam.csv", seam(900));
  const ToolRun result = follow("ur5 seam.csv");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(has(result, "boundary of reach")) << result.output;
  EXPECT_TRUE(has(result, "nothing follows the path from")) << result.output;
}

TEST_F(PathCommand, LimitsCutMotions) {
  write("seam.csv", seam(100));
  const ToolRun result = follow("ur5 seam.csv --limit theta1=-30:30deg");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(has(result, "theta1 at its")) << result.output;
}

/// A path along x with quaternions; `row` may change or repeat a line.
std::string line_of_poses(const std::function<std::string(int, const std::string&)>& row) {
  std::string text = "x [m],y [m],z [m],qw,qx,qy,qz\n";
  for (int i = 0; i <= 30; ++i) text += row(i, std::to_string(0.4 + 0.003 * i) + ",-0.2,0.25,");
  return text;
}

TEST_F(PathCommand, OddPathsAreFollowedOrRefused) {
  const auto plain = [](int, const std::string& place) { return place + "0,1,0,0\n"; };
  write("plain.csv", line_of_poses(plain));
  write("signs.csv", line_of_poses([](int i, const std::string& place) {
          return place + (i % 2 == 0 ? "0,1,0,0\n" : "0,-1,0,0\n");
        }));
  write("twice.csv", line_of_poses([](int i, const std::string& place) {
          return (i % 3 == 0 ? place + "0,1,0,0\n" : "") + place + "0,1,0,0\n";
        }));
  write("jump.csv", line_of_poses([](int i, const std::string& place) {
          return i == 20 ? "0.3,0.3,0.4,0,1,0,0\n" : place + "0,1,0,0\n";
        }));
  const auto motions = [](const ToolRun& run) {
    return run.output.substr(run.output.find(" m; "), run.output.find("motions,") - run.output.find(" m; "));
  };
  const ToolRun reference = follow("ur5 plain.csv"), signs = follow("ur5 signs.csv"),
                twice = follow("ur5 twice.csv"), jump = follow("ur5 jump.csv");
  ASSERT_EQ(reference.code, 0) << reference.output;
  EXPECT_EQ(signs.output, reference.output);
  EXPECT_EQ(twice.code, 0);
  EXPECT_TRUE(has(twice, "the pose before once more")) << twice.output;
  EXPECT_EQ(motions(twice), motions(reference));
  EXPECT_EQ(jump.code, 0);
  EXPECT_TRUE(has(jump, "the tool goes there in a straight line")) << jump.output;
  write("mm.csv", "x,y,z,qw,qx,qy,qz\n400,-200,250,0,1,0,0\n410,-200,250,0,1,0,0\n");
  write("order.csv", "x,y,z,qw,qx,qy,qz,t\n0.4,0,0.2,0,1,0,0,2\n0.4,0.01,0.2,0,1,0,0,1\n");
  EXPECT_TRUE(has(follow("ur5 mm.csv"), "if these are millimetres"));
  EXPECT_TRUE(has(follow("ur5 order.csv"), "is not behind"));
}

/// Times rise along each motion, and no mean speed of a joint is above the one that is allowed.
TEST_F(PathCommand, LeastTimesKeepTheSpeeds) {
  write("seam.csv", seam(100));
  const ToolRun result = follow("ur5 seam.csv --time 6 --joint-speeds 1.5 -o motions.csv");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(has(result, "the fastest along the whole path is motion")) << result.output;
  std::istringstream rows(read("motions.csv"));
  std::string line;
  std::getline(rows, line);
  EXPECT_EQ(line.rfind("motion,s,t [s],theta1 [rad],", 0), 0U);
  std::vector<double> before;
  int compared = 0;
  while (std::getline(rows, line)) {
    std::vector<double> row;
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');) row.push_back(std::strtod(word.c_str(), nullptr));
    ASSERT_EQ(row.size(), 9U);
    if (!before.empty() && before[0] == row[0]) {
      ASSERT_GT(row[2], before[2]);
      for (std::size_t k = 3; k < 9; ++k)
        EXPECT_LE(std::abs(row[k] - before[k]), 1.5 * (row[2] - before[2]) * (1 + 1e-9));
      ++compared;
    }
    before = row;
  }
  EXPECT_GT(compared, 30);
}

TEST_F(PathCommand, JerksSlowTheMotionDown) {
  write("seam.csv", seam(100));
  const auto seconds = [&](const std::string& more) {
    const ToolRun result = follow("ur5 seam.csv --time 6 --joint-speeds 1.5" + more);
    EXPECT_EQ(result.code, 0) << result.output;
    const std::size_t place = result.output.find("the fastest along the whole path is motion");
    return place == std::string::npos
               ? -1
               : std::strtod(result.output.c_str() + result.output.find(": ", place) + 2, nullptr);
  };
  const double without = seconds("");
  EXPECT_GT(seconds(" --joint-jerks 60"), 1.001 * without);
  EXPECT_LT(seconds(" --joint-jerks 60"), 1.5 * without);
  EXPECT_GT(seconds(" --joint-jerks 5"), 1.5 * without);
}

/// Compiles a program of its own: with QVGEN_PROOFS.
TEST_F(PathCommand, TorquesLimitTheLeastTime) {
  if (std::getenv("QVGEN_PROOFS") == nullptr) GTEST_SKIP() << "QVGEN_PROOFS=1 compiles the program";
  write("seam.csv", seam(100));
  const auto seconds = [&](const std::string& torques) {
    const ToolRun result = follow("puma560 seam.csv --time inf --joint-speeds 3 --joint-torques " + torques);
    EXPECT_EQ(result.code, 0) << result.output;
    const std::size_t place = result.output.find("the fastest along the whole path is motion");
    return place == std::string::npos
               ? -1
               : std::strtod(result.output.c_str() + result.output.find(": ", place) + 2, nullptr);
  };
  EXPECT_GT(seconds("80,80,40,5,5,1"), seconds("800,800,400,50,50,10") + 0.01);
  const ToolRun result = follow("puma560 seam.csv --time 6 --joint-torques 60,3,60,5,5,1");
  EXPECT_TRUE(has(result, "none: theta2 bears ")) << result.output;
  EXPECT_TRUE(has(result, " of 3 N m at rest at ")) << result.output;
}

TEST_F(PathCommand, SplinesAndBlendsAreFollowed) {
  write("seam.csv", seam(100));
  for (const std::string way : {"--spline", "--blend 0.005"}) {
    const ToolRun result = follow("ur5 seam.csv " + way);
    ASSERT_EQ(result.code, 0) << result.output;
    EXPECT_TRUE(has(result, "joints that follow the whole path from its start")) << result.output;
  }
}

/// Compiles a program of its own: with QVGEN_PROOFS.
/// Motors move the joints: files and limits are in motors, and a joint with limits of its own keeps them.
TEST_F(PathCommand, MotorsFollowPaths) {
  write("seam.csv", seam(60));
  const std::string arm = QVGEN_MOTOR_ARMS "/bevel_arm.toml seam.csv ";
  const ToolRun result = follow(arm +
                                "--limit tilt=-40:40deg --joint-speeds 0.4 --time 3 -o motions.csv "
                                "-o motions.svg -o motions.html");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(has(result, "tilt at its")) << result.output;
  std::istringstream csv(read("motions.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "motion,s,t [s],theta1 [rad],theta2 [rad],m3 [rad],theta4 [rad],ml [rad],mr [rad]");
  std::vector<double> last;
  double fastest = 0;
  while (std::getline(csv, line)) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    ASSERT_EQ(row.size(), 9U);
    EXPECT_LE(std::abs(0.5 * (row[7] - row[8])), 40 * M_PI / 180 + 1e-9);
    for (std::size_t i = 3; !last.empty() && last[0] == row[0] && i < 9; ++i)
      fastest = std::max(fastest, std::abs(row[i] - last[i]) / (row[2] - last[2]));
    last = row;
  }
  EXPECT_LE(fastest, 0.4 + 1e-6);
  EXPECT_GT(fastest, 0.39);
  EXPECT_NE(read("motions.html").find("id=\"path-data\""), std::string::npos);
  const ToolRun free = follow(arm + "--free tool_z"), wrong = follow(arm + "--limit roll=0:1");
  EXPECT_TRUE(free.code != 0 && has(free, "--free is for arms without")) << free.output;
  EXPECT_TRUE(wrong.code != 0 && has(wrong, "there is no joint")) << wrong.output;
}

TEST_F(PathCommand, AFreeCoordinateIsDrawn) {
  if (std::getenv("QVGEN_PROOFS") == nullptr) GTEST_SKIP() << "QVGEN_PROOFS=1 compiles the program";
  write("seam.csv", seam(900));
  const ToolRun result = follow(
      "ur5 seam.csv --free rail_x --range 0:1 -o motion.csv -o motion.json -o motion.svg -o motion.html");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(has(result, "the motion follows the whole path")) << result.output;
  EXPECT_EQ(read("motion.csv").rfind("s,t [s],free rail_x [m],theta1 [rad],", 0), 0U);
  EXPECT_NE(read("motion.json").find("\"free\": ["), std::string::npos);
  EXPECT_NE(read("motion.svg").find(">rail_x<"), std::string::npos);
  EXPECT_NE(read("motion.html").find("\"way\":[[0"), std::string::npos);
  // Tolerances of six joints use one program.
  const ToolRun cone = follow("ur5 seam.csv --free cone_z=10deg,shift_x=2mm -o motion.csv -o motion.svg");
  EXPECT_EQ(cone.code, 1) << cone.output;
  EXPECT_TRUE(has(cone, "no motion was found that goes farther than")) << cone.output;
  EXPECT_EQ(read("motion.csv").rfind("s,t [s],free cone_z_x [rad],free cone_z_y [rad],free shift_x [m],", 0),
            0U);
  EXPECT_NE(read("motion.svg").find(">cone_z_y<"), std::string::npos);
  write("far.csv", std::string(header) + "4000,0,250,180,0,0,0\n4000,10,250,180,0,0,1\n");
  const ToolRun far = follow("ur5 far.csv --free cone_z=10deg -o motion.json -o motion.svg");
  EXPECT_EQ(far.code, 1) << far.output;
  EXPECT_TRUE(has(far, "nothing reaches the first pose")) << far.output;
}

/// Compiles a program of its own, half a minute: with QVGEN_PROOFS.
TEST_F(PathCommand, AProofIsReported) {
  if (std::getenv("QVGEN_PROOFS") == nullptr) GTEST_SKIP() << "QVGEN_PROOFS=1 compiles the program of proofs";
  write("seam.csv", seam(900));
  for (const std::string way : {"", " --spline", " --blend 0.005"}) {
    const ToolRun result = follow("ur5 seam.csv --prove" + way);
    ASSERT_EQ(result.code, 0) << result.output;
    EXPECT_TRUE(has(result, "the only motion in a tube around it")) << result.output;
    EXPECT_TRUE(has(result, "proven but from")) << result.output;  // at the boundary of reach
    EXPECT_TRUE(has(result, "no other motion follows the path, whatever the limits: proven"))
        << result.output;
  }
}

/// The proof is of joints, and a path of motors has it.
TEST_F(PathCommand, MotorsHaveProofs) {
  if (std::getenv("QVGEN_PROOFS") == nullptr) GTEST_SKIP() << "QVGEN_PROOFS=1 compiles the program of proofs";
  write("seam.csv", seam(60));
  const ToolRun result = follow(QVGEN_MOTOR_ARMS "/bevel_arm.toml seam.csv --prove");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(has(result, "the only motion in a tube around it")) << result.output;
  EXPECT_TRUE(has(result, "no other motion follows the path, whatever the limits: proven")) << result.output;
}

TEST_F(PathCommand, BadInputGetsAnAnswer) {
  write("nan.csv", std::string(header) + "400,0,250,180,0,0,0\n400,nan,250,180,0,0,1\n");
  write("good.csv", std::string(header) + "400,0,250,180,0,0,0\n400,10,250,180,0,0,1\n");
  const auto expect = [&](const std::string& arguments, int code, const std::string& words) {
    const ToolRun result = follow(arguments);
    EXPECT_EQ(result.code, code) << arguments << "\n" << result.output;
    EXPECT_TRUE(has(result, words)) << result.output;
  };
  expect("ur5 nan.csv -o out.csv", 1, "nan.csv:3");
  expect("ur5 none.csv", 1, "none.csv");
  expect("ur5 good.csv -o out.txt", 2, ".csv, .json, .svg or .html");
  expect("ur5 good.csv --limit theta9=0:1", 2, "there is no joint");
  expect("ur5 good.csv --limit theta1=1:0", 2, "above the upper one");
  expect("scara good.csv", 1, "six");
  expect("iiwa14 good.csv", 1, "--hold");
  expect("ur5 good.csv --time 1,2", 2, "one for each of 6 joints");
  expect("ur5 good.csv --time 0", 2, "--time");
  expect("ur5 good.csv --joint-speeds 1", 2, "--time");
  expect("ur5 good.csv --joint-torques 1", 2, "--time");
  expect("ur5 good.csv --joint-jerks 1", 2, "--time");
  expect("ur5 good.csv --time 6 --joint-jerks 1,2", 2, "one for each of 6 joints");
  expect("ur5 good.csv --time 6 --joint-jerks 9 --joint-torques 9", 2, "--joint-jerks");
  expect("ur5 good.csv --time 6 --joint-torques 1,2", 2, "one for each of 6 joints");
  expect("ur5 good.csv --time 6 --joint-torques -1", 2, "above zero");
  expect("ur5 good.csv --time 6 --joint-torques 100", 1, "no value for m1");
  expect("crx10ia good.csv --time 6 --joint-torques 100", 1, "no masses");
  expect("puma560 good.csv --time 6 --joint-torques description", 1, "no effort limits");
  expect("ur5 good.csv --prove --free tool_z", 2, "--free");
  expect("ur5 good.csv --spline --blend 0.1", 2, "--blend");
  expect("ur5 good.csv --free tool_z --range 1:0", 2, "above the upper one");
  expect("ur5 good.csv --free cone_z -o out.csv", 2, "its tolerance is missing, cone_z=15deg");
  expect("ur5 good.csv --free cone_z=15", 2, "degrees are 15deg");
  expect("ur5 good.csv --free cone_z=nan", 2, "is no number");
  expect("ur5 good.csv --free cone_z=5deg,tool_x", 2, "leave that out");
  expect("ur5 good.csv --free shift_x=2:1mm", 2, "above the upper one");
  expect("ur5 good.csv --free shift_x=5", 2, "millimetres are 2mm");
  expect("ur5 good.csv --free shift_x=5deg", 2, "a length in degrees");
  expect("ur5 good.csv --free tool_z,tool_z", 2, "named twice");
  expect("ur5 good.csv --free cone_z=5deg,tool_z --range 0:1", 2, "one free coordinate");
  expect("iiwa14 good.csv --free cone_z=5deg", 1, "name a joint or arm_angle");
  EXPECT_FALSE(fs::exists(folder / "out.csv"));
  EXPECT_FALSE(fs::exists(folder / "out.csv.new"));
}

}  // namespace
}  // namespace qvgen::test
