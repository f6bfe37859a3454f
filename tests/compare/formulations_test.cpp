// SPDX-License-Identifier: MIT
// Every formulation is its definition exactly (`measure` certifies it), and in double what an independent
// reference computes, which reads the description by itself.
#include <random>

#include "../random_arms/leaves.h"
#include "../random_arms/random_description.h"
#include "compare/comparison.h"
#include "compare/measure.h"
#include "dag/evaluate.h"
#include "derive/dynamics/formulation.h"
#include "model/followers.h"
#include "optimise/described.h"
#include "optimise/dynamics.h"
#include "reference/dynamics.h"
#include "robots.h"
#include "verify/certificate.h"

namespace {

using namespace qvgen;
using namespace qvgen::compare;

constexpr Level all_levels[] = {Level::textbook, Level::specialised, Level::optimised};

class Formulations : public testing::TestWithParam<What> {};
INSTANTIATE_TEST_SUITE_P(Quantities, Formulations,
                         testing::Values(What::forward, What::jacobian, What::dynamics),
                         [](const auto& of) { return what_names()[static_cast<std::size_t>(of.param)]; });

TEST_P(Formulations, AreTheDefinitionForCommittedRobots) {
  for (const auto& file : test::committed_robots()) {
    const model::Robot robot = *description::read_file(file).robot;
    if (GetParam() == What::dynamics && !optimise::has_inertia(robot)) continue;
    if (model::has_followers(robot)) {
      EXPECT_THROW(compare::compare(robot, {GetParam(), {}, {}}), std::domain_error);
      continue;
    }
    const Subject subject(robot, GetParam());
    for (const Formulation& formulation : formulations(GetParam())) {
      if (!formulation.run) continue;
      for (const Level level : all_levels)
        EXPECT_NO_THROW(measure(subject, formulation, level)) << file << " " << formulation.name;
    }
  }
}

/// A certificate must be able to fail: it refuses an error of a millionth.
TEST_P(Formulations, AWrongOneIsRefused) {
  const Subject subject(test::committed_robot("puma560"), GetParam());
  for (const Formulation& right : formulations(GetParam())) {
    if (!right.run) continue;
    Formulation wrong = right;
    wrong.run = [&](Recorder& recorder, const model::Robot& of) {
      Results results = right.run(recorder, of);
      results.back().value = results.back().value + recorder.literal(cln::cl_RA(1) / 1000000);
      return results;
    };
    for (const Level level : all_levels)
      EXPECT_THROW(measure(subject, wrong, level), verify::CertificateError) << right.name;
  }
}

/// A random arm, what its joints do, and what the quantity is there.
struct Case {
  std::string text;
  model::Robot robot;
  reference::Chain chain;
  Eigen::VectorXd q, qd, qdd;
  test::Leaves leaves;
};

std::optional<Case> random_case(What what, std::uint32_t seed) {
  const std::string text =
      what == What::dynamics ? test::random_description_with_inertia(seed) : test::random_description(seed);
  const auto read = description::read_text(text, "arm.toml");
  if (!read.robot) return std::nullopt;
  Case arm{text, *read.robot, reference::load_text(text, test::symbols()), {}, {}, {}, {test::symbols()}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-3, 3);
  for (Eigen::VectorXd* each : {&arm.q, &arm.qd, &arm.qdd})
    *each = Eigen::VectorXd::NullaryExpr(arm.chain.size(), [&] { return between(random); });
  arm.leaves.values[derive::dynamics::gravity_symbol] = reference::standing.z();
  for (std::size_t i = 0; i < arm.robot.joints.size(); ++i) {
    const std::string& variable = arm.robot.joints[i].variable;
    const auto k = static_cast<Eigen::Index>(i);
    arm.leaves.values[variable] = arm.q[k];
    arm.leaves.values[derive::dynamics::velocity_of(variable)] = arm.qd[k];
    arm.leaves.values[derive::dynamics::acceleration_of(variable)] = arm.qdd[k];
    arm.leaves.values[derive::dynamics::direction_of(variable)] = arm.qd[k] < 0 ? -1 : 1;
  }
  return arm;
}

/// The outputs in their order; of a quaternion, the matrix.
std::vector<double> expected_of(What what, const Case& arm) {
  std::vector<double> values;
  const auto append = [&](const Eigen::MatrixXd& m) {
    for (Eigen::Index i = 0; i < m.rows(); ++i)
      for (Eigen::Index j = 0; j < m.cols(); ++j) values.push_back(m(i, j));
  };
  if (what == What::dynamics) append(reference::inverse_dynamics(arm.chain, arm.q, arm.qd, arm.qdd));
  if (what == What::jacobian) append(reference::jacobian(arm.chain, arm.q));
  if (what != What::forward) return values;
  const Eigen::Isometry3d pose = reference::forward_kinematics(arm.chain, arm.q);
  append(pose.linear());
  append(pose.translation());
  return values;
}

std::vector<double> values_of(const dag::Function& function, const test::Leaves& leaves) {
  const auto values = dag::evaluate<double>(function, leaves);
  if (function.outputs.front().name != "w") return values;
  const Eigen::Matrix3d r =
      Eigen::Quaterniond(values[0], values[1], values[2], values[3]).toRotationMatrix().transpose();
  std::vector<double> pose(r.data(), r.data() + r.size());
  pose.insert(pose.end(), values.begin() + 4, values.end());
  return pose;
}

TEST_P(Formulations, AreTheReferenceForRandomArms) {
  int accepted = 0;
  const std::uint32_t wanted = test::random_arms(GetParam() == What::forward ? 16 : 8);
  for (std::uint32_t seed = 1; seed <= wanted; ++seed) {
    const auto arm = random_case(GetParam(), seed);
    if (!arm) continue;
    ++accepted;
    const Subject subject(arm->robot, GetParam());
    const std::vector<double> expected = expected_of(GetParam(), *arm);
    const double size = 1 + Eigen::Map<const Eigen::VectorXd>(expected.data(), std::ssize(expected)).norm();
    for (const Formulation& formulation : formulations(GetParam())) {
      if (!formulation.run) continue;
      SCOPED_TRACE(formulation.name + "\n" + arm->text);
      EXPECT_NO_THROW(measure(subject, formulation, Level::textbook));
      const Measured measured = measure(subject, formulation, Level::specialised);
      const auto values = values_of(
          optimise::in_terms_of_description(measured.function, subject.of(formulation).arm), arm->leaves);
      ASSERT_EQ(values.size(), expected.size());
      for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-11 * size) << i;
    }
  }
  EXPECT_GT(2 * accepted, static_cast<int>(wanted)) << "most must be accepted, or the law says nothing";
}

}  // namespace
