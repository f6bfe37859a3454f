// SPDX-License-Identifier: MIT
// Two equations in two angles (two_turns.h), and the trigonometric polynomial that is left of them when one
// angle is eliminated: 1, cosine and sine of that angle are along the cross product of both equations' waves,
// and cos² + sin² = 1 is of degree four in the other angle.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <qvgen/inverse/angles.h>

namespace qvgen::inverse {

/// sum of m[3 j + k] a_j b_k with a = (1, cos u, sin u) and b = (1, cos v, sin v).
template <typename Scalar>
using TwoTurnsEquation = std::array<Scalar, 9>;

/// Both equations, which are to vanish.
template <typename Scalar>
struct TwoTurns {
  std::array<TwoTurnsEquation<Scalar>, 2> rows;
};

namespace two_turns_cases {

/// one + c cos + s sin of an angle.
template <typename Scalar>
struct Wave {
  Scalar one, c, s;
};

template <typename Scalar>
Scalar dot(const Wave<Scalar>& wave, const Rotor<Scalar>& at) {
  return wave.one + wave.c * at.cosine + wave.s * at.sine;
}
template <typename Scalar>
Scalar slope(const Wave<Scalar>& wave, const Rotor<Scalar>& at) {
  return wave.s * at.cosine - wave.c * at.sine;
}

/// An equation at a value of u: a wave of v.
template <typename Scalar>
Wave<Scalar> of_second(const TwoTurnsEquation<Scalar>& m, const Rotor<Scalar>& u) {
  const auto entry = [&](std::size_t k) { return m[k] + m[3 + k] * u.cosine + m[6 + k] * u.sine; };
  return {entry(0), entry(1), entry(2)};
}
/// Its derivative by u.
template <typename Scalar>
Wave<Scalar> of_second_by_first(const TwoTurnsEquation<Scalar>& m, const Rotor<Scalar>& u) {
  const auto entry = [&](std::size_t k) { return m[6 + k] * u.cosine - m[3 + k] * u.sine; };
  return {entry(0), entry(1), entry(2)};
}

template <typename Scalar>
Wave<Scalar> cross(const Wave<Scalar>& a, const Wave<Scalar>& b) {
  return {a.c * b.s - a.s * b.c, a.s * b.one - a.one * b.s, a.one * b.c - a.c * b.one};
}

/// Real trigonometric polynomial: one + the sum of c[k - 1] cos(k u) + s[k - 1] sin(k u) for k = 1, ...,
/// degree.
template <typename Scalar, std::size_t degree>
struct Harmonics {
  Scalar one{0};
  std::array<Scalar, degree> c{}, s{};
};

/// Product of two waves.
template <typename Scalar>
Harmonics<Scalar, 2> product(const Wave<Scalar>& a, const Wave<Scalar>& b) {
  const Scalar half(0.5), cc = half * a.c * b.c, ss = half * a.s * b.s;
  return {a.one * b.one + (cc + ss),
          {a.one * b.c + a.c * b.one, cc - ss},
          {a.one * b.s + a.s * b.one, half * (a.c * b.s + a.s * b.c)}};
}

template <typename Scalar>
Harmonics<Scalar, 2> difference(const Harmonics<Scalar, 2>& a, const Harmonics<Scalar, 2>& b) {
  return {a.one - b.one, {a.c[0] - b.c[0], a.c[1] - b.c[1]}, {a.s[0] - b.s[0], a.s[1] - b.s[1]}};
}

/// Adds a multiple of a square.
template <typename Scalar>
void add_square(const Scalar& factor, const Harmonics<Scalar, 2>& f, Harmonics<Scalar, 4>& sum) {
  const Scalar half(0.5), twice = Scalar(2) * f.one, c1 = f.c[0], s1 = f.s[0], c2 = f.c[1], s2 = f.s[1];
  sum.one = sum.one + factor * (f.one * f.one + half * ((c1 * c1 + s1 * s1) + (c2 * c2 + s2 * s2)));
  sum.c[0] = sum.c[0] + factor * (twice * c1 + (c1 * c2 + s1 * s2));
  sum.s[0] = sum.s[0] + factor * (twice * s1 + (c1 * s2 - s1 * c2));
  sum.c[1] = sum.c[1] + factor * (half * (c1 * c1 - s1 * s1) + twice * c2);
  sum.s[1] = sum.s[1] + factor * (c1 * s1 + twice * s2);
  sum.c[2] = sum.c[2] + factor * (c1 * c2 - s1 * s2);
  sum.s[2] = sum.s[2] + factor * (c1 * s2 + s1 * c2);
  sum.c[3] = sum.c[3] + factor * (half * (c2 * c2 - s2 * s2));
  sum.s[3] = sum.s[3] + factor * (c2 * s2);
}

/// The second angle eliminated: (1, cos v, sin v) is along the cross product of both waves, whose entries are
/// polynomials in u; cos² + sin² = 1 makes them one of degree four.
template <typename Scalar>
Harmonics<Scalar, 4> eliminated(const TwoTurns<Scalar>& e) {
  const auto wave = [&](std::size_t row, std::size_t k) {
    const auto& m = e.rows[row];
    return Wave<Scalar>{m[k], m[3 + k], m[6 + k]};
  };
  Harmonics<Scalar, 4> sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    add_square(Scalar(k == 0 ? -1 : 1),
               difference(product(wave(0, i), wave(1, j)), product(wave(0, j), wave(1, i))), sum);
  }
  return sum;
}

/// Value and three derivatives of a polynomial.
template <typename Scalar>
struct Jet {
  Scalar value, slope, curvature, third;
};

/// Jets at several places, side by side.
template <typename Scalar, std::size_t count>
struct Jets {
  std::array<Scalar, count> value, slope, curvature, third;
  [[nodiscard]] Jet<Scalar> at(std::size_t i) const { return {value[i], slope[i], curvature[i], third[i]}; }
};

/// Harmonics 1 to 4 of a polynomial at one angle, and the derivative of each by its own angle, k u.
template <typename Scalar>
struct HarmonicsAt {
  Scalar v1, v2, v3, v4, d1, d2, d3, d4;

  HarmonicsAt(const Harmonics<Scalar, 4>& f, const Rotor<Scalar>& at) {
    const Scalar c1 = at.cosine, s1 = at.sine;
    const Scalar c2 = c1 * c1 - s1 * s1, s2 = c1 * s1 + c1 * s1;
    const Scalar c3 = c1 * c2 - s1 * s2, s3 = c1 * s2 + s1 * c2, c4 = c2 * c2 - s2 * s2,
                 s4 = c2 * s2 + c2 * s2;
    v1 = f.c[0] * c1 + f.s[0] * s1;
    v2 = f.c[1] * c2 + f.s[1] * s2;
    v3 = f.c[2] * c3 + f.s[2] * s3;
    v4 = f.c[3] * c4 + f.s[3] * s4;
    d1 = f.s[0] * c1 - f.c[0] * s1;
    d2 = f.s[1] * c2 - f.c[1] * s2;
    d3 = f.s[2] * c3 - f.c[2] * s3;
    d4 = f.s[3] * c4 - f.c[3] * s4;
  }
};

template <typename Scalar, std::size_t count>
Jets<Scalar, count> jets(const Harmonics<Scalar, 4>& f, const std::array<Rotor<Scalar>, count>& at) {
  Jets<Scalar, count> result;
  for (std::size_t i = 0; i < count; ++i) {
    const HarmonicsAt<Scalar> h(f, at[i]);
    result.value[i] = ((f.one + h.v1) + h.v2) + (h.v3 + h.v4);
    result.slope[i] = (h.d1 + Scalar(2) * h.d2) + (Scalar(3) * h.d3 + Scalar(4) * h.d4);
    result.curvature[i] = -((h.v1 + Scalar(4) * h.v2) + (Scalar(9) * h.v3 + Scalar(16) * h.v4));
    result.third[i] = -((h.d1 + Scalar(8) * h.d2) + (Scalar(27) * h.d3 + Scalar(64) * h.d4));
  }
  return result;
}

/// Jets at places and, behind them, at the places across the circle: there odd harmonics change their signs.
template <typename Scalar, std::size_t count>
Jets<Scalar, 2 * count> jets_across(const Harmonics<Scalar, 4>& f,
                                    const std::array<Rotor<Scalar>, count>& at) {
  Jets<Scalar, 2 * count> result;
  for (std::size_t i = 0; i < count; ++i) {
    const HarmonicsAt<Scalar> h(f, at[i]);
    const auto put = [i](std::array<Scalar, 2 * count>& to, const Scalar& even, const Scalar& odd) {
      to[i] = even + odd;
      to[i + count] = even - odd;
    };
    put(result.value, f.one + (h.v2 + h.v4), h.v1 + h.v3);
    put(result.slope, Scalar(2) * h.d2 + Scalar(4) * h.d4, h.d1 + Scalar(3) * h.d3);
    put(result.curvature, Scalar(-4) * h.v2 - Scalar(16) * h.v4, -h.v1 - Scalar(9) * h.v3);
    put(result.third, Scalar(-8) * h.d2 - Scalar(64) * h.d4, -h.d1 - Scalar(27) * h.d3);
  }
  return result;
}

/// Bound of the fourth derivative.
template <typename Scalar>
Scalar fourth_bound(const Harmonics<Scalar, 4>& f) {
  using std::sqrt;
  Scalar sum(0);
  for (std::size_t k = 0; k < 4; ++k)
    sum = sum + Scalar(static_cast<double>((k + 1) * (k + 1) * (k + 1) * (k + 1))) *
                    Scalar(sqrt(Scalar(f.c[k] * f.c[k] + f.s[k] * f.s[k])));
  return sum;
}

}  // namespace two_turns_cases
}  // namespace qvgen::inverse
