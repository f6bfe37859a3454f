// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "report/motion.h"

namespace qvgen::report {

using Point = std::array<double, 2>;

/// A camera at infinity that looks down a little; z is up.
class View {
 public:
  View();
  [[nodiscard]] Point project(const Vector& v) const { return {right_.dot(v), -up_.dot(v)}; }
  /// How near to the camera.
  [[nodiscard]] double depth(const Vector& v) const { return toward_.dot(v); }
  [[nodiscard]] const Vector& toward() const { return toward_; }

 private:
  Vector right_, up_, toward_;
};

/// Corners of a polygon around points, in order.
std::vector<Point> hull(std::vector<Point> points);

/// Corners of a regular prism on an axis: the two ends one after the other, `corners` each.
std::vector<Vector> prism(const Vector& centre, const Vector& axis, double radius, double half_height,
                          int corners);

}  // namespace qvgen::report
