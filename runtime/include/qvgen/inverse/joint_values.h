// SPDX-License-Identifier: MIT
// Values of joints as pairs, a turn's cosine and sine, a slide's length in the cosine's place: how far two
// are apart, and what lies between them. Generated C has these functions from this header
// (generator/emit/blocks/runtime).
#pragma once

#include <array>
#include <cstddef>

#include <qvgen/inverse/angles.h>
#include <qvgen/inverse/tolerances.h>

namespace qvgen::inverse {

template <typename Scalar, std::size_t joints>
using JointValues = std::array<Rotor<Scalar>, joints>;

/// Sum of the squares of what the values' pairs are apart: of short arcs' lengths and slides' ways.
template <typename Scalar, std::size_t joints>
Scalar distance_square(const JointValues<Scalar, joints>& a, const JointValues<Scalar, joints>& b) {
  Scalar sum(0);
  for (std::size_t i = 0; i < joints; ++i) {
    const Scalar x = a[i].cosine - b[i].cosine;
    const Scalar y = a[i].sine - b[i].sine;
    sum += x * x + y * y;
  }
  return sum;
}

/// True if two joint values are the same, to half the digits.
template <typename Scalar, std::size_t joints>
bool are_same(const JointValues<Scalar, joints>& a, const JointValues<Scalar, joints>& b) {
  return distance_square(a, b) < Scalar(tolerance::same_rows) * epsilon<Scalar>();
}

/// Returns the pairs at `tolerance::way_between` of the way from one joint value to another; they are a
/// little short.
template <typename Scalar, std::size_t joints>
JointValues<Scalar, joints> place_between(const JointValues<Scalar, joints>& a,
                                          const JointValues<Scalar, joints>& b) {
  const Scalar share(tolerance::way_between);
  JointValues<Scalar, joints> place = a;
  for (std::size_t i = 0; i < joints; ++i) {
    place[i].cosine = a[i].cosine + share * (b[i].cosine - a[i].cosine);
    place[i].sine = a[i].sine + share * (b[i].sine - a[i].sine);
  }
  return place;
}

/// True if a place between two joint values is nearer to each than they are to each other.
template <typename Scalar, std::size_t joints>
bool lies_between(const JointValues<Scalar, joints>& place, const JointValues<Scalar, joints>& a,
                  const JointValues<Scalar, joints>& b) {
  const Scalar most = Scalar(tolerance::between) * distance_square(a, b);
  return distance_square(a, place) < most && distance_square(b, place) < most;
}

}  // namespace qvgen::inverse
