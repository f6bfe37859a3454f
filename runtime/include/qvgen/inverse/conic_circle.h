// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include <qvgen/inverse/angles.h>
#include <qvgen/inverse/cubic.h>

namespace qvgen::inverse {

/// xx c² + xy c s + yy s² + x c + y s + one = 0 for the unit vector (c, s).
template <typename Scalar>
struct Conic {
  Scalar xx, xy, yy, x, y, one;
};

template <typename Scalar>
struct CircleRoots {
  int count = 0;
  std::array<Rotor<Scalar>, 4> root;
};

namespace conic {

/// g (c² - s²) + 2 p c + 2 q s + k on the unit circle: the conic turned to its axes, its trace moved into k.
template <typename Scalar>
struct Aligned {
  Scalar g, p, q, k;

  [[nodiscard]] Scalar value(const Rotor<Scalar>& u) const {
    return g * (u.cosine - u.sine) * (u.cosine + u.sine) + Scalar(2) * (p * u.cosine + q * u.sine) + k;
  }
  [[nodiscard]] Scalar slope(const Rotor<Scalar>& u) const {
    return Scalar(-4) * g * u.cosine * u.sine + Scalar(2) * (q * u.cosine - p * u.sine);
  }
  [[nodiscard]] Scalar curvature(const Rotor<Scalar>& u) const {
    return Scalar(-4) * g * (u.cosine - u.sine) * (u.cosine + u.sine) -
           Scalar(2) * (p * u.cosine + q * u.sine);
  }
};

template <typename Scalar>
using Matrix = std::array<std::array<Scalar, 3>, 3>;

/// The degenerate member of the pencil conic + λ (circle - 1) that splits into two real lines, as the
/// symmetric matrix of the pair of lines plus the skew matrix of their common point: a matrix of rank one.
template <typename Scalar>
Matrix<Scalar> line_pair(const Aligned<Scalar>& f, const Scalar& pi) {
  using std::sqrt;
  const Scalar square = f.p * f.p + f.q * f.q;
  const auto roots = real_cubic(Scalar(-f.k), Scalar(square - f.g * f.g),
                                Scalar(f.g * f.g * f.k - f.g * (f.p * f.p - f.q * f.q)), pi);
  Scalar best(-1);
  Scalar lambda(0);
  std::size_t column = 0;
  for (int i = 0; i < roots.count; ++i) {
    const Scalar x = roots.root[static_cast<std::size_t>(i)];
    const std::array<Scalar, 3> entries = {f.q * f.q - (x - f.g) * (f.k - x),
                                           f.p * f.p - (f.g + x) * (f.k - x), -(f.g + x) * (x - f.g)};
    for (std::size_t j = 0; j < 3; ++j) {
      if (entries[j] > best || (i == 0 && j == 0)) {
        best = entries[j];
        lambda = x;
        column = j;
      }
    }
  }
  Matrix<Scalar> m = {
      {{f.g + lambda, Scalar(0), f.p}, {Scalar(0), lambda - f.g, f.q}, {f.p, f.q, f.k - lambda}}};
  if (!(best > Scalar(0))) return m;
  std::array<Scalar, 3> point;
  for (std::size_t r = 0; r < 3; ++r) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
    point[r] = (m[r1][c2] * m[r2][c1] - m[r1][c1] * m[r2][c2]) / sqrt(best);
  }
  for (std::size_t r = 0; r < 3; ++r) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3;
    m[r1][r2] -= point[r];
    m[r2][r1] += point[r];
  }
  return m;
}

/// Moves a root along the circle: Newton, near a double root the local parabola's root or its extremum.
template <typename Scalar>
Rotor<Scalar> polished(const Aligned<Scalar>& f, Rotor<Scalar> u) {
  using std::abs;
  using std::sqrt;
  for (int step = 0; step < 6; ++step) {
    const Scalar value = f.value(u), slope = f.slope(u), curvature = f.curvature(u);
    const Scalar discriminant = slope * slope - Scalar(2) * value * curvature;
    Scalar move(0);
    if (abs(slope) < Scalar(tolerance::little_slope) && discriminant > Scalar(0)) {
      const Scalar below = slope + with_sign(sqrt(discriminant), slope);
      if (below != Scalar(0)) move = Scalar(-2) * value / below;
    } else if (!(discriminant > Scalar(0)) &&
               abs(slope) < Scalar(tolerance::slope_to_extremum) * abs(curvature)) {
      move = -slope / curvature;
    } else if (slope != Scalar(0)) {
      move = -value / slope;
    }
    const Scalar most(tolerance::longest_step);
    if (abs(move) > most) move = with_sign(most, move);
    u = turned_by(u, move);
    if (abs(move) < epsilon<Scalar>() / Scalar(2)) break;
  }
  const Scalar scale = Scalar(1) / sqrt(Scalar(u.cosine * u.cosine + u.sine * u.sine));
  return {u.cosine * scale, u.sine * scale};
}

/// The candidates for roots, each once; two that nearly meet count as two even where they are one.
template <typename Scalar>
class Roots {
 public:
  Roots(const Aligned<Scalar>& f, const Boundary& boundary)
      : f_(f), accept_(tolerance::value_per_accepted * boundary.accept), floor_(boundary.floor) {}

  /// The points of the line a·u + d = 0 on the unit circle; a line that misses it narrowly touches it.
  void intersect(const std::array<Scalar, 3>& line) {
    using std::abs;
    using std::sqrt;
    const Scalar length = sqrt(Scalar(line[0] * line[0] + line[1] * line[1]));
    if (!(length > Scalar(tolerance::line_direction) * abs(line[2]))) return;
    const Scalar a = line[0] / length, b = line[1] / length, d = -line[2] / length;
    if (abs(d) > Scalar(1 + tolerance::line_touches)) return;
    const Scalar foot = smaller(Scalar(1), Scalar(abs(d)));
    const Scalar height = sqrt(Scalar((Scalar(1) - foot) * (Scalar(1) + foot)));
    const Scalar along = with_sign(foot, d);
    add({a * along - b * height, b * along + a * height});
    add({a * along + b * height, b * along - a * height});
  }

  [[nodiscard]] const CircleRoots<Scalar>& found() const { return found_; }

 private:
  void add(const Rotor<Scalar>& start) {
    using std::abs;
    const Rotor<Scalar> u = polished(f_, start);
    if (!(abs(f_.value(u)) < Scalar(accept_))) return;
    if (abs(f_.slope(u)) < Scalar(tolerance::slope_of_pair) * abs(f_.curvature(u))) return add_pair(u);
    if (abs(f_.value(u)) < Scalar(tolerance::simple_root_value)) push(u, Scalar(tolerance::same_simple_root));
  }

  /// About the extremum next to u: the local parabola's roots, or the extremum itself twice.
  void add_pair(const Rotor<Scalar>& u) {
    using std::sqrt;
    const Rotor<Scalar> middle = turned_by(u, Scalar(-f_.slope(u) / f_.curvature(u)));
    for (int i = 0; i < pairs_; ++i)
      if (apart(middle, middle_[static_cast<std::size_t>(i)]) < Scalar(tolerance::same_extremum)) return;
    if (pairs_ < 2) middle_[static_cast<std::size_t>(pairs_++)] = middle;
    const Scalar square = Scalar(-2) * f_.value(middle) / f_.curvature(middle);
    const Scalar offset = sqrt(larger(square, Scalar(floor_)));
    push(turned_by(middle, Scalar(-offset)), Scalar(0));
    push(turned_by(middle, offset), Scalar(0));
  }

  void push(const Rotor<Scalar>& u, const Scalar& least_distance) {
    if (found_.count == 4) return;
    for (int i = 0; i < found_.count; ++i)
      if (apart(u, found_.root[static_cast<std::size_t>(i)]) < least_distance) return;
    found_.root[static_cast<std::size_t>(found_.count++)] = u;
  }

  static Scalar apart(const Rotor<Scalar>& u, const Rotor<Scalar>& v) {
    return magnitude(Scalar(u.cosine - v.cosine)) + magnitude(Scalar(u.sine - v.sine));
  }

  const Aligned<Scalar>& f_;
  double accept_;
  double floor_;
  CircleRoots<Scalar> found_;
  std::array<Rotor<Scalar>, 2> middle_;
  int pairs_ = 0;
};

/// Turns roots back by a conic's axis, and sorts them by angle.
template <typename Scalar>
CircleRoots<Scalar> in_order(CircleRoots<Scalar> found, const Rotor<Scalar>& axis) {
  std::array<Scalar, 4> order{};
  for (int i = 0; i < found.count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    found.root[place] = axis * found.root[place];
    order[place] = angle(found.root[place]);
    for (std::size_t j = place; j > 0 && order[j] < order[j - 1]; --j) {
      std::swap(order[j], order[j - 1]);
      std::swap(found.root[j], found.root[j - 1]);
    }
  }
  return found;
}

}  // namespace conic

/// The up to four angles of a conic on the unit circle, by the pencil of the two conics: a real root of one
/// cubic, then two lines. No half-angle tangent occurs, so no angle is special. Ordered by angle. Nearly
/// double roots, and extrema that come near zero, count as two: Newton steps on the joints are to decide.
template <typename Scalar>
CircleRoots<Scalar> conic_circle(const Conic<Scalar>& conic, const Boundary& boundary, const Scalar& pi) {
  using std::abs;
  using std::atan2;
  using std::sqrt;
  const Scalar difference = (conic.xx - conic.yy) / Scalar(2);
  const Scalar mixed = conic.xy / Scalar(2);
  const Scalar g = sqrt(Scalar(difference * difference + mixed * mixed));
  const Scalar one = conic.one + (conic.xx + conic.yy) / Scalar(2);
  const Scalar scale = g + abs(conic.x) + abs(conic.y) + abs(one);
  if (!(scale > Scalar(0))) return {};
  const Rotor<Scalar> axis =
      g > Scalar(0) ? half(Rotor<Scalar>{difference / g, mixed / g}) : Rotor<Scalar>{1, 0};
  const Scalar p = (axis.cosine * conic.x + axis.sine * conic.y) / Scalar(2);
  const Scalar q = (axis.cosine * conic.y - axis.sine * conic.x) / Scalar(2);
  const conic::Aligned<Scalar> f{g / scale, p / scale, q / scale, one / scale};
  conic::Roots<Scalar> roots(f, boundary);
  if (f.g < Scalar(tolerance::conic_direction)) {
    roots.intersect({Scalar(2) * f.p, Scalar(2) * f.q, f.k});
  } else {
    const conic::Matrix<Scalar> lines = conic::line_pair(f, pi);
    std::size_t row = 0, column = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      if (abs(lines[i / 3][i % 3]) > abs(lines[row][column])) {
        row = i / 3;
        column = i % 3;
      }
    }
    roots.intersect(lines[row]);
    roots.intersect({lines[0][column], lines[1][column], lines[2][column]});
  }
  return conic::in_order(roots.found(), axis);
}

}  // namespace qvgen::inverse
