// SPDX-License-Identifier: MIT
// Two equations in two angles (two_turns.h), and the trigonometric polynomial that is left of them when one
// angle is eliminated: 1, cosine and sine of that angle are along the cross product of both equations' waves,
// and cos² + sin² = 1 is of degree four in the other angle. C reads this text as well.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <qvgen/inverse/angles.h>

namespace qvgen::inverse {

/// Coefficients of (1, cos u, sin u) times (1, cos v, sin v), row by row; their sum is to vanish.
template <typename Scalar>
struct TwoTurnsEquation {
  Scalar c00, c01, c02, c10, c11, c12, c20, c21, c22;
};

/// Both equations.
template <typename Scalar>
struct TwoTurns {
  TwoTurnsEquation<Scalar> one, other;
};

namespace two_turns_cases {

/// one + c cos + s sin of an angle.
template <typename Scalar>
struct Wave {
  Scalar one, c, s;
};

template <typename Scalar>
Scalar wave_at(const Wave<Scalar>& wave, const Rotor<Scalar>& at) {
  return wave.one + wave.c * at.cosine + wave.s * at.sine;
}
template <typename Scalar>
Scalar wave_slope(const Wave<Scalar>& wave, const Rotor<Scalar>& at) {
  return wave.s * at.cosine - wave.c * at.sine;
}
template <typename Scalar>
Wave<Scalar> crossed_waves(const Wave<Scalar>& a, const Wave<Scalar>& b) {
  return {a.c * b.s - a.s * b.c, a.s * b.one - a.one * b.s, a.one * b.c - a.c * b.one};
}

/// An equation at a value of u: a wave of v.
template <typename Scalar>
Wave<Scalar> wave_of_second(const TwoTurnsEquation<Scalar>& m, const Rotor<Scalar>& u) {
  return {m.c00 + m.c10 * u.cosine + m.c20 * u.sine, m.c01 + m.c11 * u.cosine + m.c21 * u.sine,
          m.c02 + m.c12 * u.cosine + m.c22 * u.sine};
}
/// Its derivative by u.
template <typename Scalar>
Wave<Scalar> wave_of_second_by_first(const TwoTurnsEquation<Scalar>& m, const Rotor<Scalar>& u) {
  return {m.c20 * u.cosine - m.c10 * u.sine, m.c21 * u.cosine - m.c11 * u.sine,
          m.c22 * u.cosine - m.c12 * u.sine};
}

/// Real trigonometric polynomial: one + the sum of c[k - 1] cos(k u) + s[k - 1] sin(k u) for k = 1, ..., 4.
template <typename Scalar>
struct Harmonics {
  Scalar one;
  std::array<Scalar, 4> c;
  std::array<Scalar, 4> s;
};

/// a b - c d, which is of degree two.
template <typename Scalar>
Harmonics<Scalar> difference_of_products(const Wave<Scalar>& a, const Wave<Scalar>& b, const Wave<Scalar>& c,
                                         const Wave<Scalar>& d) {
  const Scalar half(0.5);
  const Scalar none(0);
  const Scalar ab_cc = half * a.c * b.c, ab_ss = half * a.s * b.s;
  const Scalar cd_cc = half * c.c * d.c, cd_ss = half * c.s * d.s;
  return {(a.one * b.one + (ab_cc + ab_ss)) - (c.one * d.one + (cd_cc + cd_ss)),
          {(a.one * b.c + a.c * b.one) - (c.one * d.c + c.c * d.one), (ab_cc - ab_ss) - (cd_cc - cd_ss), none,
           none},
          {(a.one * b.s + a.s * b.one) - (c.one * d.s + c.s * d.one),
           half * (a.c * b.s + a.s * b.c) - half * (c.c * d.s + c.s * d.c), none, none}};
}

/// Adds a multiple of the square of a polynomial of degree two.
template <typename Scalar>
void add_square(const Scalar& factor, const Harmonics<Scalar>& f, Harmonics<Scalar>& sum) {
  const Scalar half = Scalar(0.5), twice = Scalar(2) * f.one, c1 = f.c[0], s1 = f.s[0], c2 = f.c[1],
               s2 = f.s[1];
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
Harmonics<Scalar> eliminated_turn(const TwoTurns<Scalar>& e) {
  const Wave<Scalar> a = {e.one.c00, e.one.c10, e.one.c20}, b = {e.one.c01, e.one.c11, e.one.c21},
                     c = {e.one.c02, e.one.c12, e.one.c22};
  const Wave<Scalar> d = {e.other.c00, e.other.c10, e.other.c20}, f = {e.other.c01, e.other.c11, e.other.c21},
                     g = {e.other.c02, e.other.c12, e.other.c22};
  const Scalar none(0);
  Harmonics<Scalar> sum = {none, {none, none, none, none}, {none, none, none, none}};
  add_square(Scalar(-1), difference_of_products(b, g, c, f), sum);
  add_square(Scalar(1), difference_of_products(c, d, a, g), sum);
  add_square(Scalar(1), difference_of_products(a, f, b, d), sum);
  return sum;
}

/// Value and three derivatives of a polynomial.
template <typename Scalar>
struct Jet {
  Scalar value, slope, curvature, third;
};

/// Jets at both halves of an arc, side by side.
template <typename Scalar>
struct TwoJets {
  std::array<Scalar, 2> value;
  std::array<Scalar, 2> slope;
  std::array<Scalar, 2> curvature;
  std::array<Scalar, 2> third;
};

/// Harmonics 1 to 4 of a polynomial at one angle, and the derivative of each by its own angle, k u.
template <typename Scalar>
struct HarmonicsAt {
  Scalar v1, v2, v3, v4, d1, d2, d3, d4;

  HarmonicsAt(const Harmonics<Scalar>& f, const Rotor<Scalar>& at) {
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

template <typename Scalar>
Scalar value_at(const HarmonicsAt<Scalar>& h, const Scalar& one) {
  return ((one + h.v1) + h.v2) + (h.v3 + h.v4);
}
template <typename Scalar>
Scalar slope_of(const HarmonicsAt<Scalar>& h) {
  return (h.d1 + Scalar(2) * h.d2) + (Scalar(3) * h.d3 + Scalar(4) * h.d4);
}
template <typename Scalar>
Scalar curvature_of(const HarmonicsAt<Scalar>& h) {
  return -((h.v1 + Scalar(4) * h.v2) + (Scalar(9) * h.v3 + Scalar(16) * h.v4));
}
template <typename Scalar>
Scalar third_of(const HarmonicsAt<Scalar>& h) {
  return -((h.d1 + Scalar(8) * h.d2) + (Scalar(27) * h.d3 + Scalar(64) * h.d4));
}

template <typename Scalar>
Jet<Scalar> jet_at(const Harmonics<Scalar>& f, const Rotor<Scalar>& at) {
  const HarmonicsAt<Scalar> h(f, at);
  return {value_at(h, f.one), slope_of(h), curvature_of(h), third_of(h)};
}

template <typename Scalar>
TwoJets<Scalar> jets_at(const Harmonics<Scalar>& f, const Rotor<Scalar>& left, const Rotor<Scalar>& right) {
  const std::array<Rotor<Scalar>, 2> at = {left, right};
  TwoJets<Scalar> result;
  for (std::size_t i = 0; i < 2; ++i) {
    const HarmonicsAt<Scalar> h(f, at[i]);
    result.value[i] = value_at(h, f.one);
    result.slope[i] = slope_of(h);
    result.curvature[i] = curvature_of(h);
    result.third[i] = third_of(h);
  }
  return result;
}

/// Cosines and sines of the middles of the first arcs from -pi to -pi/2; the others are quarter turns away.
inline constexpr std::array<double, 8> middle_cosines = {
    -0.9951847266721969, -0.9569403357322088,  -0.881921264348355,  -0.773010453362737,
    -0.6343932841636455, -0.47139673682599764, -0.2902846772544624, -0.0980171403295606};
inline constexpr std::array<double, 8> middle_sines = {
    -0.0980171403295606, -0.2902846772544624, -0.47139673682599764, -0.6343932841636455,
    -0.773010453362737,  -0.881921264348355,  -0.9569403357322088,  -0.9951847266721969};

/// Jets at the middles of the first arcs: eight, and behind them those one, two and three quarter turns on.
template <typename Scalar>
struct FirstJets {
  std::array<Scalar, 32> value;
  std::array<Scalar, 32> slope;
  std::array<Scalar, 32> curvature;
  std::array<Scalar, 32> third;
};

/// Across the circle odd harmonics change their signs. A quarter turn on the second harmonic changes its
/// sign, and the others have their derivatives' places.
template <typename Scalar>
FirstJets<Scalar> first_jets(const Harmonics<Scalar>& f) {
  FirstJets<Scalar> result;
  for (std::size_t i = 0; i < 8; ++i) {
    const HarmonicsAt<Scalar> h(f, Rotor<Scalar>{Scalar(middle_cosines[i]), Scalar(middle_sines[i])});
    const Jet<Scalar> even = {f.one + (h.v2 + h.v4), Scalar(2) * h.d2 + Scalar(4) * h.d4,
                              Scalar(-4) * h.v2 - Scalar(16) * h.v4, Scalar(-8) * h.d2 - Scalar(64) * h.d4};
    const Jet<Scalar> odd = {h.v1 + h.v3, h.d1 + Scalar(3) * h.d3, -h.v1 - Scalar(9) * h.v3,
                             -h.d1 - Scalar(27) * h.d3};
    const Jet<Scalar> even_on = {f.one + (h.v4 - h.v2), Scalar(4) * h.d4 - Scalar(2) * h.d2,
                                 Scalar(4) * h.v2 - Scalar(16) * h.v4, Scalar(8) * h.d2 - Scalar(64) * h.d4};
    const Jet<Scalar> odd_on = {h.d1 - h.d3, Scalar(3) * h.v3 - h.v1, Scalar(9) * h.d3 - h.d1,
                                h.v1 - Scalar(27) * h.v3};
    result.value[i] = even.value + odd.value;
    result.slope[i] = even.slope + odd.slope;
    result.curvature[i] = even.curvature + odd.curvature;
    result.third[i] = even.third + odd.third;
    result.value[i + 8] = even_on.value + odd_on.value;
    result.slope[i + 8] = even_on.slope + odd_on.slope;
    result.curvature[i + 8] = even_on.curvature + odd_on.curvature;
    result.third[i + 8] = even_on.third + odd_on.third;
    result.value[i + 16] = even.value - odd.value;
    result.slope[i + 16] = even.slope - odd.slope;
    result.curvature[i + 16] = even.curvature - odd.curvature;
    result.third[i + 16] = even.third - odd.third;
    result.value[i + 24] = even_on.value - odd_on.value;
    result.slope[i + 24] = even_on.slope - odd_on.slope;
    result.curvature[i + 24] = even_on.curvature - odd_on.curvature;
    result.third[i + 24] = even_on.third - odd_on.third;
  }
  return result;
}

/// Bound of the fourth derivative.
template <typename Scalar>
Scalar fourth_bound(const Harmonics<Scalar>& f) {
  using std::sqrt;
  const std::array<double, 4> fourth_powers = {1.0, 16.0, 81.0, 256.0};
  Scalar sum(0);
  for (std::size_t k = 0; k < 4; ++k)
    sum = sum + Scalar(fourth_powers[k]) * Scalar(sqrt(Scalar(f.c[k] * f.c[k] + f.s[k] * f.s[k])));
  return sum;
}

}  // namespace two_turns_cases
}  // namespace qvgen::inverse
