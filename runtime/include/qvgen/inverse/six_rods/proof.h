// SPDX-License-Identifier: MIT
// Proof that one exact place lies next to a computed one (Kantorovich's theorem with an approximate inverse Y
// of the Jacobian). The equations are quadratic, so with
//
//     n >= |Y F(z)|,  k >= |1 - Y F'(z)|,  w >= |Y| |F''|,  k <= 0.1,  w n <= 0.05
//
// there is one zero within 2 n of z, and no other within 1 / (2 w). Bounds of rounding are added to n and k.
// The coordinate of the turn that is largest is set to 1, so conjugate points satisfy the same equations and
// a zero is real if its conjugate lies where it is the only one.
#pragma once

#include <limits>

#include <qvgen/inverse/six_rods/linear.h>

namespace qvgen::inverse::six_rods {

/// Rounding errors of an equation, in units of the sum of its terms' sizes: each is rounded fewer times.
inline constexpr double roundings = 32 * std::numeric_limits<double>::epsilon();

/// A point with the zero that is known to be there. Radii are in the maximum norm of x and of y / weight.
struct Proof {
  Point z{};            ///< scaled: coordinate `one` is 1
  std::size_t one = 0;  ///< the largest coordinate of the turn
  double weight = 1;    ///< size of y, at least 1
  double within = 0;    ///< the zero is so near
  double alone = 0;     ///< and the only one so near
  bool proven = false;

  [[nodiscard]] double unit(std::size_t coordinate) const { return coordinate < 4 ? 1 : weight; }
  /// Largest imaginary part.
  [[nodiscard]] double imaginary() const {
    double most = 0;
    for (std::size_t i = 0; i < 8; ++i) most = std::max(most, std::abs(z[i].im) / unit(i));
    return most;
  }
  [[nodiscard]] bool is_real() const { return proven && 2 * imaginary() + within < alone; }
  [[nodiscard]] bool is_not_real() const { return proven && imaginary() > within; }
};

namespace detail {

inline Point scaled(const Point& z, std::size_t one) {
  const Complex factor = reciprocal(z[one]);
  Point result;
  for (std::size_t i = 0; i < 8; ++i) result[i] = z[i] * factor;
  result[one] = {1, 0};
  return result;
}

inline std::size_t largest_of_turn(const Point& z) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (square(z[i]) > square(z[best])) best = i;
  return best;
}

/// An approximate inverse of the Jacobian by all coordinates but one; bounds of what it leaves.
class Inverse {
 public:
  Inverse(const Gradients& rows, std::size_t one, double weight) {
    for (std::size_t i = 0; i < equation_count; ++i)
      for (std::size_t j = 0; j < equation_count; ++j) matrix_[i][j] = rows[i][coordinate(j, one)];
    for (std::size_t j = 0; j < equation_count; ++j) units_[j] = coordinate(j, one) < 4 ? 1 : weight;
    const Factors factors(matrix_);
    is_regular = factors.are_regular();
    for (std::size_t k = 0; k < equation_count && is_regular; ++k) {
      Values unit{};
      unit[k].re = 1;
      columns_[k] = factors.solve(unit);
    }
  }

  /// Bound of |Y v| for values that are off by so much each.
  [[nodiscard]] double times(const Values& values, const std::array<double, equation_count>& off) const {
    double most = 0;
    for (std::size_t i = 0; i < equation_count; ++i) {
      Complex sum;
      double more = 0;
      for (std::size_t k = 0; k < equation_count; ++k) {
        sum += columns_[k][i] * values[k];
        more += size(columns_[k][i]) * (off[k] + roundings * size(values[k]));
      }
      most = std::max(most, (size(sum) + more) / units_[i]);
    }
    return most;
  }
  /// Bound of |1 - Y J|.
  [[nodiscard]] double missing() const {
    double most = 0;
    for (std::size_t i = 0; i < equation_count; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < equation_count; ++j) sum += missing(i, j) * units_[j];
      most = std::max(most, sum / units_[i]);
    }
    return most;
  }

  bool is_regular = false;

 private:
  static std::size_t coordinate(std::size_t j, std::size_t one) { return j < one ? j : j + 1; }

  [[nodiscard]] double missing(std::size_t i, std::size_t j) const {
    Complex entry{i == j ? 1.0 : 0.0, 0};
    double terms = 1;
    for (std::size_t k = 0; k < equation_count; ++k) {
      entry -= columns_[k][i] * matrix_[k][j];
      terms += size(columns_[k][i]) * size(matrix_[k][j]);
    }
    return size(entry) + roundings * terms;
  }

  Factors::Matrix matrix_{}, columns_{};
  std::array<double, equation_count> units_{};
};

}  // namespace detail

using Curvatures = std::array<Curvature, equation_count>;

/// Proves the zero next to a point, for real lengths.
inline Proof prove(const Equations<double>& equations, const Curvatures& curvatures,
                   const PerRod<Complex>& squares, const Point& near) {
  Proof proof;
  proof.one = detail::largest_of_turn(near);
  proof.z = detail::scaled(near, proof.one);
  if (!is_finite(proof.z)) return proof;
  for (std::size_t i = 4; i < 8; ++i) proof.weight = std::max(proof.weight, size(proof.z[i]));
  const detail::Inverse inverse(equations.gradients(proof.z, squares), proof.one, proof.weight);
  if (!inverse.is_regular) return proof;
  std::array<double, equation_count> bends{}, rounded{};
  for (std::size_t i = 0; i < equation_count; ++i) {
    bends[i] = curvatures[i].weighted(proof.weight);
    rounded[i] = roundings * bends[i];
  }
  Products products{};
  add_products(proof.z, proof.z, products);
  const double newton = inverse.times(equations.values(products, squares), rounded);
  const double bend = inverse.times({}, bends);
  proof.within = 2 * newton;
  proof.alone = 0.5 / bend;
  proof.proven = inverse.missing() <= 0.1 && newton * bend <= 0.05;
  return proof;
}

/// True if two proven points stand for different zeros.
inline bool are_different(const Proof& a, const Proof& b) {
  const double at = size(b.z[a.one]);
  if (at <= 2 * b.within) return true;  // b's coordinate is next to zero, a's is 1
  const Point moved = detail::scaled(b.z, a.one);
  for (std::size_t i = 0; i < 8; ++i) {
    const double blur = b.within * (b.unit(i) + size(moved[i])) / (at - b.within);
    if (size(moved[i] - a.z[i]) > a.within * a.unit(i) + blur + roundings * size(moved[i])) return true;
  }
  return false;
}

}  // namespace qvgen::inverse::six_rods
