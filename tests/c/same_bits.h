// SPDX-License-Identifier: MIT
// C's numbers against those of Eigen's types, and random arguments. What is done with numbers is compiled
// once for a scalar, not for each of a robot's many types.
#pragma once

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <qvgen/inverse_velocity_within.h>

/// Eigen's numbers are column by column, C's row by row.
template <class Scalar>
void expect_same_numbers(const Scalar* cxx, Eigen::Index rows, Eigen::Index columns, const Scalar* c) {
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index column = 0; column < columns; ++column) {
      const Scalar expected = cxx[column * rows + row];
      const Scalar given = c[row * columns + column];
      ASSERT_TRUE(std::isfinite(given));
      ASSERT_EQ(std::memcmp(&expected, &given, sizeof given), 0)
          << row << ", " << column << ": " << expected << " and " << given;
    }
}

/// A matrix of C's, row by row, and one of Eigen's of that size.
template <class Derived, class Entry>
void expect_same_bits(const Eigen::PlainObjectBase<Derived>& cxx, const Entry* c) {
  static_assert(!Derived::IsRowMajor || Derived::IsVectorAtCompileTime);
  using Scalar = typename Derived::Scalar;
  expect_same_numbers(cxx.data(), cxx.rows(), cxx.cols(), reinterpret_cast<const Scalar*>(c));
}

template <class Scalar>
void expect_same_bits(Scalar cxx, Scalar c) {
  ASSERT_EQ(std::memcmp(&cxx, &c, sizeof c), 0) << cxx << " and " << c;
}

template <class Scalar>
void draw(std::mt19937& random, Scalar* begin, const Scalar* end) {
  std::uniform_real_distribution<Scalar> number(-4, 4);
  for (Scalar* entry = begin; entry != end; ++entry) *entry = number(random);
}

/// A vector of Eigen's with any numbers.
template <class Vector>
Vector any(std::mt19937& random) {
  Vector result;
  draw(random, result.data(), result.data() + result.size());
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
