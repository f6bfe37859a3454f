// SPDX-License-Identifier: MIT
// All assemblies of a platform on six cylinders in C99: rows, statuses and marks are those of C++.
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/stewart/assembly.h>
#include <qvgen_stewart_loops.h>

#include "c_laws.h"

namespace qvgen::test::loops {
namespace stewart_in_c {
namespace {

namespace arm = qvgen::robots::stewart;
using Q = arm::JointVector<double>;
using arm::Driven;

/// Draws lengths: of a platform somewhere, any, those at which places meet, or none.
class Lengths {
 public:
  Driven next(int kind) {
    if (kind == 3) return Driven::NullaryExpr([&] { return 0.5 + unit_(random_) / 4; });
    Driven x;
    for (double& each : x) each = kind == 2 ? 0 : 0.15 * unit_(random_);
    x[2] += 0.5;
    Driven legs = arm::assemble_from_outputs(x)[0].q(arm::driven_joints);
    if (kind == 4) legs[2] = std::numeric_limits<double>::quiet_NaN();
    if (kind == 5) legs[4] = -legs[4];
    return legs;
  }
  Q seed() {
    return Q::NullaryExpr([&] { return 3 * unit_(random_); });
  }

 private:
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

TEST(StewartInC99, HasTheRowsOfCxx) {
  Lengths lengths;
  int rows = 0;
  for (int n = 0; n < 4 * QVGEN_LOOP_INPUTS; ++n) {
    const Driven a = lengths.next(n % 12);
    Q seed = lengths.seed();
    if (n == 7) seed[3] = std::numeric_limits<double>::infinity();
    if (n % 2 == 0)
      rows += expect_same(arm::assemble(a),
                          [&](auto... to) { return stewart_assemble(a.data(), nullptr, nullptr, to...); });
    else
      rows += expect_same(arm::assemble(a, seed), [&](auto... to) {
        return stewart_assemble(a.data(), seed.data(), nullptr, to...);
      });
  }
  EXPECT_GT(rows, 8 * QVGEN_LOOP_INPUTS);
  EXPECT_EQ(stewart_assemble_capacity, arm::Assembled::max_size);
}

}  // namespace
}  // namespace stewart_in_c
}  // namespace qvgen::test::loops
