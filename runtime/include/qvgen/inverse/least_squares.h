// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <qvgen/inverse/scalar.h>

namespace qvgen::inverse {
namespace polishing {

template <typename Scalar, std::size_t size>
using Vector = std::array<Scalar, size>;

template <typename Scalar, std::size_t size>
Scalar dot(const Vector<Scalar, size>& a, const Vector<Scalar, size>& b) {
  Scalar sum(0);
  for (std::size_t i = 0; i < size; ++i) sum += a[i] * b[i];
  return sum;
}

/// Takes a column's direction out of v and returns how much of the column that was.
template <typename Scalar, std::size_t size>
Scalar take_out(const Vector<Scalar, size>& column, const Scalar& square, Vector<Scalar, size>& v) {
  const Scalar share = dot(column, v) / square;
  for (std::size_t i = 0; i < size; ++i) v[i] -= share * column[i];
  return share;
}

/// The x for which the columns' combination comes nearest to b, by modified Gram-Schmidt: normal equations would lose what
/// hardly moves. A column that adds less than `nothing`, as a share of the longest, is left out: a free joint stays.
template <typename Scalar, std::size_t columns, std::size_t rows>
Vector<Scalar, columns> least_squares(std::array<Vector<Scalar, rows>, columns> a, Vector<Scalar, rows> b, const Scalar& nothing) {
  Scalar longest(0);
  for (const Vector<Scalar, rows>& column : a) longest = larger(longest, dot(column, column));
  std::array<Vector<Scalar, columns>, columns> r{};
  Vector<Scalar, columns> x{};
  for (std::size_t i = 0; i < columns; ++i) {
    const Scalar square = dot(a[i], a[i]);
    if (!(square > nothing * nothing * longest)) continue;
    r[i][i] = square;
    for (std::size_t j = i + 1; j < columns; ++j) r[i][j] = take_out(a[i], square, a[j]);
    x[i] = take_out(a[i], square, b);
  }
  for (std::size_t i = columns; i-- > 0;)
    for (std::size_t j = i + 1; j < columns && r[i][i] > Scalar(0); ++j) x[i] -= r[i][j] * x[j];
  return x;
}

/// The columns that add less than `nothing` of the longest to those before them, and the one that adds least.
template <std::size_t columns>
struct Dependent {
  std::array<bool, columns> is{};
  std::size_t least = columns;
};

template <typename Scalar, std::size_t columns, std::size_t rows>
Dependent<columns> dependent(std::array<Vector<Scalar, rows>, columns> a, const Scalar& nothing) {
  Scalar longest(0);
  for (const Vector<Scalar, rows>& column : a) longest = larger(longest, dot(column, column));
  const Scalar limit = nothing * nothing * longest;
  Scalar least = limit;
  Dependent<columns> result;
  for (std::size_t i = 0; i < columns; ++i) {
    const Scalar square = dot(a[i], a[i]);
    result.is[i] = square <= limit;
    if (square <= least) {
      least = square;
      result.least = i;
    }
    for (std::size_t j = i + 1; j < columns && !result.is[i]; ++j) take_out(a[i], square, a[j]);
  }
  return result;
}

}  // namespace polishing
}  // namespace qvgen::inverse
