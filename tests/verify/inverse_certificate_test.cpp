// SPDX-License-Identifier: MIT
// What is derived of inverse kinematics is refused where it is wrong by little.
#include <functional>

#include <cln/rational.h>
#include <gtest/gtest.h>

#include "derive/inverse/inverse.h"
#include "description/reader.h"
#include "model/arithmetic.h"
#include "verify/certificate.h"
#include "verify/inverse/certify.h"

namespace {

using namespace qvgen;
using derive::inverse::Plan;
using derive::inverse::Problem;
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

void certify(const Problem& problem, const Plan& plan) {
  verify::certify_inverse(problem, derive::inverse::lower(plan), 2);
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

/// With base, tool and the zero of the second joint turned by angles that are no right ones.
model::Robot turned(const std::string& name) {
  const model::Expression angle(cln::cl_RA(3) / 10);
  model::Robot result = robot(name);
  result.base.turns.insert(result.base.turns.begin(), {model::unit_vector(0), angle});
  result.tool.turns.push_back({model::unit_vector(1), angle});
  result.joints[1].before.turns.push_back({result.joints[1].axis, angle});
  return result;
}

class CertificateOfFrames : public testing::TestWithParam<std::string> {
 protected:
  /// The plan stays right: what is spoiled is the way from a described pose to it and back.
  void expect_refused(const std::string& what, const std::function<void(Problem&)>& spoil) const {
    Problem wrong = derivation_.problem;
    spoil(wrong);
    EXPECT_THROW(certify(wrong, derivation_.plan), verify::CertificateError) << what;
  }

  derive::inverse::Derivation derivation_ = derive::inverse::derive(turned(GetParam()));
};

TEST_P(CertificateOfFrames, RefusesWrongOnes) {
  ASSERT_TRUE(derivation_.found);
  EXPECT_NO_THROW(certify(derivation_.problem, derivation_.plan));
  ASSERT_TRUE(derivation_.problem.has_frames);
  expect_refused("base turned otherwise", [](Problem& wrong) { wrong.base.turns.pop_back(); });
  const model::Task task = derivation_.problem.task;
  if (task == model::Task::pose)
    expect_refused("tool turned otherwise", [](Problem& wrong) { wrong.tool.turns.clear(); });
  if (task != model::Task::direction)
    expect_refused("base moved by a billionth", [](Problem& wrong) {
      model::Expression& x = wrong.base.translation[0];
      x = model::add(x, model::Expression(cln::cl_RA(1) / 1000000000));
    });
}

TEST_P(CertificateOfFrames, RefusesWrongZeros) {
  ASSERT_TRUE(derivation_.problem.has_phases());
  expect_refused("a zero off by a billionth", [](Problem& wrong) {
    wrong.phases[1].pi = wrong.phases[1].pi + cln::cl_RA(1) / 1000000000;
  });
}

// Asked for a pose, a position and a turn, a direction, a position.
INSTANTIATE_TEST_SUITE_P(Robots, CertificateOfFrames,
                         testing::Values("irb6640", "ur5", "stanford", "nr", "scara", "pan_tilt", "rrp"),
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
