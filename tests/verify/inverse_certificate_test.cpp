// SPDX-License-Identifier: MIT
// What is derived of inverse kinematics is refused where it is wrong by little.
#include <gtest/gtest.h>

#include "derive/inverse/inverse.h"
#include "description/reader.h"
#include "verify/certificate.h"
#include "verify/inverse/certify.h"

namespace {

using namespace qvgen;
using derive::inverse::Plan;
using symbolic::Program;

model::Robot robot(const std::string& name) {
  return description::read_file(QVGEN_SOURCE_DIR "/generator/robots/" + name + ".toml", {}).robot.value();
}

/// With one of its outputs off by a billionth.
Program falsified(const Program& program, const std::string& name) {
  Program result;
  for (const Program::Step& step : program.steps()) result.append(step);
  for (const Program::Output& output : program.outputs())
    result.output(output.name,
                  output.name == name ? output.value + GiNaC::numeric(1, 1000000000) : output.value);
  return result;
}

void certify(const derive::inverse::Problem& problem, const Plan& plan) {
  verify::certify_inverse(problem.robot, derive::inverse::lower(plan), 2, problem.task);
}

class InverseCertificate : public testing::TestWithParam<std::string> {};

TEST_P(InverseCertificate, RefusesAWrongEquation) {
  const derive::inverse::Derivation derivation = derive::inverse::derive(robot(GetParam()));
  const derive::inverse::Problem& arm = derivation.problem;
  const Plan& plan = derivation.plan;
  EXPECT_NO_THROW(certify(arm, plan));
  Plan wrong = plan;
  for (derive::inverse::Step& step : wrong.steps)
    if (step.is<derive::inverse::kind::Circle>()) step.before = falsified(step.before, "low");
  EXPECT_THROW(certify(arm, wrong), verify::CertificateError);
}

TEST_P(InverseCertificate, RefusesAWrongRangeTest) {
  const derive::inverse::Derivation derivation = derive::inverse::derive(robot(GetParam()));
  const derive::inverse::Problem& arm = derivation.problem;
  Plan plan = derivation.plan;
  ASSERT_TRUE(plan.range_test.exists());
  const Program right = plan.range_test.values;
  for (const char* output : {"middle", "swing"}) {
    plan.range_test.values = falsified(right, output);
    EXPECT_THROW(certify(arm, plan), verify::CertificateError) << output;
  }
}

// A direction of either sign with and without offset, one that is left as long as it is, and no direction at
// all.
INSTANTIATE_TEST_SUITE_P(Robots, InverseCertificate,
                         testing::Values("irb6640", "puma560", "nr", "rx90", "poe_6r", "rr_planar"),
                         [](const auto& each) { return each.param; });

/// A share that depends on an unknown other than one direction is left to the branches.
TEST(RangeTest, IsLeftOutBehindAWrist) {
  EXPECT_FALSE(derive::inverse::derive(robot("ur5")).plan.range_test.exists());
}

/// Three parallel axes behind a first one across: its direction is the orientation's and may be nearly free
/// at poses that are within reach, while the share of q5 depends on the position as well.
constexpr const char* first_joint_by_orientation = R"(
name = "first_by_orientation"
title = "three parallel axes behind a first one across"
[[joint]]
type = "revolute"
axis = [0, 1, 0]
variable = "q1"
[[joint]]
type = "revolute"
axis = [0, 0, 1]
variable = "q2"
origin = [1, 0, 0]
[[joint]]
type = "revolute"
axis = [0, 0, 1]
variable = "q3"
origin = [2, 0, 0]
[[joint]]
type = "revolute"
axis = [0, 0, 1]
variable = "q4"
origin = [3, 0, 0]
[[joint]]
type = "revolute"
axis = [0, -1, 0]
variable = "q5"
origin = ["1/2", 0, "1/3"]
[[joint]]
type = "revolute"
axis = [0, -1, 0]
variable = "q6"
origin = ["3/4", "1/5", "2/5"]
)";

TEST(RangeTest, DividesByNoDirection) {
  const auto read = description::read_text(first_joint_by_orientation, "first_by_orientation.toml");
  const auto derivation = derive::inverse::derive(read.robot.value());
  ASSERT_TRUE(derivation.found);
  ASSERT_TRUE(derivation.plan.steps.front().is<derive::inverse::kind::Opposite>());
  EXPECT_FALSE(derivation.plan.range_test.exists());
}

}  // namespace
