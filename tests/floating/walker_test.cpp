// SPDX-License-Identifier: MIT
// A walker whose ankles rods drive and whose neck a four-bar on its torso, compiled in C++: the same numbers
// as its C, which random mechanisms try (tests/loops/floating_rods_test.cpp), tips that move as they say, and
// contacts.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/branch_factorisation.h>
#include <qvgen/contacts.h>
#include <qvgen/floating_base.h>
#include <qvgen/robots/walker/assembly.h>

#include "qvgen_walker_loops.h"

namespace qvgen::test {
namespace {

namespace walker = robots::walker;
using walker::DrivenVelocity;

/// Random places with closed loops, and motions.
class Motions {
 public:
  explicit Motions(unsigned seed) : random_(seed) {}

  FloatingConfiguration<double, walker::dof> place() {
    while (true) {
      const auto found = walker::assemble(0.3 * vector<walker::driven_count>());
      if (found.empty()) continue;
      FloatingConfiguration<double, walker::dof> at;
      at.base = {Eigen::Quaterniond(vector<4>()).normalized(), vector<3>()};
      at.q = found[static_cast<int>(random_() % static_cast<unsigned>(found.size()))].q;
      if (walker::drive_measure(at.q) > 0.03) return at;
    }
  }
  template <int size>
  Eigen::Matrix<double, size, 1> vector() {
    return Eigen::Matrix<double, size, 1>::NullaryExpr([this] { return unit_(random_); });
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{-1, 1};
};

constexpr int size = walker::driven_velocity_size;
using Square = Eigen::Matrix<double, size, size, Eigen::RowMajor>;

TEST(Walker, HasTheNumbersOfItsC) {
  Motions motions(1);
  for (int k = 0; k < 5; ++k) {
    const auto at = motions.place();
    const DrivenVelocity ad = motions.vector<size>(), add = motions.vector<size>();
    const Eigen::Quaterniond& turn = at.base.orientation;
    Eigen::Matrix<double, 7, 1> base;
    base << turn.w(), turn.x(), turn.y(), turn.z(), at.base.position;
    Square masses;
    walker_driven_mass_matrix(base.data(), at.q.data(), nullptr, nullptr,
                              reinterpret_cast<double(*)[size]>(masses.data()));
    EXPECT_LT((walker::driven_mass_matrix(at) - masses).norm(), 1e-12 * masses.norm());
    DrivenVelocity forces, again;
    walker_driven_inverse_dynamics(base.data(), at.q.data(), ad.data(), add.data(), nullptr, nullptr, 9.80665,
                                   forces.data());
    EXPECT_LT((walker::driven_inverse_dynamics(at, ad, add) - forces).norm(), 1e-12 * forces.norm());
    walker_driven_forward_dynamics(base.data(), at.q.data(), ad.data(), forces.data(), nullptr, nullptr,
                                   9.80665, again.data());
    EXPECT_LT((again - add).norm(), 1e-9);
    EXPECT_LT((walker::driven_forward_dynamics(at, ad, forces) - add).norm(), 1e-9);
    Eigen::Matrix<double, walker::passive_count, 1> loops;
    walker_loop_forces(base.data(), at.q.data(), ad.data(), add.data(), nullptr, nullptr, 9.80665,
                       loops.data());
    EXPECT_LT((walker::loop_forces(at, ad, add) - loops).norm(), 1e-10 * (1 + loops.norm()));
  }
}

/// The place after a short time in which neither the base's own velocity nor the motors accelerate.
FloatingConfiguration<double, walker::dof> later(const FloatingConfiguration<double, walker::dof>& at,
                                                 const DrivenVelocity& ad, double time) {
  const walker::Driven rates = ad.tail<walker::driven_count>();
  const walker::JointVector<double> qd = walker::rates(at.q) * rates;
  const walker::JointVector<double> qdd = walker::accelerations(at.q, qd, walker::Driven::Zero());
  Eigen::Matrix<double, 6 + walker::dof, 1> way;
  way << time * ad.head<6>(), time * qd + time * time / 2 * qdd;
  return integrated(at, way);
}

TEST(Walker, TipsMoveAsTheySay) {
  Motions motions(2);
  constexpr double time = 1e-4;
  for (const walker::Tip tip : {walker::Tip::foot_l, walker::Tip::foot_r, walker::Tip::head}) {
    const auto at = motions.place();
    const DrivenVelocity ad = motions.vector<size>();
    const auto now = walker::driven_tip_motion(tip, at, ad);
    const auto pose = [&](double t) { return walker::driven_tip_motion(tip, later(at, ad, t), ad).pose; };
    const auto before = pose(-time), behind = pose(time);
    const Eigen::Vector3d velocity = (behind.position - before.position) / (2 * time);
    const Eigen::Vector3d bias = (behind.position - 2 * now.pose.position + before.position) / (time * time);
    const Eigen::AngleAxisd turned(behind.orientation * before.orientation.conjugate());
    Eigen::Matrix<double, 6, 1> expected;
    expected << velocity, turned.axis() * turned.angle() / (2 * time);
    EXPECT_LT((now.jacobian * ad - expected).norm(), 1e-6);
    EXPECT_LT((now.bias.head<3>() - bias).norm(), 1e-5);
  }
}

/// Both feet stand: their tips do not accelerate, and forces of contacts are all that is between the motions.
TEST(Walker, StandsOnItsFeet) {
  Motions motions(3);
  const auto at = motions.place();
  const DrivenVelocity ad = motions.vector<size>(), forces = motions.vector<size>();
  const auto masses = walker::driven_mass_matrix(at);
  const DrivenVelocity still = walker::driven_inverse_dynamics(at, ad, DrivenVelocity::Zero());
  ContactSet<double, size, 9> contacts;
  const auto left = walker::driven_tip_motion(walker::Tip::foot_l, at, ad);
  const auto right = walker::driven_tip_motion(walker::Tip::foot_r, at, ad);
  ASSERT_TRUE(contacts.add(left, ContactKind::rigid) && contacts.add(right, ContactKind::point));
  const BranchFactorisation factors(masses, walker::driven_mass_matrix_parents);
  const auto found = contacts.forward_dynamics(factors, DrivenVelocity(forces - still));
  ASSERT_EQ(found.status, ContactStatus::solved);
  EXPECT_LT((left.jacobian * found.qdd + left.bias).norm(), 1e-9);
  EXPECT_LT((right.jacobian * found.qdd + right.bias).head<3>().norm(), 1e-9);
  const DrivenVelocity pushed = contacts.jacobian().transpose() * found.forces;
  EXPECT_LT((masses * found.qdd - (forces - still) - pushed).norm(), 1e-9 * (1 + pushed.norm()));
}

}  // namespace
}  // namespace qvgen::test
