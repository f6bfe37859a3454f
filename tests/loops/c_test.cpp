// SPDX-License-Identifier: MIT
// The header for C gives the bits of the C++ functions. Assemblies are C99 alone, with the sines of its
// library: the rows of C++ but for their rounding.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <type_traits>

#include <gtest/gtest.h>
#include <qvgen/robots/delta/assembly.h>
#include <qvgen/robots/four_bar/assembly.h>
#include <qvgen/robots/gripper/assembly.h>
#include <qvgen_delta_assembly.h>
#include <qvgen_four_bar_assembly.h>
#include <qvgen_gripper_assembly.h>

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

/// Likewise but for whole turns, and for the rounding of sines, which grows towards dead centres.
template <class Matrix>
void expect_close(const Matrix& expected, const double* found) {
  for (Eigen::Index i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(std::remainder(expected(i) - found[i], 2 * M_PI), 0, 1e-9);
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
      expect_close(found[i].q, c.rows[i]);
      EXPECT_EQ(c.branches[i], found[i].branch);
      EXPECT_EQ(c.meets[i], found.meets(found[i]) ? 1 : 0);
    }
    if (found.empty()) continue;
    ++solved;
    const Joints q(c.rows[0]);
    const auto modes = arm::assemble_from_outputs(q.tail<3>(), q);
    EXPECT_EQ(c.modes, modes.size());
    expect_close(modes[0].q, c.near);
    EXPECT_EQ(c.closed, 1);
    expect_rows(arm::follow(a, q).q, c.followed);
    expect_close(arm::loop_gaps(q), c.gaps);
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

/// Numbers between bounds, among them NaN and infinity.
class Inputs {
 public:
  template <int size>
  Eigen::Matrix<double, size, 1> next(double reach) {
    Eigen::Matrix<double, size, 1> values;
    for (double& value : values) value = std::uniform_real_distribution<double>(-reach, reach)(random_);
    const auto at = static_cast<Eigen::Index>(random_() % size);
    if (random_() % 50 == 0) values[at] = std::numeric_limits<double>::quiet_NaN();
    if (random_() % 50 == 0) values[at] = std::numeric_limits<double>::infinity();
    return values;
  }

 private:
  std::mt19937 random_{9};
};

/// Compares the rows of C with those of C++. Returns how many there are.
template <class Found, class Call>
int expect_same(const Found& found, const Call& call) {
  constexpr int dof = std::decay_t<decltype(found[0].q)>::RowsAtCompileTime;
  double q[Found::max_size][dof];
  int branches[Found::max_size], meets[Found::max_size], status = -1;
  const int count = call(Found::max_size, q, branches, meets, &status);
  EXPECT_EQ(count, found.size());
  EXPECT_EQ(status, static_cast<int>(found.status));
  for (int i = 0; i < std::min(count, found.size()); ++i) {
    expect_close(found[i].q, q[i]);
    EXPECT_EQ(branches[i], found[i].branch);
    EXPECT_EQ(meets[i], found.meets(found[i]) ? 1 : 0);
  }
  return count;
}

TEST(AssembliesInC99, HaveTheRowsOfCxx) {
  namespace gripper = qvgen::robots::gripper;
  Inputs inputs;
  int rows = 0;
  for (int n = 0; n < 3000; ++n) {
    const auto a = inputs.next<1>(7);
    const auto seed = inputs.next<gripper::dof>(20);
    rows += expect_same(gripper::assemble(a),
                        [&](auto... to) { return gripper_assemble(a.data(), nullptr, nullptr, to...); });
    rows += expect_same(gripper::assemble(a, seed),
                        [&](auto... to) { return gripper_assemble(a.data(), seed.data(), nullptr, to...); });
    const auto d = inputs.next<3>(2);
    const auto x = inputs.next<3>(0.5);
    const auto near = inputs.next<arm::dof>(4);
    rows += expect_same(arm::assemble(d),
                        [&](auto... to) { return delta_assemble(d.data(), nullptr, nullptr, to...); });
    rows += expect_same(arm::assemble_from_outputs(x, near), [&](auto... to) {
      return delta_assemble_from_outputs(x.data(), near.data(), nullptr, to...);
    });
  }
  EXPECT_GT(rows, 10000);
}

/// Lengths of the caller's, those of a parallelogram, and one that is no number.
TEST(AssembliesInC99, TakeLengths) {
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
    expect_close(bar::loop_gaps(found[0].q, g), gaps);
  }
  EXPECT_GT(rows, 1000);
  EXPECT_EQ(four_bar_assemble_capacity, bar::Assembled::max_size);
}

}  // namespace
}  // namespace qvgen::test::loops
