// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <qvgen/inverse/branch.h>
#include <qvgen/inverse/pairs.h>

namespace qvgen::inverse {
namespace polishing {

template <typename Scalar, std::size_t size>
using Vector = std::array<Scalar, size>;

template <typename Scalar, std::size_t size>
Scalar dot(const Vector<Scalar, size>& a, const Vector<Scalar, size>& b) {
  return sum_of_products(a, b);
}

/// Takes a column's direction out of v and returns how much of the column that was; `scale` is 1 / its
/// square.
template <typename Scalar, std::size_t size>
Scalar take_out(const Vector<Scalar, size>& column, const Scalar& scale, Vector<Scalar, size>& v) {
  const Scalar share = dot(column, v) * scale;
  add_multiple(Scalar(-share), column, v);
  return share;
}

/// The x for which the columns' combination comes nearest to b, by modified Gram-Schmidt: normal equations
/// would lose what hardly moves. A column that adds less than `nothing`, as a share of the longest, is left
/// out: a free joint stays.
template <typename Scalar, std::size_t columns, std::size_t rows>
Vector<Scalar, columns> least_squares(std::array<Vector<Scalar, rows>, columns> a, Vector<Scalar, rows> b,
                                      const Scalar& nothing) {
  Scalar longest(0);
  for (const Vector<Scalar, rows>& column : a) longest = larger(longest, dot(column, column));
  std::array<Vector<Scalar, columns>, columns> r{};
  Vector<Scalar, columns> x{};
  for (std::size_t i = 0; i < columns; ++i) {
    const Scalar square = dot(a[i], a[i]);
    if (!(square > nothing * nothing * longest)) continue;
    r[i][i] = square;
    const Scalar scale = Scalar(1) / square;
    for (std::size_t j = i + 1; j < columns; ++j) r[i][j] = take_out(a[i], scale, a[j]);
    x[i] = take_out(a[i], scale, b);
  }
  for (std::size_t i = columns; i-- > 0;)
    for (std::size_t j = i + 1; j < columns && r[i][i] > Scalar(0); ++j) x[i] -= r[i][j] * x[j];
  return x;
}

/// The columns that add less than `nothing` of the longest to the others, and the one that adds least.
template <typename Scalar, std::size_t columns>
struct Dependent {
  std::array<bool, columns> is{};
  std::size_t least = columns;
  Scalar square{0};  ///< of what that one adds
};

/// Always takes the longest of what is left: of columns that depend on each other, one that has much to do
/// with it is found. Exact numbers would allow any; but moving one with a share of a thousandth moves the
/// others a thousandfold.
template <typename Scalar, std::size_t columns, std::size_t rows>
Dependent<Scalar, columns> dependent(std::array<Vector<Scalar, rows>, columns> a, const Scalar& nothing) {
  Dependent<Scalar, columns> result;
  result.is.fill(true);
  Scalar limit(0);
  for (std::size_t taken = 0; taken < columns; ++taken) {
    std::size_t longest = columns;
    std::array<Scalar, columns> square{};
    result.least = columns;
    for (std::size_t i = 0; i < columns; ++i) {
      if (!result.is[i]) continue;
      square[i] = dot(a[i], a[i]);
      if (longest == columns || square[i] > square[longest]) longest = i;
      if (result.least == columns || square[i] <= square[result.least]) result.least = i;
    }
    limit = larger(limit, Scalar(nothing * nothing * square[longest]));
    if (!(square[longest] > limit)) {
      result.square = square[result.least];
      return result;
    }
    result.is[longest] = false;
    const Scalar scale = Scalar(1) / square[longest];
    for (std::size_t i = 0; i < columns; ++i)
      if (result.is[i]) take_out(a[longest], scale, a[i]);
  }
  result.least = columns;
  return result;
}

}  // namespace polishing
}  // namespace qvgen::inverse
