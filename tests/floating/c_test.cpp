// SPDX-License-Identifier: MIT
// The same quadruped in C: its functions give what those in C++ give.
#include <array>

#include <gtest/gtest.h>
#include <qvgen/robots/quad/regressor_with_drives.h>

#include "quad.h"

extern "C" {
#include "qvgen_quad.h"
}

namespace qvgen::test::floating {
namespace {

const quad_geometry* const geometry = nullptr;
const quad_inertia* const inertia = nullptr;

/// Orientation w x y z and position of the base.
struct Base {
  explicit Base(const At& at) {
    const Quaternion<double>& r = at.base.orientation;
    numbers = {r.w(), r.x(), r.y(), r.z(), at.base.position.x(), at.base.position.y(), at.base.position.z()};
  }
  operator const double*() const { return numbers.data(); }
  std::array<double, 7> numbers;
};

template <int rows, int columns>
using RowMajor = Eigen::Matrix<double, rows, columns, Eigen::RowMajor>;

TEST(QuadInC, GivesWhatCppGives) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const Base base(m.at);
    Rates found;
    quad_inverse_dynamics(base, m.at.q.data(), m.qd.data(), m.qdd.data(), geometry, inertia, g, found.data());
    expect_close(found, quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, g));
    quad_forward_dynamics(base, m.at.q.data(), m.qd.data(), m.force.data(), geometry, inertia, g,
                          found.data());
    expect_close(found, quad::forward_dynamics(m.at, m.qd, m.force, {}, {}, g), 1e-11);
    EXPECT_NEAR(quad_potential_energy(base, m.at.q.data(), geometry, inertia, g),
                quad::potential_energy(m.at, {}, {}, g), 1e-11);
    double mass[quad::velocity_size][quad::velocity_size];
    quad_mass_matrix(base, m.at.q.data(), geometry, inertia, mass);
    expect_close(Eigen::Map<const Matrix>(&mass[0][0], quad::velocity_size, quad::velocity_size),
                 quad::mass_matrix(m.at));  // symmetric
  }
}

TEST(QuadInC, TakesGravityInAnyDirection) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const Base base(m.at);
    const Eigen::Vector3d falling(3, -4 + static_cast<int>(seed), 2);
    const double* const q = m.at.q.data();
    Rates found;
    quad_inverse_dynamics_with_gravity_vector(base, q, m.qd.data(), m.qdd.data(), geometry, inertia,
                                              falling.data(), found.data());
    expect_close(found, quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, falling));
    const Vector expected = m.to_base(reference::inverse_dynamics(reference_chain(), m.q_of_joints,
                                                                  m.qd_of_joints, m.qdd_of_joints, -falling));
    expect_close(found, expected, 1e-11);
    quad_gravity_torque_with_gravity_vector(base, q, geometry, inertia, falling.data(), found.data());
    expect_close(found, quad::gravity_torque(m.at, {}, {}, falling));
    quad_forward_dynamics_with_gravity_vector(base, q, m.qd.data(), m.force.data(), geometry, inertia,
                                              falling.data(), found.data());
    expect_close(found, quad::forward_dynamics(m.at, m.qd, m.force, {}, {}, falling), 1e-11);
    EXPECT_NEAR(quad_potential_energy_with_gravity_vector(base, q, geometry, inertia, falling.data()),
                quad::potential_energy(m.at, {}, {}, falling), 1e-10);
  }
}

TEST(QuadInC, HasItsMassItsCentreAndTheJacobian) {
  double total = 0;
  for (const reference::Joint& joint : reference_chain().joints) total += joint.mass;
  EXPECT_NEAR(quad_total_mass(geometry, inertia), total, 1e-12 * total);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const Base base(m.at);
    Eigen::Vector3d centre;
    quad_centre_of_mass(base, m.at.q.data(), geometry, inertia, centre.data());
    expect_close(centre, reference::centre_of_mass(reference_chain(), m.q_of_joints));
    double jacobian[3][quad::velocity_size];
    quad_centre_of_mass_jacobian(base, m.at.q.data(), geometry, inertia, jacobian);
    const auto c = centroidal(m.at, quad::momentum_matrix(m.at));
    expect_close(Eigen::Map<const RowMajor<3, quad::velocity_size>>(&jacobian[0][0]), c.jacobian());
  }
}

/// The quadruped has no drives: theirs are added.
TEST(QuadInC, HasTheRegressorWithDrives) {
  ASSERT_EQ(quad_identifiable_parameter_count, quad::identifiable_parameter_count);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const QuadMotion m(seed);
    const Base base(m.at);
    double columns[quad::velocity_size][quad::identifiable_parameter_count];
    quad_regressor_with_drives(base, m.at.q.data(), m.qd.data(), m.qdd.data(), geometry, inertia, g, columns);
    expect_close(
        Eigen::Map<const RowMajor<quad::velocity_size, quad::identifiable_parameter_count>>(&columns[0][0]),
        quad::regressor_with_drives(m.at, m.qd, m.qdd, {}, {}, g));
    const Eigen::VectorXd standard = Eigen::VectorXd::Random(10 * (quad::dof + 1));
    const Eigen::VectorXd drives = Eigen::VectorXd::Random(4 * quad::dof);
    Eigen::VectorXd parameters(quad::identifiable_parameter_count);
    quad_identifiable_parameters(standard.data(), drives.data(), geometry, g, parameters.data());
    expect_close(parameters, quad::identifiable_parameters<double>(standard, drives, {}, g));
  }
}

}  // namespace
}  // namespace qvgen::test::floating
