// SPDX-License-Identifier: MIT
// The same quadruped in C: its functions give what those in C++ give.
#include <gtest/gtest.h>

#include "quad.h"

extern "C" {
#include "qvgen_quad.h"
}

namespace qvgen::test::floating {
namespace {

TEST(QuadInC, GivesWhatCppGives) {
  const quad_geometry* geometry = nullptr;
  const quad_inertia* inertia = nullptr;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const Quaternion<double>& r = m.at.base.orientation;
    const Eigen::Vector3d& p = m.at.base.position;
    const double base[7] = {r.w(), r.x(), r.y(), r.z(), p.x(), p.y(), p.z()};
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

}  // namespace
}  // namespace qvgen::test::floating
