// SPDX-License-Identifier: MIT
// A platform on six cylinders: its legs for a place by hand, its place next to a seed for legs, Jacobians,
// forces and dynamics against the reference.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/stewart/assembly.h>

#include "platform_laws.h"
#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/loops.h"

namespace qvgen::test::loops {
namespace {

namespace arm = qvgen::robots::stewart;
using Q = arm::JointVector<double>;
using arm::Driven;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class Stewart : public testing::Test {
 protected:
  /// A place within what cylinders reach, without the platform's singular poses.
  Driven place() {
    std::uniform_real_distribution<double> slide(-0.15, 0.15), turn(-0.4, 0.4);
    Driven x;
    x << slide(random_), slide(random_), 0.5 + slide(random_), turn(random_), turn(random_), turn(random_);
    return x;
  }
  Q assembled() {
    const auto found = arm::assemble_from_outputs(place());
    EXPECT_EQ(found.status, Status::solved);
    return found[0].q;
  }
  const reference::LoopMechanism reference_ = reference::load_loops(QVGEN_PLATFORMS "stewart.toml");
  const reference::NamedFrame frame_ = reference_.chain.frames.front();
  std::mt19937 random_{5};
};

struct Arm {
  using Q = arm::JointVector<double>;
  using Driven = arm::Driven;
  static Driven legs_of(const Q& q) { return q(arm::driven_joints); }
  static auto follow(const Driven& legs, const Q& seed) { return arm::follow(legs, seed); }
  static auto assemble_from_outputs(const Driven& place) { return arm::assemble_from_outputs(place); }
};

TEST_F(Stewart, LegsForAPlaceAreDistancesOfPoints) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const Driven x = place();
    const auto found = arm::assemble_from_outputs(x);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0].q(arm::output_joints), x);
    EXPECT_LT(reference::gaps(reference_, found[0].q).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_GT(Arm::legs_of(found[0].q).minCoeff(), 0);
  }
}

TEST_F(Stewart, AnyPoseOfTheTopHasItsLegs) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const Q q = assembled();
    const auto pose = reference::pose_of(reference_.chain, frame_, q);
    const auto found = arm::inverse_kinematics_of_top(Pose<double>::from_isometry(pose), q);
    ASSERT_FALSE(found.empty());
    EXPECT_LT((found[0].q - q).norm(), 1e-12);
    for (const auto& row : found) EXPECT_LT((Arm::legs_of(row.q) - Arm::legs_of(q)).norm(), 1e-12);
  }
}

TEST_F(Stewart, ThePlaceNextToASeedIsFoundAndSaysSo) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k)
    ASSERT_NO_FATAL_FAILURE(platforms::expect_followed<Arm>(assembled(), random_));
}

TEST_F(Stewart, SaysWhereLegsCannotMeet) { platforms::expect_refused<Arm>(assembled(), place()); }

TEST_F(Stewart, ItsTopMovesAndIsHeldAsTheReferenceSays) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const Q q = assembled();
    const MatrixXd gap = reference::gap_jacobian(reference_, q), rates = arm::rates(q);
    EXPECT_LT((gap * rates).norm(), 1e-11 * (1 + rates.norm()));
    const MatrixXd expected = reference::jacobian_of(reference_.chain, frame_, q) * rates;
    EXPECT_LT((arm::jacobian_of_top(q) - expected).norm(), 1e-11 * (1 + expected.norm()));
    // A leg pushes with the force that its motor gives: the rods carry nothing else.
    Eigen::Matrix<double, 6, 1> wrench;
    for (double& each : wrench) each = std::uniform_real_distribution<double>(-9, 9)(random_);
    const Driven motors = arm::motor_forces_of_top(q, wrench);
    EXPECT_LT((arm::loop_forces_of_top(q, wrench) - motors).norm(), 1e-10 * (1 + motors.norm()));
    EXPECT_LT((expected.transpose() * wrench + motors).norm(), 1e-10 * (1 + motors.norm()));
  }
}

TEST_F(Stewart, ItsMotorsMoveItAsMultipliersSay) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const Q q = assembled();
    Driven ad, forces;
    for (double& each : ad) each = std::uniform_real_distribution<double>(-1, 1)(random_);
    for (double& each : forces) each = std::uniform_real_distribution<double>(-9, 9)(random_);
    const Q qd = arm::rates(q) * ad;
    VectorXd all = VectorXd::Zero(arm::dof);
    for (int i = 0; i < 6; ++i) all[arm::driven_joints[static_cast<std::size_t>(i)]] = forces[i];
    const VectorXd expected = reference::constrained_acceleration(reference_, q, qd, all);
    const Driven found = arm::driven_forward_dynamics(q, ad, forces, {}, {}, 9.81);
    EXPECT_LT((found - expected(arm::driven_joints)).norm(),
              1e-6 * (1 + expected.norm()) * (1 + qd.squaredNorm()));
  }
}

}  // namespace
}  // namespace qvgen::test::loops
