// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/elimination/arm.h>

#include "lanes.h"

namespace qvgen::inverse::elimination {
namespace {

/// The functions of a line through p in direction l that Raghavan and Roth found to stay among themselves
/// under a motion: p, l, p.p, p.l, p x l, (p.p) l - 2 (p.l) p, 1, in this order. A motion acts on them
/// linearly.
inline constexpr int line_functions = 15;

template <class T>
QVGEN_LANES void line_values(const T (&p)[3], const T (&l)[3], T (&f)[line_functions]) {
  const T pp = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  const T pl = p[0] * l[0] + p[1] * l[1] + p[2] * l[2];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    f[i] = p[i];
    f[3 + i] = l[i];
    f[8 + i] = p[j] * l[k] - p[k] * l[j];
    f[11 + i] = pp * l[i] - 2 * pl * p[i];
  }
  f[6] = pp;
  f[7] = pl;
  f[14] = T{} + 1;
}

template <class T, class Number>
QVGEN_LANES void rotate(const Number (&r)[9], const T* x, T* y) {
  for (int i = 0; i < 3; ++i) y[i] = r[3 * i] * x[0] + r[3 * i + 1] * x[1] + r[3 * i + 2] * x[2];
}

/// r = a b, or with one of them transposed; by rows.
inline void multiply(const double (&a)[9], const double (&b)[9], bool a_transposed, bool b_transposed,
                     double (&r)[9]) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double sum = 0;
      for (int k = 0; k < 3; ++k)
        sum += a[a_transposed ? 3 * k + i : 3 * i + k] * b[b_transposed ? 3 * j + k : 3 * k + j];
      r[3 * i + j] = sum;
    }
}

/// The functions of a moved line, or any linear combination of such.
template <class T, class Number>
QVGEN_LANES void move_line(const Number (&r)[9], const Number (&t)[3], const T (&f)[line_functions],
                           T (&g)[line_functions]) {
  T p[3], l[3], x[3], k[3];
  rotate(r, f, p);
  rotate(r, f + 3, l);
  rotate(r, f + 8, x);
  rotate(r, f + 11, k);
  const T one = f[14];
  const Number tt = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
  const T tp = t[0] * p[0] + t[1] * p[1] + t[2] * p[2];
  const T tl = t[0] * l[0] + t[1] * l[1] + t[2] * l[2];
  const T along = 2 * (tl + f[7]);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, m = (i + 2) % 3;
    g[i] = p[i] + t[i] * one;
    g[3 + i] = l[i];
    g[8 + i] = x[i] + t[j] * l[m] - t[m] * l[j];
    g[11 + i] = k[i] - 2 * (t[j] * x[m] - t[m] * x[j]) + tt * l[i] - t[i] * along;
  }
  g[6] = f[6] + 2 * tp + tt * one;
  g[7] = f[7] + tl;
  g[14] = one;
}

/// A turn about z by `angle` acts as m[0] + cos m[1] + sin m[2].
template <class T>
QVGEN_LANES void turn_modes(const T (&f)[line_functions], T (&m)[3][line_functions]) {
  const T zero = T{};
  for (int i : {2, 5, 6, 7, 10, 13, 14}) {
    m[0][i] = f[i];
    m[1][i] = zero;
    m[2][i] = zero;
  }
  for (int i : {0, 3, 8, 11}) {
    m[0][i] = zero;
    m[0][i + 1] = zero;
    m[1][i] = f[i];
    m[1][i + 1] = f[i + 1];
    m[2][i] = -f[i + 1];
    m[2][i + 1] = f[i];
  }
}

/// A slide along z by d acts as m[0] + d m[1] + d^2 m[2].
template <class T>
QVGEN_LANES void slide_modes(const T (&f)[line_functions], T (&m)[3][line_functions]) {
  const T zero = T{};
  for (int i = 0; i < line_functions; ++i) {
    m[0][i] = f[i];
    m[1][i] = zero;
    m[2][i] = zero;
  }
  m[1][2] = f[14];
  m[1][6] = 2 * f[2];
  m[1][7] = f[5];
  m[1][8] = -f[4];
  m[1][9] = f[3];
  m[1][11] = 2 * f[9];
  m[1][12] = -2 * f[8];
  m[1][13] = -2 * f[7];
  m[2][6] = f[14];
  m[2][11] = f[3];
  m[2][12] = f[4];
  m[2][13] = -f[5];
}

/// Half-angle tangents are counted from this angle, so that half a turn is nothing special.
inline constexpr double cosine_of_origin = 0.32999315767856785;  // of 1.2345 rad
inline constexpr double sine_of_origin = 0.9439833239445111;

/// From modes to the coefficients of x^2, x, 1: x the half-angle tangent (times 1 + x^2), or the slide.
template <class T>
QVGEN_LANES void powers_of(const T (&f)[line_functions], bool slide, T (&e)[3][line_functions]) {
  T m[3][line_functions];
  if (slide) {
    slide_modes(f, m);
    for (int i = 0; i < line_functions; ++i) {
      e[0][i] = m[2][i];
      e[1][i] = m[1][i];
      e[2][i] = m[0][i];
    }
    return;
  }
  turn_modes(f, m);
  for (int i = 0; i < line_functions; ++i) {
    const T cosine = cosine_of_origin * m[1][i] + sine_of_origin * m[2][i];
    const T sine = cosine_of_origin * m[2][i] - sine_of_origin * m[1][i];
    e[0][i] = m[0][i] - cosine;
    e[1][i] = 2 * sine;
    e[2][i] = m[0][i] + cosine;
  }
}

}  // namespace
}  // namespace qvgen::inverse::elimination
