// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "pipeline/pipeline.h"

namespace qvgen::pipeline {
namespace {

/// One link with mass, which leaves its loads and derivatives to who names them.
const char* const pendulum = R"(
name = "pendulum"
title = "one link"
on_request = "dynamics_derivatives, dynamics_loads"
[[joint]]
type = "revolute"
axis = "+y"
variable = "t"
mass = 1
centre_of_mass = [1, 0, 0]
)";

bool has_header(const RobotOutput& output, const std::string& part) {
  const std::string path = "include/qvgen/robots/pendulum/" + part + ".h";
  return std::any_of(output.files.begin(), output.files.end(),
                     [&](const OutputFile& file) { return file.path == path; });
}

RobotOutput generated(const Parts& parts) {
  const description::ReadResult read = description::read_text(pendulum, "pendulum.toml");
  return generate({read.robot.value()}, parts).front();
}

TEST(OnRequest, IsLeftOutAndSaysHowToAskForIt) {
  for (const Parts& parts : {Parts{}, Parts{"dynamics"}}) {
    const RobotOutput output = generated(parts);
    EXPECT_TRUE(has_header(output, "dynamics"));
    EXPECT_TRUE(has_header(output, "regressor"));
    EXPECT_FALSE(has_header(output, "dynamics_loads"));
    EXPECT_FALSE(has_header(output, "dynamics_derivatives"));
    const auto loads = std::find_if(output.missing.begin(), output.missing.end(),
                                    [](const Missing& each) { return each.part == "dynamics_loads"; });
    ASSERT_NE(loads, output.missing.end());
    EXPECT_EQ(loads->kind, Missing::Kind::on_request);
    EXPECT_NE(loads->reason.find("--only dynamics_loads"), std::string::npos);
  }
}

TEST(OnRequest, IsMadeWithWhatItNeedsOnceItIsNamed) {
  const RobotOutput output = generated({"dynamics_loads"});
  EXPECT_TRUE(has_header(output, "model"));
  EXPECT_TRUE(has_header(output, "dynamics"));
  EXPECT_TRUE(has_header(output, "dynamics_loads"));
  EXPECT_FALSE(has_header(output, "dynamics_derivatives"));
  EXPECT_FALSE(has_header(output, "kinematics"));
}

}  // namespace
}  // namespace qvgen::pipeline
