// SPDX-License-Identifier: MIT
// What a description could do to the generated code or to the tool: it is told instead, within two seconds.
#include <chrono>
#include <cstdio>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "description/names.h"
#include "description/plain_text.h"
#include "description/reader.h"

namespace qvgen::description {
namespace {

const std::string joint =
    "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"t1\"\nlink = [\"a1\", 0, 0]\n";

std::string first_message(const std::string& text) {
  const auto start = std::chrono::steady_clock::now();
  const ReadResult result = read_text(text, "r.toml");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  return result.diagnostics.empty() ? "" : to_string(result.diagnostics.front());
}

testing::AssertionResult has(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "it says: " << text;
}

TEST(Hostile, OnlyPlainLinesReachTheCode) {
  for (const char* bad : {"\\r", "\\n", "\\t", "\\u0000", "\\u001B[31m", "\\u007F", "\\u0085", "\\u2028",
                          "\\u2029", "\\u202E", "\\u2066", "\\u200F", "\\u061C"}) {
    for (const char* key : {"title", "source"}) {
      const std::string other = key == std::string("title") ? "source" : "title";
      const std::string text = std::string("name = \"a\"\n") + key + " = \"x" + bad + "int y;\"\n" + other +
                               " = \"plain\"\n" + joint;
      const std::string message = first_message(text);
      EXPECT_TRUE(has(message, std::string("r.toml:2:") + (key == std::string("title") ? "9" : "10") +
                                   ": error: the " + key + " has"))
          << bad;
      EXPECT_TRUE(problem_of_text(message).empty()) << message;
    }
  }
  EXPECT_TRUE(has(first_message("name = \"a\"\ntitle = 'x\\'\n" + joint), "ends with a backslash"));
  EXPECT_TRUE(has(first_message("name = \"a\"\ntitle = 'x\\  '\n" + joint), "ends with a backslash"));
  // A trigraph of C99.
  EXPECT_TRUE(has(first_message("name = \"a\"\ntitle = 'what is x?\?/'\n" + joint),
                  "r.toml:2:9: error: the title ends with ?\?/, which C reads as a backslash"));
  EXPECT_EQ(first_message("name = \"a\"\ntitle = 'what is ?\?/ here?'\n" + joint), "");
  EXPECT_EQ(first_message("name = \"a\"\ntitle = 'Größe λ→∞ \\o/ “x” 机器人'\n" + joint), "");
}

TEST(Hostile, MessagesHaveNoControlCharacters) {
  const std::string message =
      first_message("name = \"a\"\ntitle = \"A\"\n\"\\u001B[2J\\u202E\" = 1\n" + joint);
  EXPECT_TRUE(has(message, "\\x1B[2J\\u202E")) << message;
}

TEST(Hostile, NamesThatTheCodeCannotHave) {
  for (const char* name :
       {"M_PI", "M_PIl", "NAN", "FP_NAN", "LX", "E2BIG", "INFINITY", "EOF", "I", "typeof", "errno", "stdin",
        "Scalar", "BasicGeometry", "free", "__x", "_x", "int", "restrict"})
    EXPECT_FALSE(check_identifier(name).message.empty()) << name;
  for (const char* name : {"goal_x", "pose_s", "pose_r_w", "target_q_w", "turn_11", "result", "L1",
                           "D12",    "A",      "branch",   "cos_theta1", "l_x",     "t0",     "w",
                           "k0",     "pose",   "seed",     "angle",      "Lx",      "I1xx"})
    EXPECT_TRUE(check_identifier(name).message.empty()) << name << check_identifier(name).message;
  for (const char* name : {"inverse", "detail", "typeof", "Arm"})
    EXPECT_FALSE(check_robot_name(name).message.empty()) << name;
  EXPECT_TRUE(check_identifier(std::string(64, 'x')).message.empty());
  EXPECT_TRUE(has(check_identifier(std::string(65, 'x')).message, "65 letters"));
}

/// Every macro that the headers of generated code bring along, in both dialects, as the compiler lists them.
TEST(Hostile, NoNameIsAMacro) {
  const std::string headers =
      "printf '#include <Eigen/Geometry>\\n#include <cmath>\\n#include <limits>\\n#include <cstdio>\\n"
      "#include <cstdlib>\\n#include <complex.h>\\n#include <climits>\\n#include <cstdint>\\n"
      "#include <unistd.h>\\n' | ";
  int macros = 0;
  for (const char* dialect : {"c++17", "gnu++17"}) {
    const std::string command =
        headers + QVGEN_CXX + " -x c++ -std=" + dialect + " -I" + QVGEN_EIGEN + " -dM -E -";
    FILE* pipe = ::popen(command.c_str(), "r");
    char line[4096];
    while (std::fgets(line, sizeof line, pipe) != nullptr) {
      std::istringstream words(line);
      std::string define, name;
      words >> define >> name;
      if (name.empty() || name.find('(') != std::string::npos) continue;  // needs its arguments
      ++macros;
      EXPECT_FALSE(check_identifier(name).message.empty()) << name;
    }
    EXPECT_EQ(::pclose(pipe), 0);
  }
  EXPECT_GT(macros, 500);
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST(Hostile, DeepAndLongInputsGetAMessage) {
  const std::string head = "name = \"a\"\ntitle = \"A\"\n";
  const std::string chain = "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"t1\"\nlink = [\"";
  const int many = 50'000;
  for (const std::string& expression :
       {"x" + repeated("*x", many), "x" + repeated("+x", many), "x" + repeated(" + x*y", 5000),
        "1" + repeated("/x", many), repeated("(", many) + "x", repeated("-", many) + "x",
        repeated("sqrt(", many), "x" + repeated("^2", many), "2" + repeated(" deg", many),
        repeated("9", many)})
    EXPECT_TRUE(has(first_message(head + chain + expression + "\", 0, 0]\n"), ": error: "))
        << expression.substr(0, 20);
  const std::string parts = "a" + repeated(".a", many);
  EXPECT_TRUE(has(first_message(head + parts + " = 1\n"), "dots in keys"));
  EXPECT_TRUE(has(first_message(head + "[" + parts + "]\n"), "dots in keys"));
  EXPECT_TRUE(has(first_message(head + "x = {" + parts + " = 1}\n"), "dots in keys"));
  EXPECT_TRUE(has(first_message(head + "\"a\"" + repeated(" . \"a\"", many / 2) + " = 1\n"), "dots in keys"));
  EXPECT_TRUE(has(first_message(head + "1" + repeated(".1", many) + " = 1\n"), "dots in keys"));
  EXPECT_TRUE(has(first_message(head + "x = " + repeated("[", many) + "\n"), "error"));
  EXPECT_TRUE(has(first_message(head + "x = " + repeated("{a=", many) + "\n"), "error"));
  EXPECT_TRUE(has(first_message(head + repeated("# long\n", many) + joint), "bytes"));
  std::string symbols;
  for (int i = 0; i < 15'000; ++i) symbols += "s" + std::to_string(i) + " = 1\n";
  EXPECT_TRUE(has(first_message(head + joint + "[defaults]\na1 = 1\n" + symbols), "symbols are too many"));
  EXPECT_TRUE(has(first_message(head + repeated(joint, 3000)), "error"));
  EXPECT_EQ(first_message("name = \"a\"\ntitle = \"1.2.3 ... \"\n# " + repeated("...", 2000) + "\n" + joint),
            "");
}

TEST(Hostile, WhatWasMeantIsAskedFor) {
  const std::string head = "name = \"a\"\ntitle = \"A\"\n";
  EXPECT_TRUE(has(first_message(head + joint + "origin = [\"90 deg\", 0, 0]\n"),
                  "r.toml:8:11: error: 'origin' has an angle"));
  EXPECT_TRUE(has(first_message(head + joint + "mass = \"3 rad\"\n"), "'mass' has an angle"));
  EXPECT_EQ(first_message(head + joint + "origin = [\"0.3*cos(10 deg)\", 0, 0]\n"), "");
  const std::string table = head + "convention = \"standard\"\n[[dh]]\nvariable = \"theta1\"\n[[dh]]\n";
  EXPECT_TRUE(has(first_message(table + "theta = \"theta2\"\n[[dh]]\nvariable = \"theta3\"\n"),
                  "r.toml:7:9: warning: 'theta2' is a constant here"));
  EXPECT_EQ(first_message("symbols = [\"theta2\"]\n" + table + "theta = \"theta2\"\n"), "");
  EXPECT_EQ(first_message(table + "theta = \"beta\"\nd = \"l2\"\n"), "");
  EXPECT_TRUE(has(first_message(table + "d = \"90 deg\"\n"), "'d' has an angle"));
  EXPECT_TRUE(has(first_message(head + "convention = \"standard\"\n[[dh]]\ntheta = \"q1 + 90 deg\"\n"),
                  "r.toml:5:9: error: no joints: no row of the table has a variable, so that 'q1' is"));
}

TEST(Hostile, LengthsThatNoArmHas) {
  const std::string head = "name = \"a\"\ntitle = \"A\"\n";
  EXPECT_TRUE(has(first_message(head + joint + "origin = [0, \"-11e300\", 0]\n"),
                  "r.toml:8:14: error: 'origin' has a length of"));
  EXPECT_TRUE(has(first_message(head + joint + "origin = [1.5e6, 0, 0]\n"), "at most 1000000"));
  EXPECT_TRUE(has(first_message(head + joint + "origin = [1e6, 0, \"1e9*a1\"]\n"),
                  "r.toml:3:1: warning: an offset of 1e+06 metres"));
  EXPECT_TRUE(has(first_message(head + "convention = \"modified\"\n[[dh]]\nvariable = \"t1\"\na = 1e7\n"),
                  "'a' has a length of 10000000"));
}

TEST(Hostile, FreeParametersOfOneKey) {
  const ReadResult result =
      read_text("name = \"a\"\ntitle = \"A\"\n" + joint +
                    "mass = \"free\"\ncentre_of_mass = \"free\"\nviscous_friction = \"free\"\n",
                "r.toml");
  ASSERT_TRUE(result.robot) << to_string(result.diagnostics.front());
  std::string names;
  for (const auto& parameter : result.robot->inertia_parameters) names += parameter.name + " ";
  EXPECT_EQ(names, "m1 c1x c1y c1z Fv1 ");
  EXPECT_TRUE(has(first_message("name = \"a\"\ntitle = \"A\"\n" + joint + "origin = [\"free\", 0, 0]\n"),
                  "'free' has a meaning"));
}

}  // namespace
}  // namespace qvgen::description
