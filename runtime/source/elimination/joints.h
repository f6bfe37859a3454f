// SPDX-License-Identifier: MIT
#pragma once

#include "determinant.h"

namespace qvgen::inverse::elimination {
namespace {

/// Joint values in lanes: cosine and sine of an angle, or a slide's length (m) and nothing.
template <class T>
struct JointLanes {
  T cosine[joints];
  T sine[joints];
};

/// The vector that elimination finds at an outer angle that belongs to a solution: the null vector of the
/// 6 x 6 matrix, or of what is left of it to first order.
template <class T>
QVGEN_LANES void null_vector(Kernel<T>& kernel, Pair pair, T (&z)[3]) {
  T x[6];
  if (pair == Pair::confuses) {
    FirstOrder<T> first;
    first.eliminate(kernel.matrix, kernel.derivative);
    // The longer row of the 2 x 2 block decides about the two last columns.
    const T upper = magnitude_of(first.a[4][10]) + magnitude_of(first.a[4][11]);
    const T lower = magnitude_of(first.a[5][10]) + magnitude_of(first.a[5][11]);
    T y[6];
    y[4] = upper > lower ? first.a[4][11] : first.a[5][11];
    y[5] = upper > lower ? -first.a[4][10] : -first.a[5][10];
    for (int k = 3; k >= 0; --k) {
      T sum = first.a[k][4] * y[4] + first.a[k][5] * y[5];
      for (int j = k + 1; j < 4; ++j) sum += first.a[k][j] * y[j];
      y[k] = -sum / first.a[k][k];
    }
    for (int k = 0; k < 6; ++k) x[FirstOrder<T>::column(k)] = y[k];
  } else {
    T sign = spread<T>(1);
    T(&m)[6][6] = kernel.matrix;
#pragma GCC unroll 6
    for (int k = 0; k < 5; ++k) {
      pivot(m, k, sign);
      const T inverse = 1.0 / m[k][k];
#pragma GCC unroll 6
      for (int i = k + 1; i < 6; ++i) {
        const T factor = m[i][k] * inverse;
#pragma GCC unroll 6
        for (int j = k + 1; j < 6; ++j) m[i][j] = m[i][j] - factor * m[k][j];
      }
    }
    x[5] = spread<T>(1);
#pragma GCC unroll 6
    for (int k = 4; k >= 0; --k) {
      T sum = m[k][5];
#pragma GCC unroll 6
      for (int j = k + 1; j < 5; ++j) sum += m[k][j] * x[j];
      x[k] = -sum / m[k][k];
    }
  }
  // (a; b) = (x_u z; z), each up to a factor: the longer.
  const T a = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const T b = x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
  for (int i = 0; i < 3; ++i) z[i] = a > b ? x[i] : x[3 + i];
}

/// The longest of three vectors, as the ratio of two neighbours in it: x of (x^2, x, 1) without dividing, so
/// that an infinite one does no harm.
template <class T>
QVGEN_LANES void longest_ratio(const T (&y)[9], int along, int across, T& numerator, T& denominator) {
  T square[3], power[3];
  for (int i = 0; i < 3; ++i) {
    square[i] = T{};
    for (int j = 0; j < 3; ++j) square[i] += y[across * i + along * j] * y[across * i + along * j];
  }
  const auto second = square[1] > square[0];
  const T larger = second ? square[1] : square[0];
  const auto third = square[2] > larger;
  for (int j = 0; j < 3; ++j) {
    const T of_two = second ? y[across + along * j] : y[along * j];
    power[j] = third ? y[2 * across + along * j] : of_two;
  }
  const auto far = magnitude_of(power[0]) > magnitude_of(power[2]);
  numerator = far ? power[0] : power[1];
  denominator = far ? power[1] : power[2];
}

template <class T>
QVGEN_LANES void joint_of_ratio(const T& numerator, const T& denominator, bool slide, T& cosine, T& sine) {
  if (slide) {
    cosine = numerator / denominator;
    sine = T{};
    return;
  }
  const T n = numerator * numerator, d = denominator * denominator;
  const T scale = 1 / (n + d);
  const T c = (d - n) * scale, s = 2 * numerator * denominator * scale;
  cosine = cosine_of_origin * c - sine_of_origin * s;
  sine = sine_of_origin * c + cosine_of_origin * s;
}

/// A vector turned by a joint.
template <class T>
QVGEN_LANES void turn_about_z(const T& cosine, const T& sine, T (&v)[3]) {
  const T x = cosine * v[0] - sine * v[1];
  v[1] = sine * v[0] + cosine * v[1];
  v[0] = x;
}

template <class T>
QVGEN_LANES void bring_to_length_one(T& cosine, T& sine) {
  const T scale = 1 / root(T(cosine * cosine + sine * sine + 1e-300));
  cosine = cosine * scale;
  sine = sine * scale;
}

/// Joints 2' and 3' from the line that the others carry joint 1's axis to, and joint 1' from what is left.
template <class T>
QVGEN_LANES void rest_of_joints(const Elimination& e, const Motion (&link)[6], JointLanes<T>& q) {
  T p[3], l[3];
  for (int i = 0; i < 3; ++i) {
    p[i] = spread<T>(link[5].translation[i]);
    l[i] = spread<T>(link[5].rotation[3 * i + 2]);
  }
  for (int j = 5; j >= 3; --j) {
    if (e.slide[j]) {
      p[2] += q.cosine[j];
    } else {
      turn_about_z(q.cosine[j], q.sine[j], p);
      turn_about_z(q.cosine[j], q.sine[j], l);
    }
    T moved[3], turned[3];
    rotate(link[j - 1].rotation, p, moved);
    rotate(link[j - 1].rotation, l, turned);
    for (int i = 0; i < 3; ++i) {
      p[i] = moved[i] + link[j - 1].translation[i];
      l[i] = turned[i];
    }
  }
  T line[15], value[4];
  line_values(p, l, line);
  for (int k = 0; k < 4; ++k) {
    value[k] = T{};
    for (int i = 0; i < 15; ++i) value[k] += e.pair_values[k][i] * line[i];
  }
  for (int k = 0; k < 2; ++k) {
    q.cosine[1 + k] = value[2 * k];
    q.sine[1 + k] = value[2 * k + 1];
    if (!e.slide[1 + k]) bring_to_length_one(q.cosine[1 + k], q.sine[1 + k]);
  }
  // The first row of R1 J2 R2 ... R6, which J1 turns to (1, 0, 0).
  T row[3];
  for (int i = 0; i < 3; ++i) row[i] = spread<T>(link[0].rotation[i]);
  for (int j = 1; j < 6; ++j) {
    if (!e.slide[j]) {
      const T x = row[0] * q.cosine[j] + row[1] * q.sine[j];
      row[1] = row[1] * q.cosine[j] - row[0] * q.sine[j];
      row[0] = x;
    }
    T next[3];
    const double(&r)[9] = link[j].rotation;
    for (int i = 0; i < 3; ++i) next[i] = row[0] * r[i] + row[1] * r[3 + i] + row[2] * r[6 + i];
    for (int i = 0; i < 3; ++i) row[i] = next[i];
  }
  q.cosine[0] = row[0];
  q.sine[0] = row[1];
  bring_to_length_one(q.cosine[0], q.sine[0]);
}

/// From the loop's order, direction and unit of length to the arm's.
template <class T>
QVGEN_LANES void in_order_of_the_arm(const Elimination& e, double size, const JointLanes<T>& q,
                                     JointLanes<T>& result) {
  const double sense = e.backwards ? -1 : 1;
  for (int i = 0; i < joints; ++i) {
    const int j = e.joint[i];
    result.cosine[j] = e.slide[i] ? T(q.cosine[i] * (sense * size)) : q.cosine[i];
    result.sine[j] = e.slide[i] ? T{} : T(q.sine[i] * sense);
  }
}

/// All joints of the arm from outer angles.
template <class T>
[[gnu::noinline]] void substitute_back(const Elimination& e, const PoseSystem& system, double size,
                                       const T& cosine, const T& sine, JointLanes<T>& result) {
  Kernel<T> kernel;
  kernel.set(system, e.pair, cosine, sine);
  T z[3], y[9];
  null_vector(kernel, e.pair, z);
  for (int k = 0; k < 9; ++k)
    y[k] = kernel.basis[0][k] * z[0] + kernel.basis[1][k] * z[1] + kernel.basis[2][k] * z[2];
  JointLanes<T> q;
  q.cosine[3] = cosine;
  q.sine[3] = sine;
  T numerator, denominator;
  longest_ratio(y, 3, 1, numerator, denominator);
  joint_of_ratio(numerator, denominator, e.slide[4], q.cosine[4], q.sine[4]);
  longest_ratio(y, 1, 3, numerator, denominator);
  joint_of_ratio(numerator, denominator, e.slide[5], q.cosine[5], q.sine[5]);
  rest_of_joints(e, system.link, q);
  in_order_of_the_arm(e, size, q, result);
}

}  // namespace
}  // namespace qvgen::inverse::elimination
