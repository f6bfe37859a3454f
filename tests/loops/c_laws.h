// SPDX-License-Identifier: MIT
// Comparisons of closed loops in C99 with those in C++. C has the sines of its library, so equal is: but for
// their rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace qvgen::test::loops {

/// Expects joints to be equal but for whole turns, and for the rounding of sines, which grows towards dead
/// centres.
template <class Matrix>
void expect_turns(const Matrix& expected, const double* found) {
  for (Eigen::Index i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(std::remainder(expected(i) - found[i], 2 * M_PI), 0, 1e-9);
}

/// Expects a matrix, row by row, but for rounding. Accelerations divide three times by a sine that is small
/// next to dead centres: it grows by six digits.
template <class Matrix>
void expect_close(const Matrix& expected, const double* found) {
  const double near = 1e-9 * (1 + expected.norm());
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    for (Eigen::Index k = 0; k < expected.cols(); ++k) EXPECT_NEAR(expected(i, k), *found++, near);
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
  int branches[Found::max_size], free_joints[Found::max_size], meets[Found::max_size], status = -1;
  const int count = call(Found::max_size, q, branches, free_joints, meets, &status);
  EXPECT_EQ(count, found.size());
  EXPECT_EQ(status, static_cast<int>(found.status));
  for (int i = 0; i < std::min(count, found.size()); ++i) {
    expect_turns(found[i].q, q[i]);
    EXPECT_EQ(branches[i], found[i].branch);
    EXPECT_EQ(free_joints[i], found[i].continuum ? 1 : 0);
    EXPECT_EQ(meets[i], found.meets(found[i]) ? 1 : 0);
  }
  return count;
}

}  // namespace qvgen::test::loops
