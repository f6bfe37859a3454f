// SPDX-License-Identifier: MIT
#pragma once

#include "joints.h"
#include "two_slides.h"

namespace qvgen::inverse::elimination {
namespace {

/// The way w = -(d1 s1 + d2 s2) in two slides, as near as it gets.
template <class T>
QVGEN_LANES void slides_of(const T (&column)[3][3], T& first, T& second) {
  T product[3][3];
  for (int i = 0; i < 3; ++i)
    for (int k = 1; k < 3; ++k)
      product[i][k] = column[i][0] * column[k][0] + column[i][1] * column[k][1] + column[i][2] * column[k][2];
  const T scale = -1 / (product[1][1] * product[2][2] - product[1][2] * product[1][2]);
  first = (product[0][1] * product[2][2] - product[0][2] * product[1][2]) * scale;
  second = (product[0][2] * product[1][1] - product[0][1] * product[1][2]) * scale;
}

/// A constant vector of the frame behind b, seen from the one behind a.
template <class T>
QVGEN_LANES void seen_through_b(const SlideSystem& s, const double (&v)[3], const T (&b)[2], T (&result)[3]) {
  const T x = v[0] * b[0] - v[1] * b[1], y = v[0] * b[1] + v[1] * b[0];
  for (int i = 0; i < 3; ++i) {
    const double* row = s.rotation[1] + 3 * i;
    result[i] = row[0] * x + row[1] * y + row[2] * v[2];
  }
}

/// The way or a slide's direction in the frame behind a.
template <class T>
QVGEN_LANES void column_at(const SlideSystem& s, const AtOuter<T>& at, int k, const T (&a)[2],
                           const T (&b)[2], T (&result)[3]) {
  const T(&far)[3] = at.outside[k];
  const T turned[3] = {far[0] * a[0] + far[1] * a[1], far[1] * a[0] - far[0] * a[1], far[2]};
  seen_through_b(s, s.column[k][2], b, result);
  for (int i = 0; i < 3; ++i) result[i] += turned[i] + s.column[k][1][i];
}

/// c turns the first axis behind b to where the rotation of all three has it, as a leaves that.
template <class T>
QVGEN_LANES void turn_of_c(const SlideSystem& s, const AtOuter<T>& at, const T (&a)[2], const T (&b)[2],
                           T (&c)[2]) {
  const T(&m)[3] = at.first_axis;
  const T goal[3] = {a[0] * m[0] + a[1] * m[1], a[0] * m[1] - a[1] * m[0], m[2]};
  for (int j = 0; j < 2; ++j) {
    const double(&k)[9] = s.rotation[2];
    T axis[3];
    seen_through_b(s, {k[j], k[3 + j], k[6 + j]}, b, axis);
    c[j] = axis[0] * goal[0] + axis[1] * goal[1] + axis[2] * goal[2];
  }
}

/// How the joints at an outer angle are taken: by the sign of the root that leaves the smaller volume, by the
/// other one, or by this one; a turned further, for places where it has no meaning of its own.
struct Taken {
  double sign = 0;
  bool other = false;
  double cosine = 1, sine = 0;
};

/// Equations that are left once an outer angle is known.
template <class T>
struct Left {
  T across;  ///< the square of the sine between the axes of a and c: at 0 only their sum or difference is
             ///< known
  T volume;  ///< that the way and the slides' directions span: 0 at a solution
  T box;     ///< volume if they were at right angles to each other
  T square;  ///< of the root, as a share of the largest
};

template <class T>
QVGEN_LANES void set_volume(const T (&column)[3][3], Left<T>& left) {
  T volume{}, square = spread<T>(1);
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    volume += column[0][k] * (column[1][i] * column[2][j] - column[1][j] * column[2][i]);
    T length{};
    for (int m = 0; m < 3; ++m) length += column[k][m] * column[k][m];
    // A way that is shorter than the arm's size is measured against that.
    square = square * (k == 0 ? T(length + 1) : length);
  }
  left.volume = volume;
  left.box = root(square);
}

/// The turns a, b, c at an outer angle.
template <class T>
struct Turns {
  T a[2], b[2], c[2];

  QVGEN_LANES Turns(const SlideSystem& s, const AtOuter<T>& at, const T& root, const Taken& taken) {
    const auto value = [&](const Conjugates<T>& twin) { return T(twin.x + root * twin.y); };
    b[0] = value(at.cosine_b);
    b[1] = value(at.sine_b);
    T cosine = value(at.cosine_a), sine = value(at.sine_a);
    const T square = cosine * cosine + sine * sine;
    // No number is no more than anything.
    cosine = square > 1e-3 ? cosine : spread<T>(1);
    sine = square > 1e-3 ? sine : T{};
    bring_to_length_one(cosine, sine);
    a[0] = cosine * taken.cosine - sine * taken.sine;
    a[1] = sine * taken.cosine + cosine * taken.sine;
    turn_of_c(s, at, a, b, c);
    bring_to_length_one(c[0], c[1]);
  }
};

/// All joints of the arm from outer angles.
template <class T>
[[gnu::noinline]] Left<T> substitute_slides(const Elimination& e, const SlideSystem& s, double size,
                                            const T& cosine, const T& sine, const Taken& taken,
                                            JointLanes<T>& result) {
  const AtOuter<T> at(s, cosine, sine);
  const T r = root(T(at.square > 0 ? at.square : T{}));
  const auto volume = at.volume();
  const auto plus = magnitude_of(T(volume.x + r * volume.y)) <= magnitude_of(T(volume.x - r * volume.y));
  const double usual = taken.other ? -1 : 1;
  const T signed_root = taken.sign == 0 ? (plus ? T(usual * r) : T(-usual * r)) : T(taken.sign * r);
  const Turns<T> turns(s, at, signed_root, taken);
  T column[3][3];
  for (int k = 0; k < 3; ++k) column_at(s, at, k, turns.a, turns.b, column[k]);
  T way[2];
  slides_of(column, way[0], way[1]);
  const T(*turn[3])[2] = {&turns.a, &turns.b, &turns.c};
  JointLanes<T> q;
  q.cosine[3] = cosine;
  q.sine[3] = sine;
  int turned = 0, slid = 0;
  for (int k = 1; k < joints; ++k) {
    const int i = from_outer[k];
    q.cosine[i] = e.slide[i] ? way[slid++] : (*turn[turned])[0];
    q.sine[i] = e.slide[i] ? T{} : (*turn[turned++])[1];
  }
  in_order_of_the_arm(e, size, q, result);
  Left<T> left;
  left.across = at.across;
  left.square = at.square * (1 / s.bend_square);
  set_volume(column, left);
  return left;
}

}  // namespace
}  // namespace qvgen::inverse::elimination
