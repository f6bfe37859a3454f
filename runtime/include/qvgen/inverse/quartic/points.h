// SPDX-License-Identifier: MIT
// Points that joint values carry, with derivatives, for arms with a quartic. Generated C has its own form of
// these, templates/c/headers/quartic/points.c.
#pragma once

#include <qvgen/inverse/joint_values.h>
#include <qvgen/inverse/least_squares.h>
#include <qvgen/inverse/point_matching.h>

namespace qvgen::inverse::quartic {

/// Sum of the squared distances between the points and their goals.
template <typename Scalar, std::size_t joints, std::size_t points>
Scalar miss(const PointMatching<Scalar, joints, points>& task, const JointValues<Scalar, joints>& values) {
  Scalar sum(0);
  for (std::size_t p = 0; p < points; ++p) {
    Triple<Scalar> x = task.start[p];
    for (std::size_t i = joints; i-- > 0;) x = moved(task.arm[i], values[i], x);
    const Triple<Scalar> off = difference(task.goal[p], x);
    sum += inverse::dot(off, off);
  }
  return sum;
}

/// Derivatives of the points' coordinates by each joint, and what these are off. Further rows stay as they
/// are.
template <typename Scalar, std::size_t joints, std::size_t points>
void add_points(const PointMatching<Scalar, joints, points>& task, const JointValues<Scalar, joints>& values,
                polishing::Columns<Scalar, joints, 3 * points + joints>& jacobian,
                polishing::Vector<Scalar, 3 * points + joints>& off) {
  for (std::size_t p = 0; p < points; ++p) {
    std::array<Triple<Scalar>, joints> columns;
    Triple<Scalar> x = task.start[p];
    for (std::size_t i = joints; i-- > 0;) {
      const Screw<Scalar>& screw = task.arm[i];
      x = moved(screw, values[i], x);
      columns[i] = screw.revolute ? cross(screw.axis, difference(x, screw.point)) : screw.axis;
      for (std::size_t k = i + 1; screw.revolute && k < joints; ++k)
        columns[k] = turned(screw, values[i], columns[k]);
    }
    const Triple<Scalar> miss = difference(task.goal[p], x);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < joints; ++i) jacobian[i][3 * p + k] = columns[i][k];
      off[3 * p + k] = miss[k];
    }
  }
}

}  // namespace qvgen::inverse::quartic
