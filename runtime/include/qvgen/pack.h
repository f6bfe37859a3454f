// SPDX-License-Identifier: MIT
#pragma once

// Four doubles side by side as the scalar of generated functions.

#include <qvgen/simd/eigen.h>
#include <qvgen/sine_cosine.h>

namespace qvgen {

/// Four doubles side by side: a scalar for the functions of generated robots, which then treat four
/// configurations in one call. Include the robot's ..._definitions.h, compile with -mavx2 -mfma or
/// -march=native:
///
///     arm::JointVector<qvgen::Pack> q, qd, qdd;                // q[i][k]: joint i of configuration k
///     const auto torque = arm::inverse_dynamics(q, qd, qdd);   // torque[i][k]
///
/// A lane has the value of the same call in double but for rounding. Functions with branches, Coulomb
/// friction among them, do not take packs.
using Pack = simd::Lanes<double, simd::Doubles<4>>;

namespace simd {

inline Pack sin(const Pack& a) { return Pack::load(sines_and_cosines<double>(a[0], a[1], a[2], a[3]).sine); }
inline Pack cos(const Pack& a) {
  return Pack::load(sines_and_cosines<double>(a[0], a[1], a[2], a[3]).cosine);
}

}  // namespace simd

/// One vector pass an angle gives both.
template <>
inline void sines_and_cosines<Pack>(const Pack* angles, Pack* sines, Pack* cosines, int count) {
  for (int i = 0; i < count; ++i) {
    const Pack angle = angles[i];
    const auto both = sines_and_cosines<double>(angle[0], angle[1], angle[2], angle[3]);
    sines[i] = Pack::load(both.sine);
    cosines[i] = Pack::load(both.cosine);
  }
}

}  // namespace qvgen
