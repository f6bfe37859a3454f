// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "report/motion.h"

namespace qvgen::report {

using Point = std::array<double, 2>;

/// The direction from a picture to its reader by angles, rad; z is up. Without more said x is to the right
/// and towards the reader, y to the back, and the reader looks down a little.
struct Sight {
  double azimuth = -0.95;
  double elevation = 0.36;
};

/// A camera at infinity.
class View {
 public:
  explicit View(const Sight& sight = {});
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
