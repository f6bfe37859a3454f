// SPDX-License-Identifier: MIT
// Least squares of few columns by modified Gram-Schmidt, and the columns that depend on the others. Generated
// C has these functions from this header (generator/emit/blocks/runtime).
#pragma once

#include <array>
#include <cstddef>

#include <qvgen/inverse/branch.h>
#include <qvgen/inverse/pairs.h>

namespace qvgen::inverse {

/// Joints that keep their values while the others are polished.
template <std::size_t joints>
using Held = std::array<bool, joints>;

namespace polishing {

template <typename Scalar, std::size_t rows>
using Vector = std::array<Scalar, rows>;

/// A least-squares problem's columns, one a joint.
template <typename Scalar, std::size_t joints, std::size_t rows>
using Columns = std::array<Vector<Scalar, rows>, joints>;

/// Numbers that joints have, one each. C makes room for joints in them, not for rows.
template <typename Scalar, std::size_t joints>
using Steps = std::array<Scalar, joints>;

template <typename Scalar, std::size_t joints>
using Triangle = std::array<Steps<Scalar, joints>, joints>;

/// Takes a column's direction out of v and returns how much of the column that was; `scale` is 1 / its
/// square.
template <typename Scalar, std::size_t rows>
Scalar take_out(const Vector<Scalar, rows>& column, const Scalar& scale, Vector<Scalar, rows>& v) {
  const Scalar share = sum_of_products(column, v) * scale;
  add_multiple(Scalar(-share), column, v);
  return share;
}

/// The x for which the columns' combination comes nearest to b, by modified Gram-Schmidt: normal equations
/// would lose what hardly moves. A column that adds less than `nothing`, as a share of the longest, is left
/// out: a free joint stays. Uses up columns and b.
template <typename Scalar, std::size_t joints, std::size_t rows>
Steps<Scalar, joints> least_squares(Columns<Scalar, joints, rows>& a, Vector<Scalar, rows>& b,
                                    const Scalar& nothing) {
  Scalar longest(0);
  for (std::size_t i = 0; i < joints; ++i) longest = larger(longest, sum_of_products(a[i], a[i]));
  Triangle<Scalar, joints> r{};
  Steps<Scalar, joints> x{};
  for (std::size_t i = 0; i < joints; ++i) {
    const Scalar square = sum_of_products(a[i], a[i]);
    if (!(square > nothing * nothing * longest)) continue;
    r[i][i] = square;
    const Scalar scale = Scalar(1) / square;
    for (std::size_t j = i + 1; j < joints; ++j) r[i][j] = take_out(a[i], scale, a[j]);
    x[i] = take_out(a[i], scale, b);
  }
  for (std::size_t i = joints; i-- > 0;)
    for (std::size_t j = i + 1; j < joints && r[i][i] > Scalar(0); ++j) x[i] -= r[i][j] * x[j];
  return x;
}

/// The columns that add less than `nothing` of the longest to the others, and the one that adds least.
template <typename Scalar, std::size_t joints>
struct Dependent {
  Held<joints> is;
  std::size_t least;  ///< as many as there are: none
  Scalar square;      ///< of what that one adds
};

/// Always takes the longest of what is left: of columns that depend on each other, one that has much to do
/// with it is found. Exact numbers would allow any; but moving one with a share of a thousandth moves the
/// others a thousandfold. Uses up the columns.
template <typename Scalar, std::size_t joints, std::size_t rows>
Dependent<Scalar, joints> dependent(Columns<Scalar, joints, rows>& a, const Scalar& nothing) {
  Dependent<Scalar, joints> result;
  for (std::size_t i = 0; i < joints; ++i) result.is[i] = true;
  result.square = Scalar(0);
  Scalar limit(0);
  for (std::size_t taken = 0; taken < joints; ++taken) {
    std::size_t longest = joints;
    Steps<Scalar, joints> square{};
    result.least = joints;
    for (std::size_t i = 0; i < joints; ++i) {
      if (!result.is[i]) continue;
      square[i] = sum_of_products(a[i], a[i]);
      if (longest == joints || square[i] > square[longest]) longest = i;
      if (result.least == joints || square[i] <= square[result.least]) result.least = i;
    }
    limit = larger(limit, Scalar(nothing * nothing * square[longest]));
    if (!(square[longest] > limit)) {
      result.square = square[result.least];
      return result;
    }
    result.is[longest] = false;
    const Scalar scale = Scalar(1) / square[longest];
    for (std::size_t i = 0; i < joints; ++i)
      if (result.is[i]) take_out(a[longest], scale, a[i]);
  }
  result.least = joints;
  return result;
}

}  // namespace polishing
}  // namespace qvgen::inverse
