// SPDX-License-Identifier: MIT
#include "pipeline/robot_output.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace qvgen::pipeline {
namespace {

std::string reason_of(const std::string& thrown) {
  RobotOutput output{"arm"};
  attempt("inverse", output, [&](RobotOutput&) { throw std::runtime_error(thrown); });
  return output.missing.at(0).reason;
}

TEST(RobotOutput, AReasonIsOneLineOfAComment) {
  EXPECT_EQ(reason_of("no structure"), "no structure");
  EXPECT_EQ(reason_of("Internal error!\nint x;\r\n"), "Internal error! int x;");
  EXPECT_EQ(reason_of("goes on \\"), "goes on");
  EXPECT_EQ(reason_of(""), "");
}

}  // namespace
}  // namespace qvgen::pipeline
