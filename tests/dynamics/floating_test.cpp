// SPDX-License-Identifier: MIT
// Dynamics of robots whose base floats, as they are derived. The reference has six joints in place of the
// floating base, three slides and three turns: its recursion knows no floating base, and shares no code. What
// belongs to those joints' rates is carried over to the base's own motion by the kinematics written here.
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "floating_motion.h"
#include "optimise/dynamics.h"
#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace qvgen::test::trees {
namespace {

using derive::dynamics::Effects;

class RandomFloatingTrees : public testing::TestWithParam<unsigned> {};

TEST_P(RandomFloatingTrees, EveryQuantityIsThatOfSixJointsInPlaceOfTheBase) {
  const Seeds seeds(GetParam());
  for (unsigned seed = seeds.first; seed < seeds.end; ++seed) {
    const auto written = [&](Composed as) {
      return TreeWriter(seed, seed % 4 == 1 ? as : Composed::none)
          .floating_tree(1 + static_cast<int>(seed % 9), seed % 3 == 0);
    };
    const std::string floating = written(Composed::as_one).floating;
    const std::string with_joints = written(Composed::written_out).with_joints;
    const model::Robot robot = read(floating);
    const reference::Chain chain = reference::load_text(with_joints);
    Motion motion(robot, seed);
    const BaseMotion base(seed + 1000);
    const BaseMotion unused_base(seed + 2000);
    const VectorXd base_force = unused_base.q;
    add_base(base, base_force, motion);
    const VectorXd q = joined(base.q, motion.q), qd = joined(base.qd, motion.qd);
    const VectorXd qdd = joined(base.qdd, motion.qdd), zero = VectorXd::Zero(q.size());
    const VectorXd velocity = joined(base.velocity, motion.qd);
    const Eigen::Index n = q.size();
    const MatrixXd by_rates = base.by_rates(motion.q.size());
    const MatrixXd back = reference::inverse(by_rates);
    const auto to_base = [&](const VectorXd& torque) { return (back.transpose() * torque).eval(); };
    const derive::dynamics::FormulationOptions choices;

    expect_close(values_of(inverse_dynamics(robot, choices), motion),
                 to_base(reference::inverse_dynamics(chain, q, qd, qdd)), floating);
    const VectorXd gravity = to_base(reference::inverse_dynamics(chain, q, zero, zero));
    expect_close(values_of(inverse_dynamics(robot, choices, Effects::gravity), motion), gravity, floating);
    const MatrixXd mass = symmetric(values_of(mass_matrix(robot, choices), motion), n);
    expect_close(mass, back.transpose() * reference::mass_matrix(chain, q) * back, floating);
    const VectorXd momentum = values_of(momentum_matrix(robot, choices), motion);
    using RowMajor = Eigen::Matrix<double, -1, -1, Eigen::RowMajor>;
    expect_close(Eigen::Map<const RowMajor>(momentum.data(), 6, n), mass.topRows(6), floating);
    const double kinetic = reference::kinetic_energy(chain, q, qd);
    EXPECT_NEAR(values_of(kinetic_energy(robot, choices), motion)[0], kinetic, 1e-12 * (1 + kinetic));
    const double potential = reference::potential_energy(chain, q);
    EXPECT_NEAR(values_of(potential_energy(robot, choices), motion)[0], potential,
                1e-12 * (1 + std::abs(potential)))
        << floating;
    const Vector3d centre =
        base.rotation * values_of(centre_of_mass(robot, choices), motion).head<3>() + base.q.head<3>();
    expect_close(centre, reference::centre_of_mass(chain, q), floating);

    // The accelerations of the base's six joints, put into the reference, take the forces that were given.
    const VectorXd found = values_of(forward_dynamics(robot, choices), motion);
    VectorXd found_qdd = found;
    const Vector3d w = base.velocity.tail<3>(), v = base.velocity.head<3>();
    found_qdd.head<3>() = base.rotation * (found.head<3>() + w.cross(v));
    const Vector3d axes_part = base.acceleration.tail<3>() - base.axes * base.qdd.tail<3>();
    found_qdd.segment<3>(3) = base.axes.inverse() * (found.segment<3>(3) - axes_part);
    const VectorXd force = joined(base_force, motion.force);
    expect_close(to_base(reference::inverse_dynamics(chain, q, qd, found_qdd)), force, floating,
                 1e-12 * (1 + mass.norm() * found.norm()));
    const auto other = forward_dynamics_by_articulated_bodies(robot, choices);
    EXPECT_EQ(other.has_value(), !model::has_followers(robot)) << floating;
    if (other)
      expect_close(mass * values_of(*other, motion), mass * found, floating,
                   1e-12 * (1 + mass.norm() * found.norm()));

    const VectorXd coriolis = values_of(coriolis_matrix(robot, choices), motion);
    const MatrixXd c = Eigen::Map<const RowMajor>(coriolis.data(), n, n);
    expect_close(c * velocity, values_of(inverse_dynamics(robot, choices, Effects::velocity), motion),
                 floating);
    if (HasFailure()) return;
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomFloatingTrees, testing::Values(1, 51, 101, 151));

/// dM/dt - 2C is skew-symmetric; dM/dt by a central difference along the velocity.
TEST(FloatingTrees, RateOfTheMassMatrixLessTwiceCoriolisIsSkewSymmetric) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const std::string text =
        TreeWriter(seed).floating_tree(2 + static_cast<int>(seed % 6), seed % 3 == 0).floating;
    const model::Robot robot = read(text);
    Motion motion(robot, seed);
    add_base(BaseMotion(seed), VectorXd::Zero(6), motion);
    const Formulation mass = derive::dynamics::mass_matrix(robot, {});
    const auto n = static_cast<Eigen::Index>(model::coordinate_count(robot));
    const auto mass_after = [&](double time) {
      Motion moved = motion;
      for (const model::Joint& joint : robot.joints)
        moved.values[joint.variable] +=
            time * motion.values.at(derive::dynamics::velocity_of(joint.variable));
      return symmetric(values_of(mass, moved), n);
    };
    const double step = 1e-5;
    const MatrixXd rate = (mass_after(step) - mass_after(-step)) / (2 * step);
    const VectorXd entries = values_of(derive::dynamics::coriolis_matrix(robot, {}), motion);
    const MatrixXd c = Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(entries.data(), n, n);
    expect_close(c + c.transpose(), rate, text, 1e-7);
  }
}

/// A base without inertia, two links that are points: turns about the line between them move nothing.
TEST(FloatingTrees, MotionsWithoutMassAreRefused) {
  const std::string text =
      "name = \"r\"\ntitle = \"r\"\n[floating_base]\nmass = 1\n[[joint]]\ntype = \"revolute\"\naxis = "
      "\"+z\"\n"
      "variable = \"a\"\nlink = [1, 0, 0]\nmass = 1\n[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable "
      "= \"b\"\n"
      "link = [1, 0, 0]\nmass = 2\n";
  EXPECT_THROW(derive::dynamics::forward_dynamics(read(text), {}), derive::dynamics::MasslessLink);
}

/// Search and certificate, which throws if any output differs from the plain recursion.
TEST(FloatingTrees, PassTheirCertificates) {
  const optimise::DynamicsEffort little{.trial_steps = 500, .final_steps = 2'000, .certificate_points = 1};
  for (const unsigned seed : {3U, 4U, 8U}) {
    const std::string text = TreeWriter(seed).floating_tree(3, seed % 3 == 0).floating;
    const optimise::DynamicsModel model = optimise::dynamics_model(read(text), little);
    std::vector<optimise::DynamicsQuantity> all = optimise::dynamics_quantities();
    for (const auto& quantity : optimise::floating_base_quantities(model.described)) all.push_back(quantity);
    for (const auto& quantity : optimise::mass_quantities(model.described)) all.push_back(quantity);
    for (const optimise::DynamicsQuantity& quantity : all)
      EXPECT_NO_THROW(generate_dynamics(model, quantity, little)) << quantity.name << "\n" << text;
  }
}

}  // namespace
}  // namespace qvgen::test::trees
