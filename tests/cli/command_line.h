// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace qvgen::test {

namespace fs = std::filesystem;

/// The description of an arm with more joints than inverse kinematics is derived for.
inline std::string eight_joints() {
  std::string text = "name = \"eight\"\ntitle = \"eight joints\"\n";
  for (int i = 1; i <= 8; ++i)
    text += std::string("[[joint]]\ntype = \"revolute\"\naxis = \"") + (i % 2 == 0 ? "+x" : "+z") +
            "\"\nvariable = \"theta" + std::to_string(i) + "\"\nlink = [0.1, 0.2, 0.3]\n";
  return text;
}

struct ToolRun {
  int code;
  std::string output;  ///< stdout and stderr
};

/// The tool's run, or another's; `arguments` may send the output elsewhere.
inline ToolRun run_in(const fs::path& folder, const std::string& arguments,
                      const std::string& tool = QVGEN_TOOL) {
  const std::string command =
      "cd '" + folder.string() + "' && { " + tool + " " + arguments + "; } 2>&1 </dev/null";
  FILE* pipe = ::popen(command.c_str(), "r");
  ToolRun result{-1, {}};
  char buffer[4096];
  while (std::size_t size = std::fread(buffer, 1, sizeof buffer, pipe)) result.output.append(buffer, size);
  const int status = ::pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

inline ToolRun run(const std::string& arguments) { return run_in(fs::current_path(), arguments); }

inline bool has(const ToolRun& result, const std::string& text) {
  return result.output.find(text) != std::string::npos;
}

class CommandLine : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) / ("qvgen_command_line_test_" + std::to_string(getpid()));
  void SetUp() override {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  }
  std::string out() { return (folder / "out").string(); }
};

inline constexpr const char* good_arm = R"(name = "my_arm"
title = "two links"
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
link = ["l1", 0, 0]
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta2"
link = ["l2", 0, 0]
)";

/// Six measured joints, none of whose axes meet or are parallel, with the names that a URDF gives.
inline constexpr const char* measured_arm = R"(name = "measured"
title = "an arm of three parallel axes and a wrist, as it was measured"
convention = "standard"
[[dh]]
variable = "shoulder_pan_joint"
d = 0.08946
alpha = 1.57081
[[dh]]
variable = "shoulder_lift_joint"
d = 0.00003
a = -0.42491
alpha = 0.00012
[[dh]]
variable = "elbow_joint"
d = -0.00004
a = -0.39217
alpha = -0.00009
[[dh]]
variable = "wrist_1_joint"
d = 0.10921
a = 0.00011
alpha = 1.57068
[[dh]]
variable = "wrist_2_joint"
d = 0.09473
a = -0.00007
alpha = -1.57091
[[dh]]
variable = "wrist_3_joint"
d = 0.0823
)";

}  // namespace qvgen::test
