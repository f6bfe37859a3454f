// SPDX-License-Identifier: MIT
// A platform on three legs that swing in planes: its legs for a place by elimination of planes, its place
// next to a seed for legs, rates, forces and dynamics against the reference.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/three_rps/assembly.h>

#include "platform_laws.h"
#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/loops.h"

namespace qvgen::test::three_rps {
namespace {

namespace arm = qvgen::robots::three_rps;
using Q = arm::JointVector<double>;
using arm::Driven;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class ThreeRps : public testing::Test {
 protected:
  double number(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  /// Height and tilt of a platform above its base.
  Driven place() { return {number(0.35, 0.6), number(-0.4, 0.4), number(-0.4, 0.4)}; }
  /// The assembly in which the platform is turned least and its legs are longer than 0.
  Q assembled() {
    const auto found = arm::assemble_from_outputs(place());
    EXPECT_EQ(found.status, Status::solved);
    const Q* best = nullptr;
    for (const auto& row : found)
      if (row.q(arm::driven_joints).minCoeff() > 0 &&
          (best == nullptr || std::cos(row.q[yaw]) > std::cos((*best)[yaw])))
        best = &row.q;
    EXPECT_NE(best, nullptr);
    return *best;
  }
  static constexpr int yaw = 5;
  const reference::LoopMechanism reference_ = reference::load_loops(QVGEN_PLATFORMS "three_rps.toml");
  const reference::NamedFrame frame_ = reference_.chain.frames.front();
  std::mt19937 random_{6};
};

struct Arm {
  using Q = arm::JointVector<double>;
  using Driven = arm::Driven;
  static Driven legs_of(const Q& q) { return q(arm::driven_joints); }
  static auto follow(const Driven& legs, const Q& seed) { return arm::follow(legs, seed); }
  static auto assemble_from_outputs(const Driven& place) { return arm::assemble_from_outputs(place); }
};

TEST_F(ThreeRps, EveryAssemblyForAPlaceClosesAndNoneIsMissing) {
  const std::vector<Eigen::Index> given(arm::output_joints.begin(), arm::output_joints.end());
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const Driven x = place();
    const auto found = arm::assemble_from_outputs(x);
    ASSERT_EQ(found.size(), 16);  // two turns of the platform, and each leg with either sign
    for (const auto& row : found) {
      EXPECT_EQ(row.q(arm::output_joints), x);
      EXPECT_LT(reference::gaps(reference_, row.q).cwiseAbs().maxCoeff(), 1e-13);
    }
    if (k > QVGEN_LOOP_INPUTS / 100) continue;
    const auto all = reference::assemblies(reference_, found[0].q, given, 4000, static_cast<unsigned>(k), {});
    EXPECT_EQ(all.size(), 16U);
  }
}

TEST_F(ThreeRps, ThePlaceNextToASeedIsFoundAndSaysSo) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k)
    ASSERT_NO_FATAL_FAILURE(platforms::expect_followed<Arm>(assembled(), random_));
}

TEST_F(ThreeRps, SaysWhereLegsCannotMeet) { platforms::expect_refused<Arm>(assembled(), place()); }

TEST_F(ThreeRps, MovesAsTheReferenceSays) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const Q q = assembled();
    const MatrixXd gap = reference::gap_jacobian(reference_, q), rates = arm::rates(q);
    EXPECT_LT((gap * rates).norm(), 1e-11 * (1 + rates.norm()));
    const MatrixXd expected = reference::jacobian_of(reference_.chain, frame_, q) * rates;
    EXPECT_LT((arm::jacobian_of_top(q) - expected).norm(), 1e-11 * (1 + expected.norm()));
    Driven ad, forces;
    for (double& each : ad) each = number(-1, 1);
    for (double& each : forces) each = number(-9, 9);
    const Q qd = rates * ad;
    VectorXd all = VectorXd::Zero(arm::dof);
    for (int i = 0; i < 3; ++i) all[arm::driven_joints[static_cast<std::size_t>(i)]] = forces[i];
    const VectorXd moved = reference::constrained_acceleration(reference_, q, qd, all);
    const Driven found = arm::driven_forward_dynamics(q, ad, forces, {}, {}, 9.81);
    EXPECT_LT((found - moved(arm::driven_joints)).norm(), 1e-6 * (1 + moved.norm()) * (1 + qd.squaredNorm()));
  }
}

}  // namespace
}  // namespace qvgen::test::three_rps
