// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verify/inverse/definition.h"

/// Poses that are compared but for their heading: by position and inclination, the direction of a joint's
/// axis as the tool sees it. `Arm` has poses by joint values, in sixty digits.
namespace qvgen::verify {

/// Returns the direction of a joint's axis, of any length, as the tool sees it at those joints.
template <class Arm>
Vector axis_seen_by_tool(const Arm& arm, const std::vector<Real>& q, int joint) {
  std::vector<Real> turned = q;
  turned[static_cast<std::size_t>(joint)] = turned[static_cast<std::size_t>(joint)] + Real(1);
  // conj(after) before: minus the turn about the axis, in the tool's frame, which it leaves where it is.
  const Quaternion turn = product(conjugate(arm.pose(q).q), arm.pose(turned).q);
  return {turn[1], turn[2], turn[3]};
}

/// Returns how far the tool at joints `a` is from another's position, as a share of a size, and inclination.
template <class Arm>
double difference_but_heading(const Arm& arm, const std::vector<Real>& a, const std::vector<Real>& b,
                              int joint, double size = 1) {
  const Pair at = arm.pose(a), other = arm.pose(b);
  const Vector seen = axis_seen_by_tool(arm, a, joint), by_other = axis_seen_by_tool(arm, b, joint);
  // A quaternion's sign means nothing.
  const Real with = seen[0] * by_other[0] + seen[1] * by_other[1] + seen[2] * by_other[2];
  const Real sign = with.to_double() < 0 ? Real(-1) : Real(1);
  Real worst(0);
  for (std::size_t i = 0; i < 3; ++i)
    for (const Real& gap : {abs(at.p[i] - other.p[i]) / Real(size), abs(seen[i] - sign * by_other[i])})
      worst = gap > worst ? gap : worst;
  return worst.to_double();
}

}  // namespace qvgen::verify
