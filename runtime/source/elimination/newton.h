// SPDX-License-Identifier: MIT
#pragma once

#include "joints.h"

namespace qvgen::inverse::elimination {
namespace {

/// J step = what is left to the pose, by rows: displacement in units of the arm's size, then turn.
template <class T>
struct Linear {
  T a[joints][joints + 1];
  T miss;  ///< squared distance of the poses: displacement, and the difference of the rotation matrices
};

template <class T>
QVGEN_LANES void linearise(const Chain& chain, const Goal& goal, const JointLanes<T>& q, Linear<T>& result) {
  T r[3][3], p[3], axis[joints][3], point[joints][3];
  for (int i = 0; i < 3; ++i) {
    p[i] = T{};
    for (int k = 0; k < 3; ++k) r[i][k] = spread<T>(i == k ? 1 : 0);
  }
#pragma GCC unroll 6
  for (int j = 0; j < joints; ++j) {
    for (int i = 0; i < 3; ++i) {
      axis[j][i] = r[i][2];
      point[j][i] = p[i];
    }
    const Motion& link = chain.links[j];
    for (int i = 0; i < 3; ++i) {
      T(&row)[3] = r[i];
      if (chain.slides[j]) {
        p[i] += q.cosine[j] * row[2];
      } else {
        const T x = row[0] * q.cosine[j] + row[1] * q.sine[j];
        row[1] = row[1] * q.cosine[j] - row[0] * q.sine[j];
        row[0] = x;
      }
      p[i] += row[0] * link.translation[0] + row[1] * link.translation[1] + row[2] * link.translation[2];
      const T x = row[0], y = row[1], z = row[2];
      for (int k = 0; k < 3; ++k)
        row[k] = x * link.rotation[k] + y * link.rotation[3 + k] + z * link.rotation[6 + k];
    }
  }
  const double scale = 1 / chain.size;
  T away[3], turn[3];
  T miss{};
  for (int i = 0; i < 3; ++i) {
    away[i] = (goal.translation[i] - p[i]) * scale;
    turn[i] = T{};
    miss += away[i] * away[i];
  }
  for (int k = 0; k < 3; ++k) {
    T gap[3];
    for (int i = 0; i < 3; ++i) {
      gap[i] = goal.rotation[3 * i + k] - r[i][k];
      miss += gap[i] * gap[i];
    }
    for (int i = 0; i < 3; ++i) {
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      turn[i] += 0.5 * (r[a][k] * gap[b] - r[b][k] * gap[a]);
    }
  }
  result.miss = miss;
#pragma GCC unroll 6
  for (int j = 0; j < joints; ++j) {
    T from[3];
    for (int i = 0; i < 3; ++i) from[i] = p[i] - point[j][i];
    for (int i = 0; i < 3; ++i) {
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      if (chain.slides[j]) {
        result.a[i][j] = axis[j][i] * scale;
        result.a[3 + i][j] = T{};
      } else {
        result.a[i][j] = (axis[j][a] * from[b] - axis[j][b] * from[a]) * scale;
        result.a[3 + i][j] = axis[j][i];
      }
    }
  }
  for (int i = 0; i < 3; ++i) {
    result.a[i][joints] = away[i];
    result.a[3 + i][joints] = turn[i];
  }
}

/// Solves by elimination with row pivots; the solution takes the last column's place.
template <class T>
QVGEN_LANES void solve_linear(T (&a)[joints][joints + 1]) {
  T sign = spread<T>(1);
#pragma GCC unroll 6
  for (int k = 0; k < joints; ++k) {
    pivot(a, k, sign);
    const T inverse = 1.0 / a[k][k];
#pragma GCC unroll 7
    for (int j = k + 1; j <= joints; ++j) a[k][j] = a[k][j] * inverse;
#pragma GCC unroll 6
    for (int i = k + 1; i < joints; ++i)
#pragma GCC unroll 7
      for (int j = k + 1; j <= joints; ++j) a[i][j] = a[i][j] - a[i][k] * a[k][j];
  }
#pragma GCC unroll 6
  for (int k = joints - 1; k > 0; --k)
#pragma GCC unroll 6
    for (int i = 0; i < k; ++i) a[i][joints] = a[i][joints] - a[i][k] * a[k][joints];
}

/// How far beyond Newton's step the next one should go, from the squared misses before and after a whole
/// step. Between two solutions at +-d from where they meet the miss is as x^2 - d^2, and a step leaves a
/// fourth of 1 - (d/x)^2 of it: so d is known. Nearly 1 where solutions are apart, 2 where they are one.
template <class T>
QVGEN_LANES T stretch(const T& miss, const T& before) {
  const T share = miss / before, zero = T{};
  const T square = 1 - 4 * root(share);
  const T d = square > 0 ? square : zero;
  const T sum = 1 + root(d);
  const T result = 2 * (1 + d) / (sum * sum);
  return share < 0.13 ? result : spread<T>(1);
}

/// One of Newton's steps, no joint further than 0.3 (of the arm's size). Returns the squared miss before it.
/// `before`: the same of the step before, if that was a whole step, or a very large number.
template <class T>
[[gnu::noinline]] T newton_step(const Chain& chain, const Goal& goal, T& before, JointLanes<T>& q) {
  constexpr double farthest = 0.3;
  Linear<T> linear;
  linearise(chain, goal, q, linear);
  solve_linear(linear.a);
  T largest{};
  for (int j = 0; j < joints; ++j) {
    const T size = chain.slides[j] ? T(magnitude_of(linear.a[j][joints]) / chain.size)
                                   : magnitude_of(linear.a[j][joints]);
    largest = size > largest ? size : largest;
  }
  const T wanted = stretch(linear.miss, before);
  const T scale = largest * wanted > farthest ? farthest / largest : wanted;
  constexpr double hardly = 1.01;
  before = scale < hardly ? linear.miss : spread<T>(1e300);
  for (int j = 0; j < joints; ++j) {
    T step = linear.a[j][joints] * scale;
    step = step == step ? step : T{};
    if (chain.slides[j]) {
      q.cosine[j] += step;
      continue;
    }
    const T cosine = q.cosine[j] - q.sine[j] * step, sine = q.sine[j] + q.cosine[j] * step;
    q.cosine[j] = cosine;
    q.sine[j] = sine;
    bring_to_length_one(q.cosine[j], q.sine[j]);
  }
  return linear.miss;
}

template <class T>
[[gnu::noinline]] T squared_miss(const Chain& chain, const Goal& goal, const JointLanes<T>& q) {
  Linear<T> linear;
  linearise(chain, goal, q, linear);
  return linear.miss;
}

/// Joints are a solution if they miss the pose by no more than this, squared.
inline constexpr double good_miss = 1e-26;

/// The joints that missed the pose by least so far.
template <class T>
struct Best {
  JointLanes<T> q;
  T miss = spread<T>(1e300);  ///< squared

  void offer(const JointLanes<T>& values, const T& offered) {
    const auto better = offered < miss;
    for (int j = 0; j < joints; ++j) {
      q.cosine[j] = better ? values.cosine[j] : q.cosine[j];
      q.sine[j] = better ? values.sine[j] : q.sine[j];
    }
    miss = better ? offered : miss;
  }
};

/// Newton's steps until the first `count` lanes are as good as they get. Returns the squared miss.
template <int width>
Lanes<width> steps_to(const Chain& chain, const Goal& goal, int count, JointLanes<Lanes<width>>& q) {
  using T = Lanes<width>;
  constexpr int most_steps = 9;
  constexpr double last = 1e-16;  // one step from here is the last, but where two solutions meet
  T before = spread<T>(1e300);
  Best<T> best{q};
  bool stuck[width] = {};
  const auto any_is_open = [&](const T& miss, double good) {
    bool open = false;
    for (int i = 0; i < count; ++i) open = open || (!(miss[i] <= good) && !stuck[i]);
    return open;
  };
  bool nearly = false;
  for (int step = 0; step < most_steps; ++step) {
    const T earlier = before;
    const T miss = newton_step(chain, goal, before, q);
    for (int i = 0; i < count; ++i) stuck[i] = stuck[i] || (step > 3 && !(miss[i] <= 0.25 * earlier[i]));
    nearly = nearly || !any_is_open(miss, last);
    if (!nearly) continue;
    best.offer(q, squared_miss(chain, goal, q));
    if (!any_is_open(best.miss, good_miss)) break;
  }
  if (!nearly) best.offer(q, squared_miss(chain, goal, q));
  q = best.q;
  return best.miss;
}

}  // namespace
}  // namespace qvgen::inverse::elimination
