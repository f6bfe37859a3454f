// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

/// A matrix of C's, row by row, and one of Eigen's of that size.
template <class Derived, class Entry>
void expect_same_bits(const Eigen::MatrixBase<Derived>& cxx, const Entry* c) {
  const auto* entries = reinterpret_cast<const double*>(c);
  for (Eigen::Index row = 0; row < cxx.rows(); ++row)
    for (Eigen::Index column = 0; column < cxx.cols(); ++column) {
      const double expected = cxx(row, column);
      const double given = entries[row * cxx.cols() + column];
      ASSERT_TRUE(std::isfinite(given));
      ASSERT_EQ(std::memcmp(&expected, &given, sizeof given), 0)
          << row << ", " << column << ": " << expected << " and " << given;
    }
}

inline void expect_same_bits(double cxx, double c) {
  ASSERT_EQ(std::memcmp(&cxx, &c, sizeof c), 0) << cxx << " and " << c;
}

/// A vector of Eigen's with any numbers.
template <class Vector>
Vector any(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-4, 4);
  Vector result;
  for (double& entry : result) entry = number(random);
  return result;
}

/// Constants of both languages, the same numbers in each; those of a robot without any are left alone.
template <class Cxx, class C>
void set_constants(std::size_t count, std::mt19937& random, Cxx& cxx, C& c) {
  if (count == 0) return;
  std::uniform_real_distribution<double> number(0.1, 2);
  static_assert(sizeof(Cxx) == sizeof(C));
  ASSERT_EQ(sizeof(C), count * sizeof(double));
  for (std::size_t i = 0; i < count; ++i) {
    const double value = number(random);
    std::memcpy(reinterpret_cast<char*>(&cxx) + i * sizeof value, &value, sizeof value);
    std::memcpy(reinterpret_cast<char*>(&c) + i * sizeof value, &value, sizeof value);
  }
}
