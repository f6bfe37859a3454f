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
  Matrix result;
  for (int k = 0; k < quad::velocity_size; ++k) {
    const Vector step = length * Vector::Unit(k);
    result.col(k) = (after(step) - after(Vector(-step))) / (2 * length);
  }
  return result;
}

TEST(QuadDerivatives, OfInverseDynamicsAreDifferencesAlongSteps) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const QuadMotion m(seed);
    const auto found = quad::inverse_dynamics_derivatives(m.at, m.qd, m.qdd, {}, {}, g);
    expect_close(found.torque, quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, g));
    expect_close(found.by_position, differences([&](const Vector& step) {
                   return quad::inverse_dynamics(integrated(m.at, step), m.qd, m.qdd, {}, {}, g);
                 }),
                 1e-8);
    expect_close(found.by_rate, differences([&](const Vector& step) {
                   return quad::inverse_dynamics(m.at, Vector(m.qd + step), m.qdd, {}, {}, g);
                 }),
                 1e-8);
    EXPECT_TRUE(found.by_position.leftCols<3>().isZero(0));  // where the base is makes no difference
  }
}

TEST(QuadDerivatives, OfForwardDynamicsAreDifferencesAlongSteps) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const QuadMotion m(seed);
    const Vector qdd = quad::forward_dynamics(m.at, m.qd, m.force, {}, {}, g);
    const BranchFactorisation mass(quad::mass_matrix(m.at), quad::mass_matrix_parents);
    const auto found =
        forward_dynamics_derivatives(mass, quad::inverse_dynamics_derivatives(m.at, m.qd, qdd, {}, {}, g));
    const auto after = [&](const At& at, const Vector& qd, const Vector& force) {
      return quad::forward_dynamics(at, qd, force, {}, {}, g);
    };
    expect_close(
        found.by_position,
        differences([&](const Vector& step) { return after(integrated(m.at, step), m.qd, m.force); }), 1e-6);
    expect_close(found.by_rate,
                 differences([&](const Vector& step) { return after(m.at, Vector(m.qd + step), m.force); }),
                 1e-6);
    expect_close((quad::mass_matrix(m.at) * found.by_torque).eval(), Matrix::Identity().eval(), 1e-9);
  }
}

}  // namespace
}  // namespace qvgen::test::floating
