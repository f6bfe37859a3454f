// SPDX-License-Identifier: MIT
// The full set: bodies that can be, with exactly the identified torques where that is possible, else the
// nearest.
#include "identify/consistent.h"

#include <gtest/gtest.h>

#include "identify/identification.h"
#include "identify/prior.h"
#include "identify/written.h"
#include "random_arm.h"
#include "reference/linear_algebra.h"
#include "simulated.h"

namespace qvgen::test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using identify::FullSet;
using identify::Identification;
using identify::MotionLog;

void expect_bodies(const FullSet& full, Index links) {
  for (Index i = 0; i < links; ++i) {
    const auto body = identify::pseudo_inertia(full.values.segment<10>(10 * i));
    EXPECT_GT(reference::pivots(body).minCoeff(), 0) << i;
  }
  for (Index k = 0; k < 4 * links; ++k)
    if (k % 4 != 3) {
      EXPECT_GT(full.values[10 * links + k], 0);
    }
}

/// Identifies an arm from exact data, without what its description says of inertia. The description that is
/// written, which is read as any other, has the arm's torques in new motions.
FullSet expect_torques_of_new_motions(const std::string& text, unsigned seed) {
  const reference::Chain chain = reference::load_text(text);
  const model::Robot bare = read_arm(without_inertia(text));
  const Identification found = identify::identify(bare, {simulated(chain, 3000, seed)});
  EXPECT_TRUE(found.full.exact) << text;
  const std::string result = identify::written(without_inertia(text), bare, found.full.values, "from a test");
  MotionLog log = simulated(chain, 200, seed + 100);
  const Eigen::MatrixXd torque = log.torque;
  fill_torques(reference::load_text(result), log);
  EXPECT_LT((log.torque - torque).norm(), 1e-9 * torque.norm()) << result;
  read_arm(result);
  return found.full;
}

TEST(FullSetOfParameters, GivesTheTorquesOfNewMotions) {
  unsigned seed = 50;
  for (const std::string kind : {"RRR", "RRRRRR", "RPR", "RRRRRRR"}) {
    ++seed;
    const FullSet full = expect_torques_of_new_motions(ArmWriter(seed).text(kind), seed);
    expect_bodies(full, static_cast<Index>(kind.size()));
  }
}

/// Logs of motors: drives that cannot be told apart become the motors', and no joint that several of them
/// move has Coulomb friction, which no description of one takes.
TEST(FullSetOfParameters, OfMotorsGivesTheTorquesOfNewMotions) {
  unsigned seed = 70;
  for (const std::string kind : {"RRR", "RRRRR", "RPR"}) {
    ++seed;
    expect_torques_of_new_motions(ArmWriter(seed).with_motors(kind), seed);
  }
}

TEST(FullSetOfParameters, KeepsTheTotalMass) {
  const std::string text = ArmWriter(3).text("RRR");
  const reference::Chain chain = reference::load_text(text);
  identify::Request request;
  request.mass = 30;
  const Identification found =
      identify::identify(read_arm(without_inertia(text)), {simulated(chain, 1000, 1)}, {}, request);
  EXPECT_TRUE(found.full.exact);
  EXPECT_NEAR(found.full.values[0] + found.full.values[10] + found.full.values[20], 30, 1e-9);
}

/// With the true description as a prior nothing changes.
TEST(FullSetOfParameters, OfTheTruthIsTheTruth) {
  const std::string text = ArmWriter(4).text("RRPR");
  const reference::Chain chain = reference::load_text(text);
  const Identification found = identify::identify(read_arm(text), {simulated(chain, 2000, 1)});
  EXPECT_TRUE(found.full.exact);
  EXPECT_LT((found.full.values - parameters_of(chain)).norm(), 1e-7 * parameters_of(chain).norm());
}

/// Parameters of a body whose moments break the triangle inequality: the nearest bodies, and how far they
/// are.
TEST(FullSetOfParameters, OfWhatNoBodyHasIsTheNearest) {
  const std::string text = ArmWriter(5).text("RRR");
  reference::Chain chain = reference::load_text(text);
  chain.joints[2].inertia = Eigen::Vector3d(0.05, 0.05, 2).asDiagonal();
  MotionLog log = simulated(chain, 2000, 1);
  add_noise(log, VectorXd::Constant(3, 0.01), 1);
  const Identification found = identify::identify(read_arm(without_inertia(text)), {log});
  EXPECT_FALSE(found.full.exact);
  EXPECT_GT(found.full.distance, 100);
  expect_bodies(found.full, 3);
  const auto squares = [&](const VectorXd& values) {
    return (found.estimate.information * (found.arm.combination * values - found.estimate.value))
        .squaredNorm();
  };
  EXPECT_NEAR(squares(found.full.values), found.full.distance, 1e-6 * found.full.distance);
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0, 1);
  for (int trial = 0; trial < 2000; ++trial) {  // no other bodies nearby are nearer
    FullSet other = found.full;
    for (Index i = 0; i < 3; ++i) {
      Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
      for (Index k = 0; k < 16; ++k) turn(k) += 1e-3 * normal(random);
      const auto body = identify::pseudo_inertia(other.values.segment<10>(10 * i));
      other.values.segment<10>(10 * i) = identify::standard_of(turn * body * turn.transpose());
    }
    ASSERT_GT(squares(other.values), found.full.distance * (1 - 1e-6));
  }
}

TEST(PseudoInertia, ThereAndBack) {
  const VectorXd p = VectorXd::LinSpaced(10, 1, 10);
  EXPECT_LT((identify::standard_of(identify::pseudo_inertia(p)) - p).norm(), 1e-14);
}

}  // namespace
}  // namespace qvgen::test
