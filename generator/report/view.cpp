// SPDX-License-Identifier: MIT
#include "report/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qvgen::report {

View::View(const Sight& sight) {
  const auto [azimuth, elevation] = sight;
  right_ = {-std::sin(azimuth), std::cos(azimuth), 0};
  toward_ = {std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation),
             std::sin(elevation)};
  up_ = toward_.cross(right_);
}

std::vector<Point> hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  const auto turns_left = [](const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
  };
  std::vector<Point> chain;
  const auto half = [&](auto begin, auto end, std::size_t kept) {
    for (auto point = begin; point != end; ++point) {
      while (chain.size() > kept + 1 && !turns_left(chain[chain.size() - 2], chain.back(), *point))
        chain.pop_back();
      chain.push_back(*point);
    }
  };
  half(points.begin(), points.end(), 0);
  half(points.rbegin() + 1, points.rend(), chain.size() - 1);
  chain.pop_back();
  return chain;
}

std::vector<Vector> prism(const Vector& centre, const Vector& axis, double radius, double half_height,
                          int corners) {
  const Vector x = normal_to(axis);
  const Vector y = axis.cross(x);
  std::vector<Vector> points;
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < corners; ++i) {
      const double angle = (2 * i + 1) * std::numbers::pi / corners;
      points.push_back(centre + (side * half_height) * axis + (radius * std::cos(angle)) * x +
                       (radius * std::sin(angle)) * y);
    }
  return points;
}

}  // namespace qvgen::report
