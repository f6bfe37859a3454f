// SPDX-License-Identifier: MIT
// `qvgen map` as its users meet it, on an arm of the library that is given joint limits. The maps are
// compared with a plain loop over the library's single calls; file formats and orientations are read and made
// here.
#include <cstring>
#include <map>
#include <numbers>
#include <sstream>
#include <vector>

#include <qvgen/manipulability.h>
#include <qvgen/robots/nr.h>

#include "command_line.h"

namespace qvgen::test {
namespace {

namespace arm = robots::nr;
using std::numbers::pi;

const std::string robot = QVGEN_SOURCE_DIR "/tests/map/nr_limits.toml";
const std::string options = " --resolution 0.17 --orientations 12";

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// VTK's structured points.
struct Volume {
  int edge = 0;
  double origin[3] = {}, spacing = 0;
  std::map<std::string, std::vector<float>> values;
  [[nodiscard]] float at(const std::string& name, int i, int j, int k) const {
    return values.at(name)[static_cast<std::size_t>((k * edge + j) * edge + i)];
  }
  [[nodiscard]] Eigen::Vector3d place(int i, int j, int k) const {
    return Eigen::Vector3d(origin[0], origin[1], origin[2]) + spacing * Eigen::Vector3d(i, j, k);
  }
};

std::vector<float> values_of(std::istream& file, int count) {
  std::vector<float> values;
  for (int i = 0; i < count; ++i) {
    unsigned char bytes[4];
    file.read(reinterpret_cast<char*>(bytes), 4);
    const std::uint32_t bits =
        static_cast<std::uint32_t>(bytes[0]) << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
    values.emplace_back();
    std::memcpy(&values.back(), &bits, 4);
  }
  return values;
}

Volume read_vtk(const fs::path& path) {
  std::istringstream file(content(path));
  Volume volume;
  std::string word, name;
  while (file >> word) {
    if (word == "DIMENSIONS") file >> volume.edge;
    if (word == "ORIGIN") file >> volume.origin[0] >> volume.origin[1] >> volume.origin[2];
    if (word == "SPACING") file >> volume.spacing;
    if (word == "SCALARS") file >> name;
    if (word != "default") continue;
    file.get();
    volume.values[name] = values_of(file, volume.edge * volume.edge * volume.edge);
  }
  return volume;
}

/// Alexa's spiral, as the paper's listing has it.
Eigen::Quaterniond orientation(int i, int count) {
  const double s = i + 0.5, t = s / count, d = 2 * pi * s;
  const double r = std::sqrt(t), R = std::sqrt(1 - t);
  const double alpha = d / std::sqrt(2.0), beta = d / 1.533751168755204288118041;
  return {r * std::sin(alpha), r * std::cos(alpha), R * std::sin(beta), R * std::cos(beta)};
}

const double lower[] = {-2.6, -3.0, -1.2, -4.0, -1.7}, upper[] = {1.9, 0.7, 2.9, 4.1, 1.6};

/// Over the turns that may be added the best distance of each joint, of the joint with the worst.
double limit_distance(const arm::JointVector<double>& q) {
  double worst = 1;
  for (int i = 0; i < 5; ++i) {
    double best = -100;
    for (int turns = -2; turns <= 2; ++turns) {
      const double angle = q[i] + 2 * pi * turns;
      best = std::max(best, std::min(angle - lower[i], upper[i] - angle) / (0.5 * (upper[i] - lower[i])));
    }
    worst = std::min(worst, best);
  }
  return worst;
}

/// Result of a loop over single calls at a position.
struct Expected {
  int reached = 0, solutions = 0, most = 0;
  double manipulability = 0, distance = -100;
  template <class Solutions>
  void see(const Solutions& found) {
    reached += found.empty() ? 0 : 1;
    solutions += found.size();
    most = std::max(most, found.size());
    for (const auto& row : found) {
      manipulability = std::max(manipulability, qvgen::manipulability(arm::jacobian(row.q)).volume);
      distance = std::max(distance, limit_distance(row.q));
    }
  }
};

Expected expected_at(const Eigen::Vector3d& position, bool within_limits) {
  arm::JointVector<double> low = arm::JointVector<double>::Constant(-1e300), high = -low;
  for (int i = 0; i < 5; ++i) low[i] = lower[i], high[i] = upper[i];
  low[5] = -pi, high[5] = pi;
  const arm::JointVector<double> seed = arm::JointVector<double>::Zero();
  Expected expected;
  for (int i = 0; i < 12; ++i) {
    const Pose<double> pose{orientation(i, 12), position};
    if (within_limits)
      expected.see(arm::inverse_kinematics(pose, seed, arm::Limits(low, high)));
    else
      expected.see(arm::inverse_kinematics(pose));
  }
  return expected;
}

void expect_cell(const Volume& map, int i, int j, int k, const Expected& expected) {
  SCOPED_TRACE(testing::Message() << map.place(i, j, k).transpose());
  const auto value = [&](const char* name) { return map.at(name, i, j, k); };
  EXPECT_EQ(value("share"), static_cast<float>(expected.reached / 12.0));
  EXPECT_EQ(value("most_solutions"), static_cast<float>(expected.most));
  const double mean = expected.reached == 0 ? 0 : static_cast<double>(expected.solutions) / expected.reached;
  EXPECT_EQ(value("mean_solutions"), static_cast<float>(mean));
  EXPECT_NEAR(value("manipulability"), expected.manipulability, 1e-6);
  if (expected.reached > 0) {
    EXPECT_NEAR(value("limit_distance"), expected.distance, 1e-6);
  } else {
    EXPECT_TRUE(std::isnan(value("limit_distance")));
  }
}

void expect_loop_of_single_calls(const Volume& map, bool within_limits) {
  int some = 0, none = 0;
  ASSERT_EQ(map.edge, 9);
  for (int i = 0; i < map.edge; ++i)
    for (int j = 0; j < map.edge; ++j)
      for (int k = 0; k < map.edge; ++k) {
        const Expected expected = expected_at(map.place(i, j, k), within_limits);
        expect_cell(map, i, j, k, expected);
        ++(expected.reached > 0 ? some : none);
      }
  EXPECT_GT(some, 100);
  EXPECT_GT(none, 100);
}

/// One map for all tests, in every format.
class Map : public testing::Test {
 protected:
  static inline fs::path folder;
  static inline ToolRun made;
  static void SetUpTestSuite() {
    folder = fs::path(testing::TempDir()) / ("qvgen_map_test_" + std::to_string(getpid()));
    fs::create_directories(folder);
    made = run_in(folder, "map " + robot + options + " -o whole.vtk -o whole.npz -o whole.svg -o whole.part");
  }
  static void TearDownTestSuite() { fs::remove_all(folder); }
  void SetUp() override { ASSERT_EQ(made.code, 0) << made.output; }

  static ToolRun map(const std::string& arguments) { return run_in(folder, "map " + arguments); }
  static void expect_whole(const std::string& file) {
    const std::string kind = fs::path(file).extension();
    EXPECT_EQ(content(folder / file), content(folder / ("whole" + kind))) << file;
  }
  static void expect_nothing_but_wholes() {
    for (const auto& entry : fs::directory_iterator(folder))
      EXPECT_EQ(entry.path().stem(), "whole") << entry.path();
  }
};

TEST_F(Map, HasWhatSingleCallsFind) { expect_loop_of_single_calls(read_vtk(folder / "whole.vtk"), false); }

TEST_F(Map, HasWhatSingleCallsFindWithinLimits) {
  const ToolRun limited = map(robot + options + " --limits -o whole.limits.vtk");
  ASSERT_EQ(limited.code, 0) << limited.output;
  expect_loop_of_single_calls(read_vtk(folder / "whole.limits.vtk"), true);
  fs::remove(folder / "whole.limits.vtk");
}

TEST_F(Map, IsAllOrNothingWhereTheArmIsAShellAndAWrist) {
  // The wrist's centre, the tool point, is d2 beside the plane of two links: its distance from the shoulder
  // says what is reached, in any orientation.
  const Volume map = read_vtk(folder / "whole.vtk");
  const double nearest = std::hypot(0.2, 0.4 - 0.25), farthest = std::hypot(0.2, 0.4 + 0.25);
  for (int i = 0; i < map.edge; ++i)
    for (int j = 0; j < map.edge; ++j)
      for (int k = 0; k < map.edge; ++k) {
        const Eigen::Vector3d from = map.place(i, j, k) - Eigen::Vector3d(0, 0, 0.5);
        const double distance = from.norm(), across = from.head<2>().norm();
        const bool reached = distance > nearest && distance < farthest && across > 0.2;
        EXPECT_EQ(map.at("share", i, j, k), reached ? 1.0F : 0.0F) << from.transpose();
      }
}

TEST_F(Map, IsTheSameInPartsAndInThreads) {
  EXPECT_EQ(map(robot + options + " --threads 3 -o threads.npz").code, 0);
  expect_whole("threads.npz");
  for (const char* part : {"998:999 -o c.part", "0:0 -o a.part", "1:997 -o b.part"})
    EXPECT_EQ(map(robot + options + " --blocks " + part).code, 0);
  const ToolRun merged = map("--merge b.part c.part a.part -o parts.npz -o parts.svg -o parts.part");
  EXPECT_EQ(merged.code, 0) << merged.output;
  for (const char* file : {"parts.npz", "parts.svg", "parts.part"}) expect_whole(file);
  const ToolRun some = map("--merge b.part a.part -o some.npz");
  EXPECT_EQ(some.code, 1);
  EXPECT_TRUE(has(some, "the blocks 998:999 are missing")) << some.output;
  for (const char* file :
       {"a.part", "b.part", "c.part", "parts.npz", "parts.svg", "parts.part", "threads.npz"})
    fs::remove(folder / file);
  expect_nothing_but_wholes();
}

TEST_F(Map, GoesOnWhereItWasStopped) {
  const std::string whole = content(folder / "whole.part");
  std::ofstream(folder / "cut.npz.unfinished", std::ios::binary) << whole.substr(0, whole.size() / 2);
  const ToolRun rest = map(robot + options + " -o cut.npz");
  EXPECT_EQ(rest.code, 0) << rest.output;
  EXPECT_TRUE(has(rest, "going on: ")) << rest.output;
  expect_whole("cut.npz");
  fs::remove(folder / "cut.npz");
  expect_nothing_but_wholes();
}

TEST_F(Map, GoesOnAfterItWasKilled) {
  // The system ends a process whose file grows beyond its limit, in the middle of a block.
  const ToolRun killed =
      run_in(folder, "--version > /dev/null; (ulimit -c 0; ulimit -f 16; exec " QVGEN_TOOL " map " + robot +
                         options + " --threads 2 -o killed.npz)");
  EXPECT_NE(killed.code, 0);
  EXPECT_FALSE(fs::exists(folder / "killed.npz"));
  const auto size = fs::file_size(folder / "killed.npz.unfinished");
  EXPECT_GT(size, 4000U);
  EXPECT_LT(size, fs::file_size(folder / "whole.part"));
  const ToolRun rest = map(robot + options + " -o killed.npz");
  EXPECT_TRUE(has(rest, "going on: ")) << rest.output;
  expect_whole("killed.npz");
  fs::remove(folder / "killed.npz");
  expect_nothing_but_wholes();
}

TEST_F(Map, SaysHowToGoOnWhenItIsStopped) {
  // It would take half a minute.
  const std::string long_one = " map " + robot + " --resolution 0.01 --orientations 300 -o long.npz";
  const ToolRun stopped = run_in(
      folder, "--version > /dev/null; " QVGEN_TOOL + long_one +
                  " & while kill -0 $! && [ $(cat long.npz.unfinished 2>/dev/null | wc -c) -lt 99999 ];"
                  " do sleep 0.01; done; kill -TERM $!; wait $!");
  EXPECT_EQ(stopped.code, 1);
  EXPECT_TRUE(has(stopped, "blocks are in long.npz.unfinished, the same command goes on")) << stopped.output;
  EXPECT_FALSE(fs::exists(folder / "long.npz"));
  fs::remove(folder / "long.npz.unfinished");
  expect_nothing_but_wholes();
}

TEST_F(Map, SaysWhatItRefuses) {
  const std::string to = " -o x.npz";
  const auto refused = [&](const std::string& arguments, int code, const std::string& text) {
    const ToolRun result = map(arguments);
    EXPECT_EQ(result.code, code) << arguments << result.output;
    EXPECT_TRUE(has(result, text)) << arguments << "\n" << result.output;
  };
  refused(robot + to + " --resolution 0", 2, "'0' is no length");
  refused(robot + to + " --resolution -1", 2, "'-1' is no length");
  refused(robot + to + " --resolution nan", 2, "'nan' is no length");
  refused(robot + to + " --orientations 0", 2, "--orientations");
  refused(robot + to + " --orientations many", 2, "many");
  refused(robot + to + " --threads 0", 2, "--threads");
  refused(robot + to + " --resolution 1e-5", 1, "GB of memory");
  refused(robot + to + " --resolution 1e-300", 1, "would fit");
  EXPECT_FALSE(has(map(robot + to + " --resolution 1e-300"), "inf"));
  refused(robot + " -o x.png", 2, "'x.png' has no suffix that says what to write: .npz (NumPy)");
  refused(robot + " -o x", 2, "has no suffix");
  refused(robot + to + " --blocks 0:9", 2, "call it .part");
  for (const char* blocks : {"0:1000", "5:4", "-1:4", "1000", "a:b", "1:2:3", "3:", "1.5"})
    refused(robot + " -o x.part --blocks=" + blocks, 2, "the blocks of a map are 0 to 999");
  refused(robot + " -o no/such/folder/x.npz --resolution 0.3", 1, "cannot write no/such/folder/x.npz");
  refused("-o x.npz", 2, "either a robot or --merge");
  refused(robot + to + " --merge whole.part", 2, "either a robot or --merge");
  refused("--limits --merge whole.part" + to, 2, "--limits excludes --merge");
  refused("--merge whole.npz" + to, 1, "whole.npz is no part of a map");
  refused("nr" + to + " --limits", 1, "the description of nr has no joint limits");
  refused("stanford" + to, 1, "d3 slides without limits");
  refused("pan_tilt" + to, 1, "a direction alone");
  refused("planar_3r" + to, 1, "whole poses, of which 3 joints reach so few");
  refused(QVGEN_SOURCE_DIR "/tests/motors/palletiser.toml" + to, 1, "its joints follow others, or motors");
  std::ofstream slides(folder / "slides.toml");
  slides << "name = \"slides\"\ntitle = \"two slides in line\"\n";
  for (const char* name : {"d1", "d2"})
    slides << "[[joint]]\ntype = \"prismatic\"\naxis = \"+z\"\nlimits = [0, 1]\nvariable = \"" << name
           << "\"\n";
  slides.close();
  refused("slides.toml" + to, 1, "no inverse kinematics that could be mapped");
  fs::remove(folder / "slides.toml");
  std::ofstream(folder / "open.toml") << good_arm;
  refused("open.toml" + to, 1, "l1 has no value");
  fs::remove(folder / "open.toml");
  expect_nothing_but_wholes();
}

TEST_F(Map, SaysThatThereIsNoCompiler) {
  const std::string command = "CXX=no-such-compiler QVGEN_CACHE=none " QVGEN_TOOL " map nr -o x.npz 2>&1";
  const ToolRun missing = run_in(folder, "--version > /dev/null; " + command);
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(has(missing, "there is no compiler no-such-compiler on this machine")) << missing.output;
  const ToolRun failing =
      run_in(folder, "--version > /dev/null; CXX=false QVGEN_CACHE=none " QVGEN_TOOL " map nr -o x.npz 2>&1");
  EXPECT_TRUE(has(failing, "cannot be compiled")) << failing.output;
  fs::remove_all(folder / "none");
  expect_nothing_but_wholes();
}

TEST_F(Map, DrawsThreePlanesOfEachQuantity) {
  const std::string svg = content(folder / "whole.svg");
  std::size_t panels = 0;
  for (std::size_t at = 0; (at = svg.find("crispEdges", at)) != std::string::npos; ++at) ++panels;
  EXPECT_EQ(panels, 15U);
  for (const char* text :
       {"share of the orientations", "best distance from joint limits", "y = 0 m", "z = 0.5 m"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  EXPECT_LT(svg.size(), 100000U);
}

TEST_F(Map, IsReadByNumpy) {
  std::ofstream(folder / "whole.py") << R"(import numpy
m = numpy.load("whole.npz")
assert m["share"].shape == (9, 9, 9) and m["share"].dtype == numpy.float32
assert abs(numpy.linalg.norm(m["orientations"], axis=1) - 1).max() < 1e-12 and len(m["orientations"]) == 12
assert b'"robot":"nr_limits"' in m["about"].item()
for name in ("share", "mean_solutions", "most_solutions", "manipulability"):
    print(name, *("%.9g" % v for v in m[name].transpose(2, 1, 0).ravel()))
print("place", m["x"][2], m["y"][3], m["z"][4])
)";
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    if (run_in(folder, "--version; " + python + " -c 'import numpy'").code != 0) continue;
    const ToolRun read = run_in(folder, "--version > /dev/null; " + python + " whole.py");
    ASSERT_EQ(read.code, 0) << read.output;
    const Volume map = read_vtk(folder / "whole.vtk");
    std::istringstream lines(read.output);
    for (int quantity = 0; quantity < 4; ++quantity) {
      std::string name;
      lines >> name;
      for (const float value : map.values.at(name)) {
        float same = -1;
        lines >> same;
        ASSERT_EQ(same, value) << name;
      }
    }
    std::string word;
    Eigen::Vector3d place;
    lines >> word >> place[0] >> place[1] >> place[2];
    EXPECT_LT((place - map.place(2, 3, 4)).norm(), 1e-9);
    return;
  }
  GTEST_SKIP() << "no Python with NumPy";
}

}  // namespace
}  // namespace qvgen::test
