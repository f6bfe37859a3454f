// SPDX-License-Identifier: MIT
// Loads that gravity puts on the joints of an arm: joints bend under them.
#pragma once

#include "calibrate/chain.h"

namespace qvgen::calibrate {

inline constexpr double standard_gravity = 9.80665;  ///< m/s^2, along the world's -z

/// Returns the torque of each joint by weights of one newton a kilogram, in the sense in which it sags;
/// nothing for an arm without bodies. Over either scalar.
template <class S>
std::vector<S> loads_of(const Geometry<S>& geometry, const Posture<S>& posture, const S& one) {
  const S zero = one - one;
  std::vector<S> loads(geometry.bodies.size(), zero);
  std::vector<Vec<S>> axes, points;
  Rigid<S> at = identity(one);
  for (std::size_t i = 0; i < geometry.bodies.size(); ++i) {
    const Vec<S>& axis = geometry.gaps[i].directions[2];
    at = at * geometry.gaps[i].way;
    axes.push_back(turned(at, axis));
    points.push_back(at.position);
    at = at * (geometry.joints[i].revolute
                   ? turn(axis, posture.circular[i].cosine, posture.circular[i].sine, one)
                   : shift(posture.values[i] * axis, one));
    const Vec<S> weight{zero, zero, -geometry.bodies[i].mass}, centre = at * geometry.bodies[i].centre;
    for (std::size_t k = 0; k <= i; ++k)
      if (geometry.joints[k].revolute) loads[k] = loads[k] + dot(axes[k], cross(centre - points[k], weight));
  }
  return loads;
}

/// Returns the greatest load of each joint (Nm) at many random postures; 0 below what rounding leaves.
std::vector<double> greatest_loads(const Geometry<double>& geometry);

}  // namespace qvgen::calibrate
