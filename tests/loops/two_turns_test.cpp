// SPDX-License-Identifier: MIT
// Two equations linear in two unit vectors: every solution is there, against Newton's steps from many starts,
// for random equations, symmetric ones and ones with double roots.
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/inverse/two_turns.h>

namespace qvgen::test::loops {
namespace {

using Equation = std::array<double, 9>;
using Found = inverse::TurnPairs<double>;
struct Pair {
  double u, v;
};
struct Value {
  double value, by_u, by_v;
};

inverse::TwoTurnsEquation<double> fields(const Equation& m) {
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
}
Found two_turns(const Equation& one, const Equation& other, bool at_most_six) {
  return inverse::two_turns(fields(one), fields(other), at_most_six);
}

Value value_of(const Equation& m, const Pair& at) {
  const double a[3] = {1, std::cos(at.u), std::sin(at.u)}, b[3] = {1, std::cos(at.v), std::sin(at.v)};
  const double a_u[3] = {0, -a[2], a[1]}, b_v[3] = {0, -b[2], b[1]};
  Value sum{0, 0, 0};
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      sum.value += m[3 * j + k] * a[j] * b[k];
      sum.by_u += m[3 * j + k] * a_u[j] * b[k];
      sum.by_v += m[3 * j + k] * a[j] * b_v[k];
    }
  return sum;
}

double apart(const Pair& a, const Pair& b) {
  return std::max(std::abs(std::remainder(a.u - b.u, 2 * M_PI)),
                  std::abs(std::remainder(a.v - b.v, 2 * M_PI)));
}

Pair pair_of(const inverse::TurnPair<double>& root) {
  return {std::atan2(root.first.sine, root.first.cosine), std::atan2(root.second.sine, root.second.cosine)};
}

bool has(const Found& found, const Pair& at, double within) {
  for (int i = 0; i < found.count; ++i)
    if (apart(pair_of(found.root[static_cast<std::size_t>(i)]), at) < within) return true;
  return false;
}

class TwoTurns : public testing::Test {
 protected:
  double normal() { return std::normal_distribution<double>()(random_); }
  double angle() { return std::uniform_real_distribution<double>(-M_PI, M_PI)(random_); }
  Equation equation() {
    Equation m;
    for (double& each : m) each = normal();
    return m;
  }

  /// Newton's steps from one random start.
  bool newton(const Equation& one, const Equation& other, Pair& at) {
    at = {angle(), angle()};
    for (int step = 0; step < 60; ++step) {
      const Value a = value_of(one, at), b = value_of(other, at);
      const double determinant = a.by_u * b.by_v - a.by_v * b.by_u;
      double du = (a.value * b.by_v - b.value * a.by_v) / determinant;
      double dv = (a.by_u * b.value - b.by_u * a.value) / determinant;
      const double longest = std::max(std::abs(du), std::abs(dv));
      if (!(longest < 1e9)) return false;
      const double factor = longest > 0.4 ? 0.4 / longest : 1;
      at = {at.u - factor * du, at.v - factor * dv};
      if (longest < 1e-13) return true;
    }
    return false;
  }

  /// Compares with Newton's steps; returns how many solutions there are.
  int compare(const Equation& one, const Equation& other, int starts) {
    const Found found = two_turns(one, other, false);
    EXPECT_EQ(found.count % 2, 0) << "two closed curves cross an even number of times";
    for (int i = 0; i < found.count; ++i) {
      const Pair at = pair_of(found.root[static_cast<std::size_t>(i)]);
      EXPECT_LT(std::abs(value_of(one, at).value) + std::abs(value_of(other, at).value), 1e-13);
      for (int k = 0; k < i; ++k)
        EXPECT_GT(apart(pair_of(found.root[static_cast<std::size_t>(k)]), at), 1e-9);
    }
    Pair at{};
    for (int start = 0; start < starts; ++start)
      if (newton(one, other, at)) {
        EXPECT_TRUE(has(found, at, 1e-6)) << at.u << ", " << at.v;
      }
    return found.count;
  }
  std::mt19937 random_{23};
};

/// The other equation with the second angle's sign changed: an ankle with equal legs, driven alike.
Equation mirrored(Equation m) {
  for (const std::size_t k : {2, 5, 8}) m[k] = -m[k];
  return m;
}

TEST_F(TwoTurns, AreThoseThatNewtonFindsFromManyStarts) {
  int most = 0;
  for (int k = 0; k < 10 * QVGEN_LOOP_INPUTS; ++k) most = std::max(most, compare(equation(), equation(), 60));
  EXPECT_EQ(most, 8);
}

TEST_F(TwoTurns, AreAllThereWhereTheEquationsAreMirrorImages) {
  int solved = 0;
  for (int k = 0; k < 5 * QVGEN_LOOP_INPUTS; ++k) {
    const Equation m = equation();
    solved += compare(m, mirrored(m), 60);
    Equation nearly = mirrored(m);
    for (double& each : nearly) each += std::pow(10.0, -3 - k % 7) * normal();
    solved += compare(m, nearly, 60);
  }
  EXPECT_GT(solved, 10 * QVGEN_LOOP_INPUTS);
}

TEST_F(TwoTurns, MeetAtADeadCentre) {
  int folds = 0;
  for (int k = 0; k < 200; ++k) {
    // Both gradients along each other at a point where both vanish.
    const Pair at{angle(), angle()};
    if (std::abs(std::sin(at.u)) < 0.2 || std::abs(std::sin(at.v)) < 0.2) continue;
    // Neither is near a point where it is singular itself.
    Equation one = equation(), other = equation();
    if (std::hypot(value_of(one, at).by_u, value_of(one, at).by_v) < 0.5) continue;
    one[0] -= value_of(one, at).value;
    const Value wanted = value_of(one, at), now = value_of(other, at);
    const double factor = (k % 2 == 0 ? 1 : -1) * (0.5 + std::abs(normal()));
    other[3] -= (factor * wanted.by_u - now.by_u) / std::sin(at.u);
    other[1] -= (factor * wanted.by_v - now.by_v) / std::sin(at.v);
    other[0] -= value_of(other, at).value;
    const Found found = two_turns(one, other, false);
    ASSERT_TRUE(has(found, at, 1e-5));
    for (int i = 0; i < found.count; ++i) {
      const auto& root = found.root[static_cast<std::size_t>(i)];
      if (apart(pair_of(root), at) < 1e-6) {
        EXPECT_TRUE(root.meets);
      }
    }
    // To one side there are two, to the other none.
    int near[2];
    for (const int side : {0, 1}) {
      Equation moved = other;
      moved[0] += (side == 0 ? 1e-5 : -1e-5) * std::abs(factor);
      const Found beside = two_turns(one, moved, false);
      near[side] = 0;
      for (int i = 0; i < beside.count; ++i)
        near[side] += apart(pair_of(beside.root[static_cast<std::size_t>(i)]), at) < 0.05 ? 1 : 0;
    }
    folds += near[0] + near[1] == 2 && near[0] * near[1] == 0 ? 1 : 0;
  }
  EXPECT_GT(folds, 50);
}

TEST_F(TwoTurns, OfOneEquationTwiceAreLost) {
  const Equation m = equation();
  const Found found = two_turns(m, m, false);
  ASSERT_EQ(found.count, 1);
  EXPECT_TRUE(std::isnan(found.root[0].first.cosine));
  EXPECT_EQ(two_turns(Equation{}, Equation{}, false).count, 1);
}

TEST_F(TwoTurns, EndForNumbersThatAreNone) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Equation m = equation();
    m[4] = bad;
    const Found found = two_turns(m, equation(), true);
    for (int i = 0; i < found.count; ++i) {
      EXPECT_TRUE(std::isnan(found.root[static_cast<std::size_t>(i)].first.cosine));
    }
  }
}

}  // namespace
}  // namespace qvgen::test::loops
