// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <qvgen/inverse/nearest.h>
#include <qvgen/inverse/target.h>
#include <qvgen/sine_cosine.h>

/// Seeds as preferences: a joint that a pose leaves free takes the seed's value, an angle with its sine and
/// cosine.
namespace qvgen::inverse {

template <int dof>
Preference<dof> preference(const Eigen::Matrix<double, dof, 1>& seed) {
  Preference<dof> result;
  result.seeded = true;
  double sines[dof], cosines[dof];
  sines_and_cosines(seed.data(), sines, cosines, dof);
  for (int i = 0; i < dof; ++i) {
    result.angle[i] = without_turns(seed[i]);
    result.slide[i] = seed[i];
    result.choose(i, {cosines[i], sines[i]});
  }
  return result;
}

/// Joints of which one has another value.
template <int dof>
Eigen::Matrix<double, dof, 1> with_value(Eigen::Matrix<double, dof, 1> q, int joint, double value) {
  q[joint] = value;
  return q;
}

}  // namespace qvgen::inverse
