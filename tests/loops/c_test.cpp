// SPDX-License-Identifier: MIT
// The header for C gives the bits of the C++ functions.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/delta/assembly.h>

#include "calls.h"

namespace qvgen::test::loops {
namespace {

namespace arm = qvgen::robots::delta;
using Joints = arm::JointVector<double>;

template <class Matrix>
void expect_rows(const Matrix& expected, const double* found) {
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    for (Eigen::Index k = 0; k < expected.cols(); ++k) EXPECT_EQ(expected(i, k), *found++);
}

TEST(LoopsInC, AreThoseOfCxx) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-1, 1);
  int solved = 0;
  for (int n = 0; n < 50; ++n) {
    const arm::Driven a(angle(random), angle(random), angle(random));
    Called c{};
    EXPECT_EQ(call_all(a.data(), &c), arm::Assembled::max_size);
    const auto found = arm::assemble(a);
    ASSERT_EQ(c.count, found.size());
    EXPECT_EQ(c.status, static_cast<int>(found.status));
    for (int i = 0; i < found.size(); ++i) {
      expect_rows(found[i].q, c.rows[i]);
      EXPECT_EQ(c.branches[i], found[i].branch);
      EXPECT_EQ(c.meets[i], found.meets(found[i]) ? 1 : 0);
    }
    if (found.empty()) continue;
    ++solved;
    const Joints q = found[0].q;
    const auto modes = arm::assemble_from_outputs(q.tail<3>(), q);
    EXPECT_EQ(c.modes, modes.size());
    expect_rows(modes[0].q, c.near);
    EXPECT_EQ(c.closed, 1);
    expect_rows(arm::follow(a, q).q, c.followed);
    expect_rows(arm::loop_gaps(q), c.gaps);
    expect_rows(arm::rates(q), c.rates[0]);
    expect_rows(arm::accelerations(q, q, a), c.accelerations);
    EXPECT_EQ(c.drive, arm::drive_measure(q));
    EXPECT_EQ(c.platform, arm::platform_measure(q));
    expect_rows(arm::platform_rates(q), c.platform_rates[0]);
    expect_rows(arm::pose_of_tool(q).position, c.position);
    EXPECT_EQ(c.orientation[0], arm::pose_of_tool(q).orientation.w());
    expect_rows(arm::jacobian_of_tool(q), c.jacobian[0]);
    expect_rows(arm::driven_inverse_dynamics(q, a, a, {}, {}, 9.8), c.forces);
    expect_rows(arm::driven_forward_dynamics(q, a, Eigen::Map<arm::Driven>(c.forces), {}, {}, 9.8), c.moved);
    expect_rows(arm::driven_mass_matrix(q), c.masses[0]);
    expect_rows(arm::loop_forces(q, a, a, {}, {}, 9.8), c.loop_forces);
    expect_rows(arm::motor_forces_of_tool(q, q), c.held);
    expect_rows(arm::loop_forces_of_tool(q, q), c.loop_held);
  }
  EXPECT_GT(solved, 20);
}

}  // namespace
}  // namespace qvgen::test::loops
