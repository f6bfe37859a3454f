// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

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

/// g (c² - s²) + 2 p c + 2 q s + k on the unit circle: the conic turned to its axes, its trace moved into k.
template <typename Scalar>
struct Aligned {
  Scalar g, p, q, k;
};

template <typename Scalar>
Scalar conic_value(const Aligned<Scalar>& f, const Rotor<Scalar>& u) {
  return f.g * (u.cosine - u.sine) * (u.cosine + u.sine) + Scalar(2) * (f.p * u.cosine + f.q * u.sine) + f.k;
}

template <typename Scalar>
Scalar conic_slope(const Aligned<Scalar>& f, const Rotor<Scalar>& u) {
  return Scalar(-4) * f.g * u.cosine * u.sine + Scalar(2) * (f.q * u.cosine - f.p * u.sine);
}

template <typename Scalar>
Scalar conic_curvature(const Aligned<Scalar>& f, const Rotor<Scalar>& u) {
  return Scalar(-4) * f.g * (u.cosine - u.sine) * (u.cosine + u.sine) -
         Scalar(2) * (f.p * u.cosine + f.q * u.sine);
}

/// Two lines as the matrix of their product: of rank one.
template <typename Scalar>
struct TwoLines {
  std::array<std::array<Scalar, 3>, 3> m;
};

template <typename Scalar>
void set_line_row(std::size_t row, const Scalar& x, const Scalar& y, const Scalar& one,
                  TwoLines<Scalar>& lines) {
  lines.m[row][0] = x;
  lines.m[row][1] = y;
  lines.m[row][2] = one;
}

/// The degenerate member of the pencil conic + λ (circle - 1) that splits into two real lines, as the
/// symmetric matrix of the pair of lines plus the skew matrix of their common point: a matrix of rank one.
template <typename Scalar>
TwoLines<Scalar> line_pair(const Aligned<Scalar>& f, const Scalar& pi) {
  using std::sqrt;
  const Scalar square = f.p * f.p + f.q * f.q;
  const CubicRoots<Scalar> roots = real_cubic(Scalar(-f.k), Scalar(square - f.g * f.g),
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
  TwoLines<Scalar> lines;
  set_line_row(0, Scalar(f.g + lambda), Scalar(0), f.p, lines);
  set_line_row(1, Scalar(0), Scalar(lambda - f.g), f.q, lines);
  set_line_row(2, f.p, f.q, Scalar(f.k - lambda), lines);
  if (!(best > Scalar(0))) return lines;
  std::array<Scalar, 3> point;
  for (std::size_t r = 0; r < 3; ++r) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
    point[r] = (lines.m[r1][c2] * lines.m[r2][c1] - lines.m[r1][c1] * lines.m[r2][c2]) / sqrt(best);
  }
  for (std::size_t r = 0; r < 3; ++r) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3;
    lines.m[r1][r2] -= point[r];
    lines.m[r2][r1] += point[r];
  }
  return lines;
}

/// Moves a root along the circle: Newton, near a double root the local parabola's root or its extremum.
template <typename Scalar>
Rotor<Scalar> polished_root(const Aligned<Scalar>& f, Rotor<Scalar> u) {
  using std::abs;
  using std::sqrt;
  for (int step = 0; step < 6; ++step) {
    const Scalar value = conic_value(f, u), slope = conic_slope(f, u), curvature = conic_curvature(f, u);
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
struct RootSearch {
  Aligned<Scalar> f;
  double accept, least;
  CircleRoots<Scalar> found;
  std::array<Rotor<Scalar>, 2> middle;
  int pairs = 0;
};

template <typename Scalar>
Scalar roots_apart(const Rotor<Scalar>& u, const Rotor<Scalar>& v) {
  return magnitude(Scalar(u.cosine - v.cosine)) + magnitude(Scalar(u.sine - v.sine));
}

template <typename Scalar>
void push_root(const Rotor<Scalar>& u, const Scalar& least_distance, CircleRoots<Scalar>& found) {
  if (found.count == 4) return;
  for (int i = 0; i < found.count; ++i)
    if (roots_apart(u, found.root[static_cast<std::size_t>(i)]) < least_distance) return;
  found.root[static_cast<std::size_t>(found.count++)] = u;
}

/// About the extremum next to u: the local parabola's roots, or the extremum itself twice.
template <typename Scalar>
void add_root_pair(const Rotor<Scalar>& u, RootSearch<Scalar>& search) {
  using std::sqrt;
  const Aligned<Scalar>& f = search.f;
  const Rotor<Scalar> middle = turned_by(u, Scalar(-conic_slope(f, u) / conic_curvature(f, u)));
  for (int i = 0; i < search.pairs; ++i)
    if (roots_apart(middle, search.middle[static_cast<std::size_t>(i)]) < Scalar(tolerance::same_extremum))
      return;
  if (search.pairs < 2) search.middle[static_cast<std::size_t>(search.pairs++)] = middle;
  const Scalar square = Scalar(-2) * conic_value(f, middle) / conic_curvature(f, middle);
  const Scalar offset = sqrt(larger(square, Scalar(search.least)));
  push_root(turned_by(middle, Scalar(-offset)), Scalar(0), search.found);
  push_root(turned_by(middle, offset), Scalar(0), search.found);
}

template <typename Scalar>
void add_root(const Rotor<Scalar>& start, RootSearch<Scalar>& search) {
  using std::abs;
  const Aligned<Scalar>& f = search.f;
  const Rotor<Scalar> u = polished_root(f, start);
  if (!(abs(conic_value(f, u)) < Scalar(search.accept))) return;
  if (abs(conic_slope(f, u)) < Scalar(tolerance::slope_of_pair) * abs(conic_curvature(f, u)))
    add_root_pair(u, search);
  else if (abs(conic_value(f, u)) < Scalar(tolerance::simple_root_value))
    push_root(u, Scalar(tolerance::same_simple_root), search.found);
}

/// The points of the line (x, y)·u + one = 0 on the unit circle; a line that misses it narrowly touches it.
template <typename Scalar>
void intersect_line(const Scalar& x, const Scalar& y, const Scalar& one, RootSearch<Scalar>& search) {
  using std::abs;
  using std::sqrt;
  const Scalar length = sqrt(Scalar(x * x + y * y));
  if (!(length > Scalar(tolerance::line_direction) * abs(one))) return;
  const Scalar a = x / length, b = y / length, d = -one / length;
  if (abs(d) > Scalar(1 + tolerance::line_touches)) return;
  const Scalar foot = smaller(Scalar(1), Scalar(abs(d)));
  const Scalar height = sqrt(Scalar((Scalar(1) - foot) * (Scalar(1) + foot)));
  const Scalar along = with_sign(foot, d);
  add_root(Rotor<Scalar>{a * along - b * height, b * along + a * height}, search);
  add_root(Rotor<Scalar>{a * along + b * height, b * along - a * height}, search);
}

template <typename Scalar>
void intersect_lines(const TwoLines<Scalar>& lines, RootSearch<Scalar>& search) {
  using std::abs;
  std::size_t row = 0, column = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    if (abs(lines.m[i / 3][i % 3]) > abs(lines.m[row][column])) {
      row = i / 3;
      column = i % 3;
    }
  }
  intersect_line(lines.m[row][0], lines.m[row][1], lines.m[row][2], search);
  intersect_line(lines.m[0][column], lines.m[1][column], lines.m[2][column], search);
}

/// Turns roots back by a conic's axis, and sorts them by angle.
template <typename Scalar>
void turn_and_sort(const Rotor<Scalar>& axis, CircleRoots<Scalar>& found) {
  std::array<Scalar, 4> order;
  for (int i = 0; i < found.count; ++i) {
    auto at = static_cast<std::size_t>(i);
    const Rotor<Scalar> root = axis * found.root[at];
    const Scalar turn = angle(root);
    for (; at > 0 && turn < order[at - 1]; --at) {
      order[at] = order[at - 1];
      found.root[at] = found.root[at - 1];
    }
    order[at] = turn;
    found.root[at] = root;
  }
}

/// The up to four angles of a conic on the unit circle, by the pencil of the two conics: a real root of one
/// cubic, then two lines. No half-angle tangent occurs, so no angle is special. Ordered by angle. Nearly
/// double roots, and extrema that come near zero, count as two: Newton steps on the joints are to decide.
template <typename Scalar>
CircleRoots<Scalar> conic_circle(const Conic<Scalar>& conic, const Boundary& boundary, const Scalar& pi) {
  using std::abs;
  using std::sqrt;
  RootSearch<Scalar> search;
  const Scalar difference = (conic.xx - conic.yy) / Scalar(2);
  const Scalar mixed = conic.xy / Scalar(2);
  const Scalar g = sqrt(Scalar(difference * difference + mixed * mixed));
  const Scalar one = conic.one + (conic.xx + conic.yy) / Scalar(2);
  const Scalar scale = g + abs(conic.x) + abs(conic.y) + abs(one);
  if (!(scale > Scalar(0))) return search.found;
  const Rotor<Scalar> axis =
      g > Scalar(0) ? half(Rotor<Scalar>{difference / g, mixed / g}) : Rotor<Scalar>{Scalar(1), Scalar(0)};
  const Scalar p = (axis.cosine * conic.x + axis.sine * conic.y) / Scalar(2);
  const Scalar q = (axis.cosine * conic.y - axis.sine * conic.x) / Scalar(2);
  const Aligned<Scalar> f = {g / scale, p / scale, q / scale, one / scale};
  search.f = f;
  search.accept = tolerance::value_per_accepted * boundary.accept;
  search.least = boundary.floor;
  if (f.g < Scalar(tolerance::conic_direction))
    intersect_line(Scalar(Scalar(2) * f.p), Scalar(Scalar(2) * f.q), f.k, search);
  else
    intersect_lines(line_pair(f, pi), search);
  turn_and_sort(axis, search.found);
  return search.found;
}

}  // namespace qvgen::inverse
