// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <qvgen/inverse_velocity_within.h>

/// A matrix of C's, row by row, and one of Eigen's of that size.
template <class Derived, class Entry>
void expect_same_bits(const Eigen::MatrixBase<Derived>& cxx, const Entry* c) {
  using Scalar = typename Derived::Scalar;
  const auto* entries = reinterpret_cast<const Scalar*>(c);
  for (Eigen::Index row = 0; row < cxx.rows(); ++row)
    for (Eigen::Index column = 0; column < cxx.cols(); ++column) {
      const Scalar expected = cxx(row, column);
      const Scalar given = entries[row * cxx.cols() + column];
      ASSERT_TRUE(std::isfinite(given));
      ASSERT_EQ(std::memcmp(&expected, &given, sizeof given), 0)
          << row << ", " << column << ": " << expected << " and " << given;
    }
}

template <class Scalar>
void expect_same_bits(Scalar cxx, Scalar c) {
  ASSERT_EQ(std::memcmp(&cxx, &c, sizeof c), 0) << cxx << " and " << c;
}

/// A vector of Eigen's with any numbers.
template <class Vector>
Vector any(std::mt19937& random) {
  using Scalar = typename Vector::Scalar;
  std::uniform_real_distribution<Scalar> number(-4, 4);
  Vector result;
  for (Scalar& entry : result) entry = number(random);
  return result;
}

/// Joints anywhere, and every third time next to right angles.
template <class Joints>
Joints joints_for_rates(std::mt19937& random, int i) {
  Joints q = any<Joints>(random);
  if (i % 3 != 0) return q;
  using Scalar = typename Joints::Scalar;
  for (Scalar& entry : q) entry = Scalar(1.5707963267948966) * std::floor(entry) + Scalar(1e-4) * entry;
  return q;
}

/// Limits that admit rest or not, some of them infinite, some NaN.
template <class Joints, class Scalar = typename Joints::Scalar, int dof = Joints::RowsAtCompileTime>
qvgen::RateLimits<Scalar, dof> rate_limits(std::mt19937& random, int i) {
  const Joints one = any<Joints>(random), other = any<Joints>(random);
  qvgen::RateLimits<Scalar, dof> limits{one.cwiseMin(other), one.cwiseMax(other)};
  if (i % 2 == 0) limits = {-one.cwiseAbs(), other.cwiseAbs()};
  if (i % 5 == 0) limits.upper[i % dof] = std::numeric_limits<Scalar>::infinity();
  if (i % 50 == 1) limits.lower[i % dof] = std::numeric_limits<Scalar>::quiet_NaN();
  return limits;
}

/// Constants of both languages, the same numbers in each; those of a robot without any are left alone.
template <class Scalar, class Cxx, class C>
void set_constants(std::size_t count, std::mt19937& random, Cxx& cxx, C& c) {
  if (count == 0) return;
  std::uniform_real_distribution<Scalar> number(Scalar(0.1), 2);
  static_assert(sizeof(Cxx) == sizeof(C));
  ASSERT_EQ(sizeof(C), count * sizeof(Scalar));
  for (std::size_t i = 0; i < count; ++i) {
    const Scalar value = number(random);
    std::memcpy(reinterpret_cast<char*>(&cxx) + i * sizeof value, &value, sizeof value);
    std::memcpy(reinterpret_cast<char*>(&c) + i * sizeof value, &value, sizeof value);
  }
}
