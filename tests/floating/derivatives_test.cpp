// SPDX-License-Identifier: MIT
// Derivatives of inverse and forward dynamics on the manifold of configurations: against differences along
// steps, for every coordinate of the base and of the joints.
#include <gtest/gtest.h>
#include <qvgen/forward_dynamics_derivatives.h>
#include <qvgen/robots/quad/dynamics_derivatives.h>

#include "quad.h"

namespace qvgen::test::floating {
namespace {

constexpr double length = 1e-5;

/// Central differences of a function of a step, column by column.
template <class Function>
Matrix differences(const Function& after) {
  Matrix result(quad::velocity_size, quad::velocity_size);
  for (int k = 0; k < quad::velocity_size; ++k) {
    const Rates step = length * Rates::Unit(k);
    const Rates change = after(step) - after(Rates(-step));
    result.col(k) = change / (2 * length);
  }
  return result;
}

TEST(QuadDerivatives, OfInverseDynamicsAreDifferencesAlongSteps) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const QuadMotion m(seed);
    const auto found = quad::inverse_dynamics_derivatives(m.at, m.qd, m.qdd, {}, {}, g);
    expect_close(found.torque, quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, g));
    expect_close(found.by_position, differences([&](const Rates& step) {
                   return quad::inverse_dynamics(integrated(m.at, step), m.qd, m.qdd, {}, {}, g);
                 }),
                 1e-8);
    expect_close(found.by_rate, differences([&](const Rates& step) {
                   return quad::inverse_dynamics(m.at, Rates(m.qd + step), m.qdd, {}, {}, g);
                 }),
                 1e-8);
    EXPECT_TRUE(found.by_position.leftCols<3>().isZero(0));  // where the base is makes no difference
  }
}

TEST(QuadDerivatives, OfForwardDynamicsAreDifferencesAlongSteps) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const QuadMotion m(seed);
    const Rates qdd = quad::forward_dynamics(m.at, m.qd, m.force, {}, {}, g);
    const BranchFactorisation mass(quad::mass_matrix(m.at), quad::mass_matrix_parents);
    const auto found =
        forward_dynamics_derivatives(mass, quad::inverse_dynamics_derivatives(m.at, m.qd, qdd, {}, {}, g));
    const auto after = [&](const At& at, const Rates& qd, const Rates& force) {
      return quad::forward_dynamics(at, qd, force, {}, {}, g);
    };
    expect_close(found.by_position,
                 differences([&](const Rates& step) { return after(integrated(m.at, step), m.qd, m.force); }),
                 1e-6);
    expect_close(found.by_rate,
                 differences([&](const Rates& step) { return after(m.at, Rates(m.qd + step), m.force); }),
                 1e-6);
    expect_close(product(quad::mass_matrix(m.at), found.by_torque),
                 Matrix::Identity(quad::velocity_size, quad::velocity_size), 1e-9);
  }
}

}  // namespace
}  // namespace qvgen::test::floating
