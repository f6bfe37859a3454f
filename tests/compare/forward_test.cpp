// SPDX-License-Identifier: MIT
// Every formulation of forward kinematics is the definition exactly (`measure` certifies it), and in double
// what an independent chain of homogeneous matrices gives, which reads the description by itself.
#include <random>

#include "../strangers/random_description.h"
#include "compare/measure.h"
#include "dag/evaluate.h"
#include "leaves.h"
#include "optimise/described.h"
#include "robots.h"
#include "verify/certificate.h"

namespace {

using namespace qvgen;
using namespace qvgen::compare;

Eigen::Isometry3d pose_of(const dag::Function& function, const test::Leaves& leaves) {
  const auto v = dag::evaluate<double>(function, leaves);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (function.outputs.front().name == "w")
    pose.linear() = Eigen::Quaterniond(v[0], v[1], v[2], v[3]).toRotationMatrix();
  else
    pose.linear() << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
  pose.translation() << v[v.size() - 3], v[v.size() - 2], v[v.size() - 1];
  return pose;
}

void expect_right(const model::Robot& robot, const std::string& text, std::uint32_t seed) {
  const Subject subject(robot, What::forward);
  const reference::Chain chain = reference::load_text(text, test::symbols());
  std::mt19937 random(seed);
  Eigen::VectorXd q(chain.size());
  for (double& each : q) each = std::uniform_real_distribution<double>(-3, 3)(random);
  const Eigen::Isometry3d expected = reference::forward_kinematics(chain, q);
  test::Leaves leaves{test::symbols()};
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    leaves.values[robot.joints[i].variable] = q[static_cast<Eigen::Index>(i)];
  for (const Formulation& formulation : formulations(What::forward)) {
    if (!formulation.run) continue;
    SCOPED_TRACE(formulation.name + "\n" + text);
    EXPECT_NO_THROW(measure(subject, formulation, Level::textbook));
    for (const Level level : {Level::specialised, Level::optimised}) {
      const Measured measured = measure(subject, formulation, level);
      const Eigen::Isometry3d pose =
          pose_of(optimise::in_terms_of_description(measured.function, subject.of(formulation).arm), leaves);
      EXPECT_LT((pose.matrix() - expected.matrix()).norm(), 1e-12 * (1 + expected.translation().norm()));
    }
  }
}

TEST(ForwardFormulations, AreTheDefinitionForCommittedRobots) {
  for (const auto& file : test::committed_robots()) {
    const Subject subject(*description::read_file(file).robot, What::forward);
    for (const Formulation& formulation : formulations(What::forward)) {
      if (!formulation.run) continue;
      for (const Level level : {Level::textbook, Level::specialised, Level::optimised})
        EXPECT_NO_THROW(measure(subject, formulation, level)) << file << " " << formulation.name;
    }
  }
}

TEST(ForwardFormulations, AreTheReferenceForRandomArms) {
  for (std::uint32_t seed = 1; seed <= test::random_arms(12); ++seed) {
    const std::string text = test::random_description(seed);
    expect_right(test::robot_of(text), text, seed);
  }
}

/// What is certified must be able to fail: a micrometre.
TEST(ForwardFormulations, AWrongOneIsRefused) {
  const model::Robot robot = test::committed_robot("puma560");
  const Subject subject(robot, What::forward);
  for (const Formulation& right : formulations(What::forward)) {
    if (!right.run) continue;
    Formulation wrong = right;
    wrong.run = [&](Recorder& recorder, const model::Robot& of) {
      Results results = right.run(recorder, of);
      results.back().value = results.back().value + recorder.literal(cln::cl_RA(1) / 1000000);
      return results;
    };
    for (const Level level : {Level::textbook, Level::specialised, Level::optimised})
      EXPECT_THROW(measure(subject, wrong, level), verify::CertificateError) << right.name;
  }
}

}  // namespace
