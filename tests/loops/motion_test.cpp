// SPDX-License-Identifier: MIT
// Rates, Jacobians and dynamics of every mechanism: rates are what neighbouring assemblies say, tips move as
// the reference's frames, motors see what multipliers say, and power in is power out.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mechanism_under_test.h"
#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/loops.h"

namespace qvgen::test::loops {
namespace {

constexpr int motions = 25;
/// Next to dead centres nothing is compared: differences lose their digits there. The measure is a product of
/// as many sines as there are equations, and a planar 3-RPR or a weld in space has six.
double far_from_dead_centres(const std::string& name) {
  for (const char* many : {"planar_3rpr", "rccc", "seven_turns"})
    if (name == many) return 2e-3;
  return 0.03;
}

struct Motion {
  VectorXd a, ad, add, q, qd;
};

class Motions : public testing::TestWithParam<MechanismUnderTest> {
 protected:
  /// A random assembly that the reference has found; nothing where it is at the end of what can be assembled.
  VectorXd sampled() {
    VectorXd start = VectorXd::Zero(mechanism_.dof);
    auto found = reference::assemblies(reference_, start, {}, 1, static_cast<unsigned>(random_()));
    if (found.empty() && !reference_.outputs.empty()) {  // then from a platform's place
      std::uniform_real_distribution<double> place(-0.5, 0.5);
      for (const Eigen::Index joint : reference_.outputs) start[joint] = place(random_);
      found =
          reference::assemblies(reference_, start, reference_.outputs, 1, static_cast<unsigned>(random_()));
    }
    if (found.empty()) return {};
    VectorXd a(mechanism_.driven);
    for (int i = 0; i < mechanism_.driven; ++i)
      a[i] = found[0][mechanism_.driven_joints[static_cast<std::size_t>(i)]];
    return mechanism_.follow(a, found[0]);
  }
  /// Random assemblies with rates, apart from dead centres.
  std::vector<Motion> motions_of(int count) {
    std::uniform_real_distribution<double> turn(-3.1, 3.1);
    std::vector<Motion> result;
    for (int k = 0; k < 4000 && static_cast<int>(result.size()) < count; ++k) {
      Motion m;
      m.a = m.ad = m.add = VectorXd(mechanism_.driven);
      for (VectorXd* v : {&m.ad, &m.add})
        for (double& x : *v) x = turn(random_);
      m.q = sampled();
      if (m.q.size() == 0) continue;
      for (int i = 0; i < mechanism_.driven; ++i)
        m.a[i] = m.q[mechanism_.driven_joints[static_cast<std::size_t>(i)]];
      if (mechanism_.drive_measure(m.q) < far_from_dead_centres(mechanism_.name)) continue;
      m.qd = mechanism_.rates(m.q) * m.ad;
      result.push_back(m);
    }
    EXPECT_EQ(static_cast<int>(result.size()), count);
    return result;
  }
  /// Joints after a time on the path of constant acceleration.
  VectorXd after(const Motion& m, double time) {
    const VectorXd a = m.a + time * m.ad + time * time / 2 * m.add;
    const Set near = mechanism_.assemble_near(a, m.q + time * m.qd);
    return near.rows.empty() ? VectorXd::Constant(m.q.size(), std::nan("")) : near.rows.front().q;
  }

  const MechanismUnderTest& mechanism_ = GetParam();
  const reference::LoopMechanism reference_ = reference::load_loops(mechanism_.description);
  std::mt19937 random_{5};
};

TEST_P(Motions, RatesAndAccelerationsAreDifferencesOfAssemblies) {
  const double step = 1e-4;
  for (const Motion& m : motions_of(motions)) {
    const VectorXd before = after(m, -step), behind = after(m, step);
    const double scale = 1 + m.qd.norm();
    EXPECT_LT(((behind - before) / (2 * step) - m.qd).norm(), 1e-4 * scale * scale * scale);
    const VectorXd second = (behind - 2 * m.q + before) / (step * step);
    const VectorXd qdd = mechanism_.accelerations(m.q, m.qd, m.add);
    EXPECT_LT((second - qdd).norm(), 1e-3 * (1 + qdd.norm()) * scale * scale);
  }
}

TEST_P(Motions, LoopsAreFollowedToTheNextAssembly) {
  for (const Motion& m : motions_of(motions)) {
    const VectorXd followed = mechanism_.follow(m.a, m.q + 1e-3 * m.qd / (1 + m.qd.norm()));
    ASSERT_EQ(followed.size(), m.q.size());
    EXPECT_LT((followed - m.q).norm(), 1e-9);
    EXPECT_EQ(mechanism_.follow(m.a, VectorXd::Constant(m.q.size(), std::nan(""))).size(), 0);
  }
}

TEST_P(Motions, KeepTheLoopsClosedToFirstAndSecondOrder) {
  for (const Motion& m : motions_of(motions)) {
    const MatrixXd jacobian = reference::gap_jacobian(reference_, m.q);
    EXPECT_LT((jacobian * m.qd).norm(), 1e-11 * (1 + m.qd.norm()) * reference_.size);
    const double step = 1e-5;
    const MatrixXd rate = (reference::gap_jacobian(reference_, m.q + step * m.qd) -
                           reference::gap_jacobian(reference_, m.q - step * m.qd)) /
                          (2 * step);
    const VectorXd qdd = mechanism_.accelerations(m.q, m.qd, m.add);
    const double scale = 1 + qdd.norm() + m.qd.squaredNorm();
    EXPECT_LT((jacobian * qdd + rate * m.qd).norm(), 1e-7 * scale * (1 + m.qd.norm()) * reference_.size);
  }
}

TEST_P(Motions, TipsAreTheReferencesFrames) {
  for (const Motion& m : motions_of(motions)) {
    for (const Tip& tip : mechanism_.tips) {
      for (const reference::NamedFrame& frame : reference_.chain.frames) {
        if (frame.name != tip.name) continue;
        EXPECT_LT((tip.pose(m.q) - reference::pose_of(reference_.chain, frame, m.q).matrix()).norm(), 1e-12);
        const MatrixXd expected =
            reference::jacobian_of(reference_.chain, frame, m.q) * mechanism_.rates(m.q);
        EXPECT_LT((tip.jacobian(m.q) - expected).norm(), 1e-10 * (1 + expected.norm()));
      }
    }
  }
}

TEST_P(Motions, MotorsMoveTheMechanismAsMultipliersSay) {
  for (const Motion& m : motions_of(motions)) {
    VectorXd forces(mechanism_.driven), all = VectorXd::Zero(mechanism_.dof);
    for (double& force : forces) force = std::uniform_real_distribution<double>(-5, 5)(random_);
    for (int i = 0; i < mechanism_.driven; ++i)
      all[mechanism_.driven_joints[static_cast<std::size_t>(i)]] = forces[i];
    const VectorXd expected = reference::constrained_acceleration(reference_, m.q, m.qd, all);
    const VectorXd found = mechanism_.forward_dynamics(m.q, m.ad, forces);
    for (int i = 0; i < mechanism_.driven; ++i)
      EXPECT_NEAR(found[i], expected[mechanism_.driven_joints[static_cast<std::size_t>(i)]],
                  2e-6 * (1 + expected.norm()) * (1 + m.qd.norm()));
    EXPECT_LT((mechanism_.inverse_dynamics(m.q, m.ad, found) - forces).norm(),
              1e-9 * (1 + forces.norm() + (mechanism_.mass_matrix(m.q) * found).norm()));
  }
}

TEST_P(Motions, FollowingSaysWhetherADeadCentreWasCrossed) {
  for (const Motion& m : motions_of(motions)) {
    EXPECT_FALSE(mechanism_.crosses(m.a, m.q + 1e-4 * m.qd / (1 + m.qd.norm())));
    // Another assembly for the same motors, on the other side: straight ways between them meet a dead centre.
    const Set set = mechanism_.assemble(m.a);
    const auto side = [&](const VectorXd& q) {
      const MatrixXd by = mechanism_.loop_jacobian(q);
      MatrixXd passive(by.rows(), by.rows());
      for (Eigen::Index i = 0; i < by.rows(); ++i)
        passive.col(i) = by.col(mechanism_.passive_joints[static_cast<std::size_t>(i)]);
      return reference::determinant(passive) > 0;
    };
    for (const Row& row : set.rows)
      for (const Row& other : set.rows) {
        const VectorXd seed = row.q + 0.4 * (other.q - row.q);
        const VectorXd end = mechanism_.follow(m.a, seed);
        if (end.size() == 0 || (end - seed).norm() < 1e-3) continue;
        EXPECT_EQ(mechanism_.crosses(m.a, seed), side(seed) != side(end));
      }
  }
}

TEST_P(Motions, LoopsAndMotorsTogetherMoveTheOpenTree) {
  for (const Motion& m : motions_of(motions)) {
    const VectorXd qdd = mechanism_.accelerations(m.q, m.qd, m.add);
    const VectorXd motors = mechanism_.inverse_dynamics(m.q, m.ad, m.add);
    VectorXd given = mechanism_.loop_jacobian(m.q).transpose() * mechanism_.loop_forces(m.q, m.ad, m.add);
    for (int i = 0; i < mechanism_.driven; ++i)
      given[mechanism_.driven_joints[static_cast<std::size_t>(i)]] += motors[i];
    const VectorXd expected = reference::inverse_dynamics(reference_.chain, m.q, m.qd, qdd);
    EXPECT_LT((given - expected).norm(), 1e-9 * (1 + expected.norm()) * (1 + given.norm()));
  }
}

TEST_P(Motions, MotorsAndLoopsHoldAWrenchOnTheTip) {
  for (const Motion& m : motions_of(motions)) {
    for (const Tip& tip : mechanism_.tips) {
      for (const reference::NamedFrame& frame : reference_.chain.frames) {
        if (frame.name != tip.name) continue;
        VectorXd wrench(6);
        for (double& x : wrench) x = std::uniform_real_distribution<double>(-5, 5)(random_);
        VectorXd sum = mechanism_.loop_jacobian(m.q).transpose() * tip.loop_forces(m.q, wrench) +
                       reference::jacobian_of(reference_.chain, frame, m.q).transpose() * wrench;
        const VectorXd motors = tip.motor_forces(m.q, wrench);
        for (int i = 0; i < mechanism_.driven; ++i)
          sum[mechanism_.driven_joints[static_cast<std::size_t>(i)]] += motors[i];
        EXPECT_LT(sum.norm(), 1e-10 * (1 + motors.norm()) * (1 + wrench.norm()));
      }
    }
  }
}

TEST_P(Motions, PowerInIsPowerOut) {
  for (const Motion& m : motions_of(motions)) {
    const double power = m.ad.dot(mechanism_.inverse_dynamics(m.q, m.ad, m.add));
    double lost = 0;
    for (Eigen::Index i = 0; i < m.qd.size(); ++i) {
      const reference::Joint& joint = reference_.chain.joints[static_cast<std::size_t>(i)];
      lost += joint.viscous_friction * m.qd[i] * m.qd[i] + joint.coulomb_friction * std::abs(m.qd[i]);
    }
    const auto energy = [&](double time) {
      const VectorXd q = after(m, time), qd = mechanism_.rates(q) * (m.ad + time * m.add);
      return reference::kinetic_energy(reference_.chain, q, qd) +
             reference::potential_energy(reference_.chain, q);
    };
    const double step = 1e-4 / (1 + m.qd.norm());
    const double rate = (energy(step) - energy(-step)) / (2 * step);
    const double scale = std::abs(power) + lost + std::abs(energy(0)) + 1;
    EXPECT_NEAR(power, rate + lost, 2e-4 * scale * (1 + m.qd.norm()));
  }
}

TEST_P(Motions, TheMassMatrixIsTheKineticEnergys) {
  for (const Motion& m : motions_of(motions)) {
    const double energy = reference::kinetic_energy(reference_.chain, m.q, m.qd);
    EXPECT_NEAR(m.ad.dot(mechanism_.mass_matrix(m.q) * m.ad) / 2, energy, 1e-11 * (1 + energy));
  }
}

INSTANTIATE_TEST_SUITE_P(Loops, Motions, testing::ValuesIn(mechanisms()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace qvgen::test::loops
