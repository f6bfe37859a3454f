// SPDX-License-Identifier: MIT
// Tips of a robot whose base floats, and contacts of any of them: poses and Jacobians are the reference's,
// contacts stay where they are, what repeats or contradicts itself is marked, and no heap is used.
#include <gtest/gtest.h>
#include <qvgen/contacts.h>

#include "quad.h"

/// The README's.
bool step(qvgen::robots::quad::Configuration<double>& at, qvgen::robots::quad::Velocity<double>& qd,
          const qvgen::robots::quad::Velocity<double>& torque);

namespace qvgen::test::floating {
namespace {

using Contacts = ContactSet<double, quad::velocity_size, 24>;
using Mass = BranchFactorisation<double, std::decay_t<decltype(quad::mass_matrix_parents)>>;

const reference::NamedFrame& frame_of(const std::string& tip) {
  for (const reference::NamedFrame& frame : reference_chain().frames)
    if (frame.name == tip) return frame;
  throw std::runtime_error("no frame " + tip);
}

TEST(Tips, AreTheReferences) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const QuadMotion m(seed);
    const auto tips = quad::tip_motions(m.at, m.qd);
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const reference::NamedFrame& frame = frame_of(quad::tip_names[i]);
      const auto pose = reference::pose_of(reference_chain(), frame, m.q_of_joints);
      expect_close(tips[i].pose.isometry().matrix(), pose.matrix());
      expect_close(quad::tip_pose(static_cast<quad::Tip>(i), m.at).isometry().matrix(), pose.matrix());
      expect_close(tips[i].jacobian,
                   product(reference::jacobian_of(reference_chain(), frame, m.q_of_joints), m.back));
    }
  }
}

/// By a difference in time along the motion at constant velocities.
TEST(Tips, BiasIsTheAccelerationAtConstantVelocities) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const double time = 1e-5;
    const auto before = quad::tip_motions(integrated(m.at, -time * m.qd), m.qd);
    const auto behind = quad::tip_motions(integrated(m.at, time * m.qd), m.qd);
    const auto now = quad::tip_motions(m.at, m.qd);
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Matrix change = behind[i].jacobian - before[i].jacobian;
      expect_close(now[i].bias, product(change, m.qd) / (2 * time), 1e-7);
    }
  }
}

TEST(Tips, ColumnsThatAreNotListedAreZero) {
  const QuadMotion m(3);
  const auto tip = quad::tip_motion(quad::Tip::hl_foot, m.at, m.qd);
  for (int k = 0; k < quad::velocity_size; ++k) {
    const auto& columns = quad::columns_of_hl_foot;
    const bool is_listed = std::find(columns.begin(), columns.end(), k) != columns.end();
    EXPECT_EQ(!tip.jacobian.col(k).isZero(0), is_listed) << k;
  }
}

TEST(Tips, RelativeJacobianIsTheVelocityThatOneTipSeesOfAnother) {
  const QuadMotion m(6);
  const auto tips = quad::tip_motions(m.at, m.qd);
  const double time = 1e-6;
  const auto seen = [&](double t) {
    const auto moved = quad::tip_motions(integrated(m.at, t * m.qd), m.qd);
    return moved[0].pose.inverse() * moved[3].pose;
  };
  const Vector twist = product(relative_jacobian(tips[0], tips[3]), m.qd);
  const Eigen::Vector3d rate = (seen(time).position - seen(-time).position) / (2 * time);
  EXPECT_LE((twist.head<3>() - rate).norm(), 1e-8);
  const auto still = relative_jacobian(tips[0], tips[3]);
  EXPECT_LE(still.leftCols<6>().norm(), 1e-12);  // where the base is makes no difference
}

/// A wrench on a tip does the work that inverse dynamics lack.
TEST(Tips, WrenchesAreGeneralisedForcesByPower) {
  const QuadMotion m(2);
  const auto tip = quad::tip_motion(quad::Tip::fr_foot, m.at, m.qd);
  Eigen::Matrix<double, 6, 1> wrench;
  wrench << 3, -2, 50, 1, 2, -1;
  const Vector force = generalised_force(tip, wrench), moves = product(tip.jacobian, m.qd);
  EXPECT_NEAR(force.dot(Vector(m.qd)), Vector(wrench).dot(moves), 1e-11);
}

struct Stance {
  explicit Stance(unsigned seed)
      : m(seed),
        tips(quad::tip_motions(m.at, m.qd)),
        matrix(quad::mass_matrix(m.at)),
        mass(quad::mass_matrix(m.at), quad::mass_matrix_parents),
        force(m.force - quad::coriolis_torque(m.at, m.qd) - quad::gravity_torque(m.at, {}, {}, g)) {}
  QuadMotion m;
  std::array<TipMotion<double, quad::velocity_size>, quad::tip_count> tips;
  Matrix matrix;
  Mass mass;
  Rates force;
};

/// Every subset of the feet, points or rigid: the feet do not accelerate, and Newton holds.
TEST(Contacts, KeepEverySubsetOfFeetInPlace) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Stance s(seed);
    for (unsigned subset = 0; subset < 81; ++subset) {  // nothing, a point or rigid for each foot
      Contacts contacts;
      unsigned rest = subset;
      for (const auto& tip : s.tips) {
        if (rest % 3 > 0) {
          EXPECT_TRUE(contacts.add(tip, rest % 3 == 1 ? ContactKind::point : ContactKind::rigid));
        }
        rest /= 3;
      }
      const auto found = contacts.forward_dynamics(s.mass, s.force);
      const Matrix jacobian = contacts.jacobian(), bias = contacts.bias();
      expect_close(product(s.matrix, found.qdd), s.force + product(jacobian.transpose(), found.forces), 1e-9);
      // A leg has three joints: each rigid foot takes six motions of the base and its leg.
      if (contacts.rows() > 0 && found.status != ContactStatus::contradictory) {
        EXPECT_LE((product(jacobian, found.qdd) + bias).norm(), 1e-6 * (1 + bias.norm())) << subset;
      }
      const bool is_full = found.rank == contacts.rows();
      EXPECT_EQ(found.status == ContactStatus::solved, is_full) << subset;
      EXPECT_NE(found.status, ContactStatus::invalid);
    }
  }
}

TEST(Contacts, AFootThatIsAddedTwiceChangesForcesAloneAndIsMarked) {
  const Stance s(7);
  Contacts once, twice;
  once.add(s.tips[0], ContactKind::point);
  once.add(s.tips[2], ContactKind::point);
  twice = once;
  twice.add(s.tips[0], ContactKind::point);
  const auto a = once.forward_dynamics(s.mass, s.force), b = twice.forward_dynamics(s.mass, s.force);
  EXPECT_EQ(a.status, ContactStatus::solved);
  EXPECT_EQ(b.status, ContactStatus::dependent);
  EXPECT_EQ(b.rank, 6);
  EXPECT_LE((a.qdd - b.qdd).norm(), 1e-9 * a.qdd.norm());
  EXPECT_LE((b.forces.head<3>() + b.forces.tail<3>() - a.forces.head<3>()).norm(), 1e-8 * a.forces.norm());
}

TEST(Contacts, WhatContradictsItselfIsMarked) {
  const Stance s(8);
  Contacts contacts;
  Eigen::Matrix<double, 6, 1> up = Eigen::Matrix<double, 6, 1>::Zero();
  up[2] = 1;
  contacts.add(s.tips[0], ContactKind::point);
  contacts.add(s.tips[0], ContactKind::point, up);
  const auto found = contacts.forward_dynamics(s.mass, s.force);
  EXPECT_EQ(found.status, ContactStatus::contradictory);
  EXPECT_TRUE(found.qdd.allFinite() && found.forces.allFinite());
}

TEST(Contacts, InvalidArgumentsAreMarkedAndGiveNoNaN) {
  Stance s(9);
  Contacts contacts;
  contacts.add(s.tips[1], ContactKind::rigid);
  Rates force = s.force;
  force[4] = std::numeric_limits<double>::quiet_NaN();
  const auto found = contacts.forward_dynamics(s.mass, force);
  EXPECT_EQ(found.status, ContactStatus::invalid);
  EXPECT_TRUE(found.qdd.isZero(0) && found.forces.isZero(0));
  const Mass negative(-s.matrix, quad::mass_matrix_parents);
  EXPECT_EQ(contacts.forward_dynamics(negative, s.force).status, ContactStatus::invalid);
  s.tips[2].jacobian(3, 3) = std::numeric_limits<double>::infinity();
  contacts.add(s.tips[2], ContactKind::rigid);
  EXPECT_EQ(contacts.forward_dynamics(s.mass, s.force).status, ContactStatus::invalid);
}

TEST(Contacts, ThereIsRoomForSoManyRowsAndNoMore) {
  const Stance s(1);
  ContactSet<double, quad::velocity_size, 8> few;
  EXPECT_TRUE(few.add(s.tips[0], ContactKind::rigid));
  EXPECT_FALSE(few.add(s.tips[1], ContactKind::point));
  EXPECT_EQ(few.rows(), 6);
}

TEST(Contacts, ImpactsStopFeetTakeEnergyAndBounceThemBack) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Stance s(seed);
    Contacts contacts;
    contacts.add(s.tips[0], ContactKind::point);
    contacts.add(s.tips[3], ContactKind::rigid);
    const auto stopped = contacts.impact(s.mass, s.m.qd);
    EXPECT_LE(product(contacts.jacobian(), stopped.qdd).norm(), 1e-9);
    const auto energy = [&](const Vector& qd) { return qd.dot(Vector(product(s.matrix, qd))) / 2; };
    EXPECT_LT(energy(stopped.qdd), energy(s.m.qd));
    const auto bounced = contacts.impact(s.mass, s.m.qd, 1);
    EXPECT_NEAR(energy(bounced.qdd), energy(s.m.qd), 1e-9 * energy(s.m.qd));
    EXPECT_LE(product(contacts.jacobian(), bounced.qdd + s.m.qd).norm(), 1e-8);
  }
}

TEST(Contacts, OperationalSpaceInertiaIsWhatATipFeels) {
  const Stance s(5);
  Contacts contacts;
  contacts.add(s.tips[1], ContactKind::rigid);
  int rank = 0;
  const auto inertia = contacts.operational_space_inertia(s.mass, &rank);
  EXPECT_EQ(rank, 6);
  const Matrix jacobian = contacts.jacobian();
  const Matrix inverse = product(jacobian, product(reference::inverse(s.matrix), jacobian.transpose()));
  EXPECT_LE((product(inertia, inverse) - Matrix::Identity(6, 6)).norm(), 1e-8);
}

TEST(Contacts, TheReadmesStepKeepsFeetInPlace) {
  const QuadMotion m(11);
  At at = m.at;
  Rates qd = Rates::Zero();
  const auto before = quad::tip_pose(quad::Tip::fl_foot, at);
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(::step(at, qd, Rates::Zero()));
  EXPECT_LE(linear_distance(before, quad::tip_pose(quad::Tip::fl_foot, at)), 1e-3);
  EXPECT_GT(difference(m.at, at).norm(), 1e-3);
}

TEST(Contacts, UseNoHeap) {
  const Stance s(6);
  Contacts contacts;
  for (const auto& tip : s.tips) contacts.add(tip, ContactKind::rigid);
  Eigen::internal::set_is_malloc_allowed(false);
  const auto found = contacts.forward_dynamics(s.mass, s.force);
  const auto stopped = contacts.impact(s.mass, s.m.qd);
  const auto inertia = contacts.operational_space_inertia(s.mass);
  const auto tips = quad::tip_motions(s.m.at, s.m.qd);
  Eigen::internal::set_is_malloc_allowed(true);
  EXPECT_TRUE(found.qdd.allFinite() && stopped.qdd.allFinite() && inertia.allFinite());
  EXPECT_TRUE(tips[0].jacobian.allFinite());
}

}  // namespace
}  // namespace qvgen::test::floating
