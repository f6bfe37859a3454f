// SPDX-License-Identifier: MIT
// Paths of a platform's complex places while the squares of its rods' lengths go along a line, from lengths
// whose places are known to those that are asked for. Lengths at the start are random complex numbers, so no
// two paths meet before the end (with probability one; parameter continuation, Morgan and Sommese 1989). A
// step follows the path's power series, whose coefficients cost one factorisation together, and Newton's
// steps come back to the path; how fast they do says whether it was left.
#pragma once

#include <qvgen/inverse/six_rods/linear.h>

namespace qvgen::inverse::six_rods {

/// The plane factors . x = 1 in which points are followed.
using Patch = std::array<Complex, 4>;

/// Jacobian in a patch, by all coordinates but the first, which follows the others there.
inline Factors::Matrix within(const Patch& patch, const Gradients& rows) {
  Factors::Matrix m;
  const Complex scale = reciprocal(patch[0]);
  for (std::size_t i = 0; i < equation_count; ++i) {
    const Complex first = rows[i][0] * scale;
    for (std::size_t j = 0; j < equation_count; ++j) {
      m[i][j] = rows[i][j + 1];
      if (j < 3) m[i][j] -= first * patch[j + 1];
    }
  }
  return m;
}
/// Step of all coordinates by a step of all but the first.
inline Point full(const Patch& patch, const Values& step) {
  const Complex sum = step[0] * patch[1] + step[1] * patch[2] + step[2] * patch[3];
  return {-(sum * reciprocal(patch[0])), step[0], step[1], step[2], step[3], step[4], step[5], step[6]};
}

/// How carefully a path is followed.
struct Pace {
  double error = 1e-5;  ///< of a series at the end of a step, before Newton's steps
  int steps = 300;      ///< at most, taken or tried
};

/// Follows one point; `Number`: double, or Complex for ends that are nowhere.
template <typename Number>
class Path {
 public:
  Path(const Equations<Number>& equations, const Patch& patch, const PerRod<Complex>& from,
       const PerRod<Complex>& to)
      : equations_(equations), patch_(patch), from_(from) {
    for (std::size_t i = 0; i < rod_count; ++i) change_[i] = to[i] - from[i];
  }

  /// Moves a point at the start to the end. False if the steps do not suffice or the path is lost; z is then
  /// the last point on it.
  bool follow(Point& z, const Pace& pace) const {
    Series series, next_series;
    if (!correct(z, 0) || !expand(z, 0, series)) return false;
    double at = 0, step = reach(series, pace.error);
    for (int k = 0; k < pace.steps && step > least_step; ++k) {
      const double next = at + step < 1 ? at + step : 1;
      Point moved = sum(series, next - at);
      if (!correct(moved, next) || !expand(moved, next, next_series)) {
        step = 0.5 * (next - at);
        continue;
      }
      z = moved;
      if (next == 1) return polish(z);
      at = next;
      series = next_series;
      step = reach(series, pace.error);
    }
    return false;
  }

  /// Newton's steps at the end from a point that need not be regular: two places that meet are found to half
  /// of the digits.
  void approach_end(Point& z) const {
    const PerRod<Complex> at_end = squares(1);
    for (int k = 0; k < 60; ++k) {
      Point next = z;
      if (!(newton(next, at_end) < 0.1)) return;
      z = next;
    }
  }

 private:
  static constexpr double least_step = 1e-12;
  static constexpr std::size_t order = 10;
  using Series = std::array<Point, order + 1>;

  [[nodiscard]] PerRod<Complex> squares(double at) const {
    PerRod<Complex> result;
    for (std::size_t i = 0; i < rod_count; ++i) result[i] = from_[i] + at * change_[i];
    return result;
  }
  [[nodiscard]] Values gaps(const Point& z, const PerRod<Complex>& squares) const {
    Products products{};
    add_products(z, z, products);
    return equations_.values(products, squares);
  }

  /// One of Newton's steps; returns its size as a share of the point's, or NaN.
  double newton(Point& z, const PerRod<Complex>& squares) const {
    const Factors factors(within(patch_, equations_.gradients(z, squares)));
    if (!factors.are_regular()) return std::nan("");
    const Point step = full(patch_, factors.solve(gaps(z, squares)));
    for (std::size_t i = 0; i < 8; ++i) z[i] -= step[i];
    return largest(step) / largest(z);
  }
  /// Newton's first step back to the path; false if it is long.
  bool correct(Point& z, double at) const { return newton(z, squares(at)) < 1e-2; }
  /// Newton's steps at the end, as long as they help.
  bool polish(Point& z) const {
    const PerRod<Complex> at_end = squares(1);
    double last = 1;
    for (int k = 0; k < 4; ++k) {
      const double step = newton(z, at_end);
      if (!(step < 1e-3)) return false;
      if (step > 0.5 * last || step < 1e-15) break;
      last = step;
    }
    return is_finite(z);
  }

  /// One more of Newton's steps, which has to be tiny, and the coefficients of the series from there.
  bool expand(Point& z, double at, Series& series) const {
    const PerRod<Complex> squares_here = squares(at);
    const Factors factors(within(patch_, equations_.gradients(z, squares_here)));
    if (!factors.are_regular()) return false;
    const Point step = full(patch_, factors.solve(gaps(z, squares_here)));
    if (!(largest(step) < 1e-6 * largest(z))) return false;
    for (std::size_t i = 0; i < 8; ++i) z[i] -= step[i];
    series[0] = z;
    Complex turn = turn_of(series, 0);
    for (std::size_t k = 1; k <= order; ++k) {
      Products products{};
      for (std::size_t a = 1; 2 * a < k; ++a) add_products(twice(series[a]), series[k - a], products);
      if (k % 2 == 0) add_products(series[k / 2], series[k / 2], products);
      Values right = k == 1 ? Values{} : equations_.values(products, squares_here);
      for (std::size_t i = 0; i < rod_count; ++i) right[i + 1] -= change_[i] * turn;
      series[k] = full(patch_, factors.solve(right));
      for (Complex& each : series[k]) each = -each;
      turn = turn_of(series, k);
    }
    return true;
  }
  static Point twice(Point z) {
    for (Complex& each : z) each = 2 * each;
    return z;
  }
  /// Coefficient k of |x|^2 / 2.
  static Complex turn_of(const Series& series, std::size_t k) {
    Complex sum;
    for (std::size_t a = 0; a <= k; ++a)
      for (std::size_t i = 0; i < 4; ++i) sum += series[a][i] * series[k - a][i];
    return 0.5 * sum;
  }
  /// How far a series may be followed.
  static double reach(const Series& series, double error) {
    const double allowed = error * largest(series[0]);
    const auto by = [&](std::size_t k) {
      return std::pow(allowed / (largest(series[k]) + 1e-300), 1.0 / static_cast<double>(k));
    };
    return std::min(by(order), by(order - 1));
  }
  static Point sum(const Series& series, double step) {
    Point z = series[order];
    for (std::size_t k = order; k-- > 0;)
      for (std::size_t i = 0; i < 8; ++i) z[i] = step * z[i] + series[k][i];
    return z;
  }

  const Equations<Number>& equations_;
  Patch patch_;
  PerRod<Complex> from_, change_;
};

}  // namespace qvgen::inverse::six_rods
