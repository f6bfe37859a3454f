// SPDX-License-Identifier: MIT
#include "pipeline/robot_output.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "emit/render.h"
#include "verify/certificate.h"

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

/// A failed check of the tool costs its part alone, and does not blame the description.
TEST(RobotOutput, AFailedCertificateIsADefectOfTheTool) {
  RobotOutput output{"arm"};
  attempt("inverse", output, [](RobotOutput&) { throw verify::CertificateError("the range test is wrong"); });
  attempt("kinematics", output, [](RobotOutput& made) { made.files.push_back({"kinematics.h", ""}); });
  ASSERT_EQ(output.missing.size(), 1U);
  EXPECT_EQ(output.missing[0].kind, Missing::Kind::refuted);
  EXPECT_NE(output.missing[0].reason.find("the range test is wrong"), std::string::npos);
  EXPECT_NE(output.missing[0].reason.find("a defect of this tool"), std::string::npos);
  EXPECT_EQ(output.files.size(), 1U);
}

TEST(RobotOutput, ATemplateThatLacksAValueIsADefectOfTheTool) {
  RobotOutput output{"arm"};
  attempt("model", output, [](RobotOutput&) { emit::render("cpp/model.h", {}); });
  ASSERT_EQ(output.missing.size(), 1U);
  EXPECT_EQ(output.missing[0].kind, Missing::Kind::refuted);
  EXPECT_NE(output.missing[0].reason.find("cpp/model.h: no value for the key"), std::string::npos);
}

}  // namespace
}  // namespace qvgen::pipeline
