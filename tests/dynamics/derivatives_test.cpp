// SPDX-License-Identifier: MIT
// Derivatives of inverse dynamics by composite bodies, as they are derived, against exact differences of the
// forces, which other tests hold against the reference. Forces are polynomials of degree two in rates and in
// lengths of slides, trigonometric ones in angles (M. Riesz 1914), and linear in gravity.
#include <gtest/gtest.h>

#include "floating_motion.h"

namespace qvgen::test::trees {
namespace {

using derive::dynamics::velocity_of;

class Differences {
 public:
  Differences(const model::Robot& robot, const Motion& motion)
      : motion_(motion), forces_(derive::dynamics::inverse_dynamics(robot, {})) {}

  VectorXd forces() const { return values_of(forces_, motion_); }
  VectorXd by_rate_of(const std::string& variable) const { return half_difference(velocity_of(variable), 1); }
  VectorXd by_position_of(const model::Joint& joint) const {
    if (joint.type == model::JointType::prismatic) return half_difference(joint.variable, 1);
    return 25.0 / 12 * half_difference(joint.variable, std::atan2(4, 3)) -
           2.0 / 3 * half_difference(joint.variable, std::acos(-1) / 2);
  }
  /// By a turn of the base about its axis k, which sees gravity turn the other way.
  VectorXd by_turn(std::size_t k) const {
    using derive::dynamics::gravity_component;
    const std::string first = gravity_component((k + 1) % 3), second = gravity_component((k + 2) % 3);
    Motion turned = motion_;
    turned.values[first] += motion_.values.at(second);
    turned.values[second] -= motion_.values.at(first);
    return values_of(forces_, turned) - forces();
  }

 private:
  VectorXd half_difference(const std::string& symbol, double step) const {
    const auto moved = [&](double by) {
      Motion result = motion_;
      result.values[symbol] += by;
      return values_of(forces_, result);
    };
    return (moved(step) - moved(-step)) / 2;
  }

  const Motion& motion_;
  Formulation forces_;
};

/// The derived outputs in their order: forces, then columns by position and by rate in turn.
void expect_differences(const model::Robot& robot, const Motion& motion, const std::string& text) {
  const Differences differences(robot, motion);
  const VectorXd found = values_of(derive::dynamics::inverse_dynamics_derivatives(robot, {}), motion);
  const auto n = static_cast<Eigen::Index>(model::coordinate_count(robot));
  ASSERT_EQ(found.size(), n + 2 * n * n) << text;
  MatrixXd expected(n, 1 + 2 * n);
  expected.col(0) = differences.forces();
  Eigen::Index next = 1;
  for (std::size_t k = 0; k < model::base_motions(robot); ++k) {
    expected.col(next++) = k < 3 ? VectorXd::Zero(n).eval() : differences.by_turn(k - 3);
    expected.col(next++) = differences.by_rate_of(model::base_coordinate(k));
  }
  for (const model::Joint& joint : robot.joints) {
    expected.col(next++) = differences.by_position_of(joint);
    expected.col(next++) = differences.by_rate_of(joint.variable);
  }
  expect_close(Eigen::Map<const MatrixXd>(found.data(), n, 1 + 2 * n), expected, text);
}

class RandomDerivatives : public testing::TestWithParam<unsigned> {};

TEST_P(RandomDerivatives, AreDifferencesOfTheForces) {
  const Seeds seeds(GetParam());
  for (unsigned seed = seeds.first; seed < seeds.end && !HasFailure(); ++seed) {
    const std::string text = TreeWriter(seed).tree(1 + static_cast<int>(seed % 7), false);
    const model::Robot robot = read(text);
    expect_differences(robot, Motion(robot, seed), text);
  }
}

TEST_P(RandomDerivatives, WithBasesThatFloatAreDifferencesOfTheForces) {
  const Seeds seeds(GetParam());
  for (unsigned seed = seeds.first; seed < seeds.end && !HasFailure(); ++seed) {
    const std::string text = TreeWriter(seed).floating_tree(1 + static_cast<int>(seed % 5), false).floating;
    const model::Robot robot = read(text);
    Motion motion(robot, seed);
    add_base(BaseMotion(seed), VectorXd::Zero(6), motion);
    expect_differences(robot, motion, text);
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomDerivatives, testing::Values(1, 51, 101, 151));

}  // namespace
}  // namespace qvgen::test::trees
