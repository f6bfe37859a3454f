// SPDX-License-Identifier: MIT
// Equations of a platform on six rods, in Study's parameters: a quaternion x of its turn and y = t x, where
// the pure quaternion t is its place (Study 1891; Husty 1996). Both count only up to a common factor, and x .
// y = 0. A rod from a on the base to b on the platform, of length l, says |R b + t - a|^2 = l^2. Times |x|^2
// / 2:
//
//     (|a|^2 + |b|^2 - l^2) / 2 |x|^2 + |y|^2 / 2 - a . D(x) b + (b - a) . p - (a + b) . (x' x y') = 0
//
// with x = (x0, x'), p = x0 y' - y0 x', R = D(x) / |x|^2. All seven are quadratic, so their second
// derivatives are constant: series of a path are convolutions, and certificates need no bounds over boxes.
#pragma once

#include <qvgen/inverse/six_rods/complex.h>

namespace qvgen::inverse::six_rods {

inline constexpr std::size_t rod_count = 6;
inline constexpr std::size_t equation_count = 7;  ///< x . y = 0, then the rods

/// x, then y.
using Point = std::array<Complex, 8>;
using Values = std::array<Complex, equation_count>;
using Gradients = std::array<Point, equation_count>;
template <typename Number>
using Vector = std::array<Number, 3>;
template <typename Number>
using PerRod = std::array<Number, rod_count>;

/// Ends of the rods, in the frames of the base and of the platform.
template <typename Number>
struct Ends {
  PerRod<Vector<Number>> base, platform;
};

template <typename Number>
constexpr Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The products of coordinates that the equations are made of, of two points, made symmetric.
struct Products {
  Complex study, turn, place;       ///< x . y, |x|^2 / 2, |y|^2 / 2
  std::array<Complex, 9> matrix{};  ///< D, row by row
  std::array<Complex, 3> slide{}, cross{};
};

/// Adds the products of two points, as halves of what both orders give.
inline void add_products(const Point& u, const Point& v, Products& sum) {
  const auto both = [&](std::size_t i, std::size_t j) { return u[i] * v[j] + u[j] * v[i]; };
  const std::array<Complex, 4> squares = {u[0] * v[0], u[1] * v[1], u[2] * v[2], u[3] * v[3]};
  const Complex x01 = both(0, 1), x02 = both(0, 2), x03 = both(0, 3), x12 = both(1, 2), x13 = both(1, 3),
                x23 = both(2, 3);
  sum.study += 0.5 * (both(0, 4) + both(1, 5) + both(2, 6) + both(3, 7));
  sum.turn += 0.5 * (squares[0] + squares[1] + squares[2] + squares[3]);
  sum.place += 0.5 * (u[4] * v[4] + u[5] * v[5] + u[6] * v[6] + u[7] * v[7]);
  sum.matrix[0] += squares[0] + squares[1] - squares[2] - squares[3];
  sum.matrix[1] += x12 - x03;
  sum.matrix[2] += x13 + x02;
  sum.matrix[3] += x12 + x03;
  sum.matrix[4] += squares[0] - squares[1] + squares[2] - squares[3];
  sum.matrix[5] += x23 - x01;
  sum.matrix[6] += x13 - x02;
  sum.matrix[7] += x23 + x01;
  sum.matrix[8] += squares[0] - squares[1] - squares[2] + squares[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = 1 + (i + 1) % 3, k = 1 + (i + 2) % 3;
    sum.slide[i] += 0.5 * (both(0, 5 + i) - both(4, 1 + i));
    sum.cross[i] += 0.5 * (both(j, 4 + k) - both(k, 4 + j));
  }
}

/// Sums of the sizes of an equation's second derivatives: by two coordinates of x, by one of each, by two of
/// y.
struct Curvature {
  double turn = 0, mixed = 0, place = 0;
  /// The sum if y counts so many times: a bound of the equation's terms, too, where |x| <= 1 and |y| <=
  /// weight.
  [[nodiscard]] double weighted(double weight) const { return turn + weight * (mixed + weight * place); }
};

/// The equations of one platform, for any lengths.
template <typename Number>
class Equations {
 public:
  explicit constexpr Equations(const Ends<Number>& ends) {
    for (std::size_t i = 0; i < rod_count; ++i) rods_[i] = rod(ends.base[i], ends.platform[i]);
  }

  /// Values from products of a point with itself; `squares` are those of the lengths.
  [[nodiscard]] Values values(const Products& of, const PerRod<Complex>& squares) const {
    Values result;
    result[0] = of.study;
    for (std::size_t i = 0; i < rod_count; ++i)
      result[i + 1] = fixed(rods_[i], of) + (constant(i) - squares[i]) * of.turn;
    return result;
  }
  [[nodiscard]] Gradients gradients(const Point& z, const PerRod<Complex>& squares) const {
    Gradients rows;
    rows[0] = {z[4], z[5], z[6], z[7], z[0], z[1], z[2], z[3]};
    for (std::size_t i = 0; i < rod_count; ++i) rows[i + 1] = gradient(rods_[i], constant(i) - squares[i], z);
    return rows;
  }

  /// Sums of the sizes of each equation's second derivatives, before terms cancel.
  [[nodiscard]] std::array<Curvature, equation_count> curvatures(const PerRod<Complex>& squares) const {
    std::array<Curvature, equation_count> sums{};
    sums[0].mixed = 8;
    for (std::size_t i = 0; i < rod_count; ++i) {
      Curvature& sum = sums[i + 1];
      sum.turn = 4 * (size(constant(i)) + size(squares[i]));
      sum.place = 4;
      for (std::size_t k = 0; k < 4; ++k) {
        Point unit{};
        unit[k].re = 1;
        const Point row = gradient(rods_[i], {}, unit);
        for (std::size_t j = 0; j < 4; ++j) sum.turn += size(row[j]);
        for (std::size_t j = 4; j < 8; ++j) sum.mixed += 2 * size(row[j]);
      }
    }
    return sums;
  }

 private:
  struct Rod {
    Number squares;                             ///< |a|^2 + |b|^2
    std::array<Number, 9> outer;                ///< a_i b_j
    std::array<std::array<Number, 4>, 4> form;  ///< of a . D(x) b, halved twice
    Vector<Number> difference, sum;
  };

  static constexpr Rod rod(const Vector<Number>& a, const Vector<Number>& b) {
    Rod r{};
    r.squares = dot(a, a) + dot(b, b);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) r.outer[3 * i + j] = a[i] * b[j];
      r.difference[i] = b[i] - a[i];
      r.sum[i] = a[i] + b[i];
    }
    const std::array<Number, 9>& o = r.outer;
    r.form = {{{o[0] + o[4] + o[8], o[7] - o[5], o[2] - o[6], o[3] - o[1]},
               {o[7] - o[5], o[0] - o[4] - o[8], o[1] + o[3], o[2] + o[6]},
               {o[2] - o[6], o[1] + o[3], o[4] - o[0] - o[8], o[5] + o[7]},
               {o[3] - o[1], o[2] + o[6], o[5] + o[7], o[8] - o[0] - o[4]}}};
    return r;
  }

  [[nodiscard]] Complex constant(std::size_t i) const { return complex(rods_[i].squares); }
  static constexpr Complex complex(double value) { return {value, 0}; }
  static constexpr Complex complex(Complex value) { return value; }

  static Complex fixed(const Rod& rod, const Products& of) {
    Complex value = of.place;
    for (std::size_t k = 0; k < 9; ++k) value -= of.matrix[k] * rod.outer[k];
    for (std::size_t k = 0; k < 3; ++k) value += of.slide[k] * rod.difference[k] - of.cross[k] * rod.sum[k];
    return value;
  }

  static Point gradient(const Rod& rod, Complex factor, const Point& z) {
    const Vector<Number>&d = rod.difference, &s = rod.sum;
    Point g;
    for (std::size_t i = 0; i < 4; ++i) {
      g[i] = factor * z[i];
      for (std::size_t j = 0; j < 4; ++j) g[i] -= 2.0 * (z[j] * rod.form[i][j]);
      g[4 + i] = z[4 + i];
    }
    g[0] += z[5] * d[0] + z[6] * d[1] + z[7] * d[2];
    g[4] -= z[1] * d[0] + z[2] * d[1] + z[3] * d[2];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      g[1 + i] -= z[4] * d[i] + (z[5 + j] * s[k] - z[5 + k] * s[j]);
      g[5 + i] += z[0] * d[i] - (z[1 + k] * s[j] - z[1 + j] * s[k]);
    }
    return g;
  }

  PerRod<Rod> rods_{};
};

}  // namespace qvgen::inverse::six_rods
