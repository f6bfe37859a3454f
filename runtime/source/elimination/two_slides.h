// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <qvgen/inverse/elimination/setup.h>

#include "line.h"

/// Arms two of whose joints slide. With the outer angle theta known the three other turns a, b, c make an
/// orientation, up to the sign of a root; then the way that is left for the slides has to lie in the plane of
/// their directions: one equation. Times its conjugate, the same with the root's other sign, it is a
/// polynomial of degree four in cosine and sine of theta but for a factor.
namespace qvgen::inverse::elimination {
namespace {

/// Equations of a pose for the loop J4' C4' J5' ... C3' = I, cut into four stretches, each behind a turn:
/// theta, a, b, c.
struct SlideSystem {
  double rotation[4][9];   ///< of each stretch
  double column[3][4][3];  ///< the way without slides, the slides' directions; in each stretch's first frame
  double bend[2];          ///< the third axes behind b and before it: a cosine's and a sine's share of their
  double bend_square;      ///< product, the sum of the shares' squares,
  double level;            ///< and what does not depend on b
};

/// Order of the loop's joints, from the outer one on.
inline constexpr int from_outer[joints] = {3, 4, 5, 0, 1, 2};

inline void identity(double (&r)[9]) {
  for (int i = 0; i < 9; ++i) r[i] = i % 4 == 0 ? 1 : 0;
}

/// How the axes of a and c lie to each other, by the constants before and behind b.
inline void set_bend(SlideSystem& s) {
  const double *row = s.rotation[1] + 6, *column = s.rotation[2] + 2;
  s.bend[0] = row[0] * column[0] + row[1] * column[3];
  s.bend[1] = row[1] * column[0] - row[0] * column[3];
  s.bend_square = s.bend[0] * s.bend[0] + s.bend[1] * s.bend[1];
  s.level = row[2] * column[6];
}

inline void set_slides(const bool (&slide)[joints], const Motion (&link)[joints], SlideSystem& s) {
  s = {};
  int stretch = 0, slides = 0;
  identity(s.rotation[0]);
  for (int k = 0; k < joints; ++k) {
    const int i = from_outer[k];
    if (k > 0 && slide[i]) {
      for (int j = 0; j < 3; ++j) s.column[1 + slides][stretch][j] = s.rotation[stretch][3 * j + 2];
      ++slides;
    } else if (k > 0) {
      identity(s.rotation[++stretch]);
    }
    double(&rotation)[9] = s.rotation[stretch];
    double moved[3], product[9];
    rotate(rotation, link[i].translation, moved);
    for (int j = 0; j < 3; ++j) s.column[0][stretch][j] += moved[j];
    multiply(rotation, link[i].rotation, false, false, product);
    std::copy(product, product + 9, rotation);
  }
  set_bend(s);
}

/// x + y r and its conjugate x - y r, for a root r whose square stands elsewhere: it may be negative.
template <class T>
struct Conjugates {
  T x, y;
};

template <class T>
QVGEN_LANES Conjugates<T> operator+(const Conjugates<T>& a, const Conjugates<T>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class T>
QVGEN_LANES Conjugates<T> operator-(const Conjugates<T>& a, const Conjugates<T>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class T, class Factor>
QVGEN_LANES Conjugates<T> operator*(const Factor& factor, const Conjugates<T>& a) {
  return {factor * a.x, factor * a.y};
}

/// Everything at one outer angle, for both signs of the root.
template <class T>
struct AtOuter {
  using Twin = Conjugates<T>;

  T square;   ///< of the root
  T between;  ///< the cosine between the axes of a and c
  T across;   ///< 1 - its square
  Twin cosine_b, sine_b, cosine_a, sine_a;
  T first_axis[3];    ///< the first column of the rotation that a, b and c have to make
  T outside[3][3];    ///< what the way and the slides' directions are from behind c on, seen from before a
  Twin column[3][3];  ///< all of them in the frame behind a

  QVGEN_LANES AtOuter(const SlideSystem& s, const T& cosine, const T& sine) {
    // The rotation that a, b and c have to make is P' Rz(-theta) K', P that of theta's own stretch and K of
    // the last one.
    T third[3];
    from_outside(s, s.rotation[3] + 6, cosine, sine, third);
    from_outside(s, s.rotation[3], cosine, sine, first_axis);
    between = third[2];
    across = 1 - between * between;
    set_b(s, third[2]);
    set_a(s, third);
    for (int k = 0; k < 3; ++k) set_column(s, k, cosine, sine);
  }

  [[nodiscard]] QVGEN_LANES Twin times(const Twin& a, const Twin& b) const {
    return {a.x * b.x + square * (a.y * b.y), a.x * b.y + a.y * b.x};
  }

  /// The volume that the way and the slides' directions span: zero at a solution.
  [[nodiscard]] QVGEN_LANES Twin volume() const {
    Twin sum{T{}, T{}};
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Twin area = times(column[1][j], column[2][k]) - times(column[1][k], column[2][j]);
      sum = sum + times(column[0][i], area);
    }
    return sum;
  }

 private:
  /// A vector of the frame before theta, seen from before a.
  QVGEN_LANES static void from_outside(const SlideSystem& s, const double* v, const T& cosine, const T& sine,
                                       T (&result)[3]) {
    const T x = cosine * v[0] + sine * v[1], y = cosine * v[1] - sine * v[0];
    const double(&p)[9] = s.rotation[0];
    for (int i = 0; i < 3; ++i) result[i] = p[i] * x + p[3 + i] * y + p[6 + i] * v[2];
  }

  QVGEN_LANES void set_b(const SlideSystem& s, const T& n) {
    const T k = n - s.level;
    const double scale = 1 / s.bend_square;
    square = s.bend_square - k * k;
    cosine_b = {k * (s.bend[0] * scale), spread<T>(-s.bend[1] * scale)};
    sine_b = {k * (s.bend[1] * scale), spread<T>(s.bend[0] * scale)};
  }

  /// A constant vector turned by b and carried on into the frame behind a.
  QVGEN_LANES void through_b(const SlideSystem& s, const double* v, int step, Twin (&result)[3]) const {
    const Twin x = v[0] * cosine_b - v[step] * sine_b, y = v[0] * sine_b + v[step] * cosine_b;
    for (int i = 0; i < 3; ++i) {
      const double* row = s.rotation[1] + 3 * i;
      result[i] = row[0] * x + row[1] * y;
      result[i].x += row[2] * v[2 * step];
    }
  }

  QVGEN_LANES void set_a(const SlideSystem& s, const T (&third)[3]) {
    Twin w[3];
    through_b(s, s.rotation[2] + 2, 3, w);
    const T scale = 1 / across;
    const T x = third[0] * scale, y = third[1] * scale;
    cosine_a = x * w[0] + y * w[1];
    sine_a = y * w[0] - x * w[1];
  }

  QVGEN_LANES void set_column(const SlideSystem& s, int k, const T& cosine, const T& sine) {
    const double(&part)[4][3] = s.column[k];
    through_b(s, part[2], 1, column[k]);
    double turned[3];
    const double(&after)[9] = s.rotation[3];
    for (int i = 0; i < 3; ++i)
      turned[i] = after[i] * part[3][0] + after[3 + i] * part[3][1] + after[6 + i] * part[3][2];
    T(&far)[3] = outside[k];
    from_outside(s, turned, cosine, sine, far);
    const double(&p)[9] = s.rotation[0];
    for (int i = 0; i < 3; ++i) far[i] += p[i] * part[0][0] + p[3 + i] * part[0][1] + p[6 + i] * part[0][2];
    column[k][0] = column[k][0] + far[0] * cosine_a + far[1] * sine_a;
    column[k][1] = column[k][1] + far[1] * cosine_a - far[0] * sine_a;
    column[k][2].x += far[2];
    for (int i = 0; i < 3; ++i) column[k][i].x += part[1][i];
  }
};

/// Returns the resultant, of degree four in cosine and sine of the outer angle; it is zero at each angle of a
/// solution.
template <class T>
[[gnu::noinline]] T resultant_of_slides(const SlideSystem& s, const T& cosine, const T& sine) {
  // If the axes of a and c, of a and b or of b and c are parallel, their angles have no meaning, and the
  // equation is rounding: at an outer angle or two, or, of some poses, at all of them.
  constexpr double parallel = 1e-12;
  if (!(s.bend_square > parallel)) return spread<T>(std::nan(""));
  const AtOuter<T> at(s, cosine, sine);
  const auto f = at.volume();
  const T value = (f.x * f.x - at.square * (f.y * f.y)) * at.across;
  return at.across > parallel ? value : spread<T>(std::nan(""));
}

/// True if the polynomial is next to nothing beside what it is the difference of, at all outer angles: of
/// poses next to those that leave an outer angle free. Its roots are then no better than rounding.
template <class T>
[[gnu::noinline]] bool nearly_vanishes(const SlideSystem& s, const T& cosines, const T& sines) {
  const AtOuter<T> at(s, cosines, sines);
  const auto f = at.volume();
  const T sum = f.x * f.x + magnitude_of(at.square) * (f.y * f.y);
  const T difference = magnitude_of(T(f.x * f.x - at.square * (f.y * f.y)));
  double most = 0, of = 0;
  for (unsigned i = 0; i < sizeof(T) / sizeof(double); ++i) {
    most = std::fmax(most, difference[i] * at.across[i]);
    of = std::fmax(of, sum[i] * at.across[i]);
  }
  constexpr double share = 1e-6;
  return !(most > share * of);
}

}  // namespace
}  // namespace qvgen::inverse::elimination
