// SPDX-License-Identifier: MIT
#pragma once

#include "lanes.h"

namespace qvgen::inverse::elimination {
namespace {

/// Degree of the resultant in cosine and sine of the outer angle.
inline constexpr int degree = 8;
inline constexpr int samples = 20;
/// The circle is looked at in arcs, each by the half-angle tangent from its middle.
inline constexpr int arcs = 8;
inline constexpr int controls = 2 * degree + 1;
inline constexpr double tangent_of_arc = 0.19891236737965800691;  // tan(pi/16)

/// Cosines and sines of multiples of an angle.
struct Multiples {
  double cosine[64];
  double sine[64];
};

constexpr Multiples multiples(long double cosine, long double sine, int count) {
  Multiples m{};
  long double c = 1, s = 0;
  for (int k = 0; k < count; ++k) {
    m.cosine[k] = static_cast<double>(c);
    m.sine[k] = static_cast<double>(s);
    const long double next = c * cosine - s * sine;
    s = s * cosine + c * sine;
    c = next;
  }
  return m;
}

// The samples' angles are odd multiples of pi/20.
inline constexpr Multiples twentieths = multiples(0.98768834059513772619L, 0.15643446504023086901L, 40);

/// The arcs' middles, and their multiples up to the degree: by multiple, then by arc. They lie 0.2 rad (its
/// cosine 99/101) beyond odd multiples of pi/8, so that no arc ends at the angles that right angles make
/// roots.
struct ArcTable {
  double cosine[degree + 1][arcs];
  double sine[degree + 1][arcs];
};

constexpr ArcTable make_arc_table() {
  constexpr Multiples eighths = multiples(0.92387953251128675613L, 0.38268343236508977173L, 16);
  constexpr long double beyond[2] = {99 / 101.0L, 20 / 101.0L};
  ArcTable t{};
  for (int arc = 0; arc < arcs; ++arc) {
    const long double c = eighths.cosine[2 * arc + 1], s = eighths.sine[2 * arc + 1];
    const Multiples own = multiples(c * beyond[0] - s * beyond[1], s * beyond[0] + c * beyond[1], degree + 1);
    for (int k = 0; k <= degree; ++k) {
      t.cosine[k][arc] = own.cosine[k];
      t.sine[k][arc] = own.sine[k];
    }
  }
  return t;
}
inline constexpr ArcTable arc_table = make_arc_table();

struct SampleTable {
  alignas(64) double cosine[samples];
  alignas(64) double sine[samples];
};

constexpr SampleTable make_sample_table() {
  SampleTable t{};
  for (int j = 0; j < samples; ++j) {
    t.cosine[j] = twentieths.cosine[2 * j + 1];
    t.sine[j] = twentieths.sine[2 * j + 1];
  }
  return t;
}
inline constexpr SampleTable sample_table = make_sample_table();

/// From the samples to the coefficients: 1, cos to cos 8, sin to sin 8, and cos 9, sin 9, which are zero but
/// for rounding.
struct FourierTable {
  alignas(64) double weight[samples][24];
};

constexpr FourierTable make_fourier_table() {
  FourierTable t{};
  for (int j = 0; j < samples; ++j)
    for (int k = 0; k <= 9; ++k) {
      const int angle = k * (2 * j + 1) % 40;
      const double scale = (k == 0 ? 1.0 : 2.0) / samples;
      t.weight[j][k <= degree ? k : 17] = scale * twentieths.cosine[angle];
      if (k > 0) t.weight[j][k <= degree ? degree + k : 18] = scale * twentieths.sine[angle];
    }
  return t;
}
inline constexpr FourierTable fourier_table = make_fourier_table();

/// Bernstein coefficients of cos(k a) (1 + t^2)^8 and sin(k a) (1 + t^2)^8 over an arc, t = tan(a/2): even
/// and odd ones, so that the first half says all.
struct BernsteinTable {
  double cosine[degree + 1][degree + 1];
  double sine[degree + 1][degree + 1];
};

struct Polynomial {
  long double c[controls] = {};
};

constexpr Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial r;
  for (int i = 0; i < controls; ++i)
    for (int j = 0; i + j < controls; ++j) r.c[i + j] += a.c[i] * b.c[j];
  return r;
}

/// From powers of t to Bernstein coefficients on -tangent_of_arc, tangent_of_arc.
constexpr Polynomial bernstein(const Polynomial& p) {
  // t = tangent (2 y - 1): to powers of y first.
  Polynomial in_y, power, step;
  power.c[0] = 1;
  step.c[0] = -static_cast<long double>(tangent_of_arc);
  step.c[1] = 2 * static_cast<long double>(tangent_of_arc);
  for (int k = 0; k < controls; ++k) {
    for (int i = 0; i < controls; ++i) in_y.c[i] += p.c[k] * power.c[i];
    power = product(power, step);
  }
  Polynomial b;
  for (int i = 0; i < controls; ++i) {
    long double share = 1;
    for (int m = 0; m <= i; ++m) {
      b.c[i] += share * in_y.c[m];
      if (m < i) share = share * (i - m) / (controls - 1 - m);
    }
  }
  return b;
}

constexpr BernsteinTable make_bernstein_table() {
  BernsteinTable t{};
  Polynomial square, twice, linear;  // 1 + t^2; real and imaginary part of (1 + i t)^2
  square.c[0] = square.c[2] = 1;
  twice.c[0] = 1;
  twice.c[2] = -1;
  linear.c[1] = 2;
  Polynomial real, imaginary;  // of (1 + i t)^2k
  real.c[0] = 1;
  for (int k = 0; k <= degree; ++k) {
    Polynomial rest;
    rest.c[0] = 1;
    for (int i = k; i < degree; ++i) rest = product(rest, square);
    const Polynomial even = bernstein(product(real, rest)), odd = bernstein(product(imaginary, rest));
    for (int i = 0; i <= degree; ++i) {
      t.cosine[i][k] = static_cast<double>(even.c[i]);
      t.sine[i][k] = static_cast<double>(odd.c[i]);
    }
    Polynomial next = product(real, twice);
    const Polynomial cross = product(imaginary, linear);
    for (int i = 0; i < controls; ++i) next.c[i] -= cross.c[i];
    imaginary = product(imaginary, twice);
    const Polynomial other = product(real, linear);
    for (int i = 0; i < controls; ++i) imaginary.c[i] += other.c[i];
    real = next;
  }
  return t;
}
inline constexpr BernsteinTable bernstein_table = make_bernstein_table();

}  // namespace
}  // namespace qvgen::inverse::elimination
