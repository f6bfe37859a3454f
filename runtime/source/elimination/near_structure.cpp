// SPDX-License-Identifier: MIT
#include "near_structure.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace qvgen::inverse::elimination {
namespace {

using Eigen::Vector3d;

struct Axis {
  Vector3d direction, point;
};

Axis axis_of(const Screw<double>& screw) {
  return {Vector3d(screw.axis[0], screw.axis[1], screw.axis[2]).normalized(),
          Vector3d(screw.point[0], screw.point[1], screw.point[2])};
}

double sine_between(const Axis& a, const Axis& b) { return a.direction.cross(b.direction).norm(); }

double distance(const Axis& a, const Axis& b) {
  const Vector3d normal = a.direction.cross(b.direction).normalized();
  return std::abs(normal.dot(b.point - a.point));
}

/// Returns the place on axis b, from its point on, that is nearest to axis a; they are not parallel.
double place_on(const Axis& b, const Axis& a) {
  const Vector3d normal = a.direction.cross(b.direction);
  return (a.point - b.point).cross(a.direction).dot(-normal) / normal.squaredNorm();
}

/// How far three axes are from being parallel, as sines, or from meeting in one point, in sizes; infinite if
/// neighbours are parallel and others not.
double off_structure(const Axis& a, const Axis& b, const Axis& c, double size) {
  constexpr double parallel = 1e-3;
  const double first = sine_between(a, b), second = sine_between(b, c);
  if (first < parallel && second < parallel) return std::max(first, second);
  if (first < parallel || second < parallel) return INFINITY;
  const double gap = std::abs(place_on(b, a) - place_on(b, c));
  return std::max({distance(a, b), distance(b, c), gap}) / size;
}

}  // namespace

bool nearly_has_structure(const Description& arm, double size) {
  constexpr double rounding = 1e-12, meant = 3e-5;
  for (int k = 0; k + 2 < joints; ++k) {
    const auto* axes = arm.axes + k;
    if (!axes[0].revolute || !axes[1].revolute || !axes[2].revolute) continue;
    const double off = off_structure(axis_of(axes[0]), axis_of(axes[1]), axis_of(axes[2]), size);
    if (off > rounding && off < meant) return true;
  }
  return false;
}

}  // namespace qvgen::inverse::elimination
