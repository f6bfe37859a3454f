// SPDX-License-Identifier: MIT
// Dynamics of joints that branch. Random trees of turns, slides, joints that follow others and links without
// mass, their frames turned anyhow: each quantity, as it is derived, against the tests' own recursion, which
// shares no code; and a few of them through search and certificate.
#include <gtest/gtest.h>

#include "description/write.h"
#include "optimise/dynamics.h"
#include "random_tree.h"
#include "reference/dynamics.h"
#include "reference/load.h"

namespace qvgen::test::trees {
namespace {

class RandomTrees : public testing::TestWithParam<int> {};

TEST_P(RandomTrees, EveryQuantityIsTheReference) {
  const Seeds seeds(static_cast<unsigned>(GetParam()));
  for (unsigned seed = seeds.first; seed < seeds.end; ++seed) {
    const bool composed = seed % 4 == 1;
    const auto written = [&](Composed as) {
      return TreeWriter(seed, composed ? as : Composed::none)
          .tree(2 + static_cast<int>(seed % 9), seed % 3 == 0);
    };
    const std::string text = written(Composed::as_one);
    const model::Robot robot = read(text);
    const reference::Chain chain = reference::load_text(written(Composed::written_out));
    const Motion motion(robot, seed);
    const auto& [q, qd, qdd, force, unused] = motion;
    const VectorXd zero = VectorXd::Zero(q.size());
    const derive::dynamics::FormulationOptions choices;
    const VectorXd torque = values_of(inverse_dynamics(robot, choices), motion);
    expect_close(torque, reference::inverse_dynamics(chain, q, qd, qdd), text);
    expect_close(values_of(inverse_dynamics(robot, choices, derive::dynamics::Effects::gravity), motion),
                 reference::inverse_dynamics(chain, q, zero, zero), text);
    const MatrixXd mass = symmetric(values_of(mass_matrix(robot, choices), motion), q.size());
    expect_close(mass, reference::mass_matrix(chain, q), text);
    const double kinetic = reference::kinetic_energy(chain, q, qd);
    EXPECT_NEAR(values_of(kinetic_energy(robot, choices), motion)[0], kinetic, 1e-12 * (1 + kinetic)) << text;
    const double potential = reference::potential_energy(chain, q);
    EXPECT_NEAR(values_of(potential_energy(robot, choices), motion)[0], potential,
                1e-12 * (1 + std::abs(potential)))
        << text;
    expect_close(values_of(centre_of_mass(robot, choices), motion), reference::centre_of_mass(chain, q),
                 text);
    const VectorXd found = values_of(forward_dynamics(robot, choices), motion);
    expect_close(reference::inverse_dynamics(chain, q, qd, found), force, text,
                 1e-13 * (1 + mass.norm() * found.norm()));
    const auto other = forward_dynamics_by_articulated_bodies(robot, choices);
    EXPECT_EQ(other.has_value(), !model::has_followers(robot)) << text;
    if (other)
      expect_close(reference::inverse_dynamics(chain, q, qd, values_of(*other, motion)), force, text,
                   1e-13 * (1 + mass.norm() * found.norm()));
    const VectorXd coriolis = values_of(coriolis_matrix(robot, choices), motion);
    const Eigen::Index n = q.size();
    const MatrixXd c =
        Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(coriolis.data(), n, n);
    expect_close(c * qd,
                 values_of(inverse_dynamics(robot, choices, derive::dynamics::Effects::velocity), motion),
                 text);
    if (HasFailure()) return;
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomTrees, testing::Values(1, 51, 101, 151));

/// A model has all that is generated: equal models give equal bytes.
TEST(Trees, WithComposedJointsAreTheTreesOfTheirParts) {
  unsigned parts = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const std::string text = TreeWriter(seed, Composed::as_one).tree(6, seed % 3 == 0);
    const std::string parted = TreeWriter(seed, Composed::written_out).tree(6, seed % 3 == 0);
    const model::Robot robot = read(text);
    EXPECT_EQ(description::write_text(robot), description::write_text(read(parted))) << text;
    parts += static_cast<unsigned>(robot.joints.size()) - 6;
  }
  EXPECT_GE(parts, 200U);
}

/// An entry of the mass matrix that is written as zero belongs to joints that do not carry one another, and
/// no other entry does.
TEST(Trees, SparsityOfTheMassMatrixIsExact) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const std::string text = TreeWriter(seed).tree(6, false);
    const model::Robot robot = read(text);
    const Formulation mass = derive::dynamics::mass_matrix(robot, {});
    std::size_t next = 0;
    for (std::size_t i = 0; i < robot.joints.size(); ++i)
      for (std::size_t k = i; k < robot.joints.size(); ++k) {
        std::size_t at = k;
        while (at != model::base_link && at != i) at = model::parent_of(robot, at);
        while (mass.function.outputs[next].name.front() == '?') ++next;
        const dag::Output& output = mass.function.outputs[next++];
        EXPECT_EQ(output.name, fmt::format("m{}_{}", i + 1, k + 1));
        const bool is_zero = mass.function.graph.is_zero(output.value);
        if (at == model::base_link) {
          EXPECT_TRUE(is_zero) << output.name << "\n" << text;
        }
      }
  }
}

/// Search and certificate, which throws if any output differs from the plain recursion.
TEST(Trees, PassTheirCertificates) {
  const optimise::DynamicsEffort little{.trial_steps = 500, .final_steps = 2'000, .certificate_points = 1};
  for (const unsigned seed : {3U, 4U, 8U, 9U}) {
    const std::string text = TreeWriter(seed).tree(4, seed % 3 == 0);
    const optimise::DynamicsModel model = optimise::dynamics_model(read(text), little);
    std::vector<optimise::DynamicsQuantity> all = optimise::dynamics_quantities();
    for (const optimise::DynamicsQuantity& quantity : optimise::mass_quantities(model.described))
      all.push_back(quantity);
    for (const optimise::DynamicsQuantity& quantity : all)
      EXPECT_NO_THROW(generate_dynamics(model, quantity, little)) << quantity.name << "\n" << text;
  }
}

/// Each joint that is not moved by the other is in a limb of its own: its torque does not depend on the
/// other.
TEST(Trees, JointsBesideOneAnotherHaveTheTorquesOfTheirOwnChains) {
  const std::string both = TreeWriter(77).tree(1, false);
  const std::string joint =
      both.substr(both.find("[[joint]]"), both.find("[[tip]]") - both.find("[[joint]]"));
  std::string second = joint;
  second.replace(second.find("\"q0\""), 4, "\"q1\"\nparent = \"base\"");
  std::string text = both;
  text.insert(text.find("[[tip]]"), second);
  const model::Robot robot = read(text);
  const Motion motion(robot, 5);
  const VectorXd torque = values_of(derive::dynamics::inverse_dynamics(robot, {}), motion);
  const reference::Chain one = reference::load_text(both);
  for (Eigen::Index i = 0; i < 2; ++i)
    expect_close(torque.segment<1>(i),
                 reference::inverse_dynamics(one, motion.q.segment<1>(i), motion.qd.segment<1>(i),
                                             motion.qdd.segment<1>(i)),
                 text);
}

}  // namespace
}  // namespace qvgen::test::trees
