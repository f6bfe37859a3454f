// SPDX-License-Identifier: MIT
// The header of C for the C++ code gives the bits of the C++ functions; C99 alone takes the caller's lengths.
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/delta/assembly.h>
#include <qvgen/robots/four_bar/assembly.h>
#include <qvgen_delta_assembly.h>
#include <qvgen_four_bar_loops.h>

#include "c_laws.h"
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
    const Joints q(c.rows[0]);
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

/// Lengths of the caller's, those of a parallelogram, and one that is no number.
TEST(LoopsInC99, TakeLengths) {
  namespace bar = qvgen::robots::four_bar;
  Inputs inputs;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> length(0.05, 1);
  int rows = 0;
  for (int n = 0; n < 3000; ++n) {
    const auto a = inputs.next<1>(7);
    const bool lacks_one = n % 50 == 0;
    Eigen::Vector4d lengths = Eigen::Vector4d::NullaryExpr([&] { return length(random); });
    if (n % 5 == 0) lengths << 0.3, 0.7, 0.3, 0.7;
    if (lacks_one) lengths[n / 50 % 4] = std::numeric_limits<double>::quiet_NaN();
    bar::Geometry g;
    std::memcpy(static_cast<void*>(&g), lengths.data(), sizeof g);
    const auto found = bar::assemble(a, g);
    rows += expect_same(
        found, [&](auto... to) { return four_bar_assemble(a.data(), nullptr, lengths.data(), to...); });
    EXPECT_TRUE(!lacks_one || found.empty());
    if (found.empty()) continue;
    double gaps[bar::gap_count];
    four_bar_loop_gaps(found[0].q.data(), lengths.data(), gaps);
    expect_turns(bar::loop_gaps(found[0].q, g), gaps);
    if (bar::drive_measure(found[0].q, g) < 0.03) continue;
    double rates[bar::dof][bar::driven_count], orientation[4], position[3];
    four_bar_rates(found[0].q.data(), lengths.data(), rates);
    expect_close(bar::rates(found[0].q, g), rates[0]);
    four_bar_pose_of_point(found[0].q.data(), lengths.data(), orientation, position);
    expect_close(bar::pose_of_point(found[0].q, g).position, position);
  }
  EXPECT_GT(rows, 1000);
  EXPECT_EQ(four_bar_assemble_capacity, bar::Assembled::max_size);
}

}  // namespace
}  // namespace qvgen::test::loops
