// SPDX-License-Identifier: MIT
// Limbs of a compiled robot whose joints branch: each tip's pose and Jacobian, from the whole robot's joints;
// and the structure of its mass matrix.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/branch_factorisation.h>
#include <qvgen/robots/branched/dynamics_definitions.h>
#include <qvgen/robots/branched/limbs.h>
#include <qvgen/robots/branched/tips.h>
#include <qvgen/robots/branched_jaw/jacobian_definitions.h>
#include <qvgen/robots/branched_jaw/kinematics_definitions.h>
#include <qvgen/robots/branched_left_hand/jacobian_definitions.h>
#include <qvgen/robots/branched_left_hand/kinematics_definitions.h>
#include <qvgen/robots/branched_mast/jacobian_definitions.h>
#include <qvgen/robots/branched_mast/kinematics_definitions.h>
#include <qvgen/robots/branched_right_hand/jacobian_definitions.h>
#include <qvgen/robots/branched_right_hand/kinematics_definitions.h>

#include "reference/dynamics.h"
#include "reference/load.h"

namespace qvgen::test::limbs {
namespace {

namespace robot = qvgen::robots::branched;
// No library has these functions for it: they are compiled here.
using Scalar = long double;
using Joints = robot::JointVector<Scalar>;

class Limbs : public testing::Test {
 protected:
  Joints random_joints() {
    return Joints::NullaryExpr([&] { return Scalar(unit_(random_)); });
  }
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> unit_{-3, 3};
  reference::Chain chain_ = reference::load(QVGEN_BRANCHED);
};

TEST_F(Limbs, TipsMoveAsTheReferenceDoes) {
  const auto check = [&](std::size_t tip, const Joints& q, const auto& joints, const auto& pose,
                         const auto& jacobian) {
    const reference::VectorXd values = q.cast<double>();
    const reference::Isometry3d expected = reference::pose_of(chain_, chain_.frames[tip], values);
    EXPECT_TRUE(pose.matrix().template cast<double>().isApprox(expected.matrix(), 1e-12)) << tip;
    const reference::MatrixXd whole = columns_in<robot::dof>(joints, jacobian).template cast<double>();
    EXPECT_TRUE(whole.isApprox(reference::jacobian_of(chain_, chain_.frames[tip], values), 1e-12)) << tip;
  };
  for (int k = 0; k < 50; ++k) {
    const Joints q = random_joints();
    const auto left = values_of(robot::limbs::joints_of_left_hand, q);
    const auto right = values_of(robot::limbs::joints_of_right_hand, q);
    const auto jaw = values_of(robot::limbs::joints_of_jaw, q);
    const auto mast = values_of(robot::limbs::joints_of_mast, q);
    check(0, q, robot::limbs::joints_of_left_hand, robot::limbs::left_hand::homogeneous_transform(left),
          robot::limbs::left_hand::jacobian(left));
    check(1, q, robot::limbs::joints_of_right_hand, robot::limbs::right_hand::homogeneous_transform(right),
          robot::limbs::right_hand::jacobian(right));
    check(2, q, robot::limbs::joints_of_jaw, robot::limbs::jaw::homogeneous_transform(jaw),
          robot::limbs::jaw::jacobian(jaw));
    check(3, q, robot::limbs::joints_of_mast, robot::limbs::mast::homogeneous_transform(mast),
          robot::limbs::mast::jacobian(mast));
  }
}

/// All tips at once; the acceleration at constant rates is a difference in time of J qd.
TEST_F(Limbs, TipsAtOnceAreTheReferences) {
  const Scalar time = 1e-6L;
  for (int k = 0; k < 20; ++k) {
    const Joints q = random_joints(), qd = random_joints();
    const auto tips = robot::tip_motions<Scalar>(q, qd);
    const auto before = robot::tip_motions<Scalar>(Joints(q - time * qd), qd);
    const auto behind = robot::tip_motions<Scalar>(Joints(q + time * qd), qd);
    const reference::VectorXd values = q.cast<double>();
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const reference::Isometry3d expected = reference::pose_of(chain_, chain_.frames[i], values);
      EXPECT_TRUE(tips[i].pose.isometry().matrix().cast<double>().isApprox(expected.matrix(), 1e-12)) << i;
      EXPECT_TRUE(tips[i].jacobian.cast<double>().isApprox(
          reference::jacobian_of(chain_, chain_.frames[i], values), 1e-12))
          << i;
      const Eigen::Matrix<Scalar, 6, 1> rate = (behind[i].jacobian - before[i].jacobian) * qd / (2 * time);
      EXPECT_LE((tips[i].bias - rate).norm(), 1e-8L * (1 + rate.norm())) << i;
    }
  }
}

robot::BasicInertia<Scalar> plausible_inertia() {
  robot::BasicInertia<Scalar> inertia{};
  auto* values = reinterpret_cast<Scalar*>(&inertia);
  for (std::size_t i = 0; i < robot::inertia_names.size(); ++i) {
    const std::string name = robot::inertia_names[i];
    const bool is_moment = name[0] == 'I' && name[name.size() - 1] == name[name.size() - 2];
    values[i] = name[0] == 'm' ? Scalar(2) : is_moment ? Scalar(0.5) : Scalar(0.02);
  }
  return inertia;
}

TEST_F(Limbs, MassMatrixIsZeroWhereItsListSaysSoAndIsSolvedByBranches) {
  const auto inertia = plausible_inertia();
  Eigen::Matrix<bool, robot::dof, robot::dof> is_listed = Eigen::Matrix<bool, robot::dof, robot::dof>::Zero();
  for (const auto& [row, column] : robot::mass_matrix_nonzeros) {
    EXPECT_LE(row, column);
    is_listed(row, column) = is_listed(column, row) = true;
  }
  for (int k = 0; k < 50; ++k) {
    const Joints q = random_joints();
    const Eigen::Matrix<Scalar, robot::dof, robot::dof> mass = robot::mass_matrix<Scalar>(q, {}, inertia);
    for (int i = 0; i < robot::dof; ++i)
      for (int j = 0; j < robot::dof; ++j) EXPECT_EQ(mass(i, j) != 0, is_listed(i, j)) << i << " " << j;
    const BranchFactorisation factors(mass, robot::mass_matrix_parents);
    EXPECT_TRUE(factors.is_positive());
    const Joints force = random_joints();
    EXPECT_TRUE((mass * factors.solve(force)).isApprox(force, 1e-15L));
    const decltype(mass) negative = -mass;
    EXPECT_FALSE(BranchFactorisation(negative, robot::mass_matrix_parents).is_positive());
  }
}

}  // namespace
}  // namespace qvgen::test::limbs
