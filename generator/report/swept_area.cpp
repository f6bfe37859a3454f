// SPDX-License-Identifier: MIT
#include "report/swept_area.h"

#include <algorithm>
#include <cmath>

namespace qvgen::report {
namespace {

using Point = std::array<double, 2>;
constexpr int cells = 1000;

double side(const Point& a, const Point& b, double x, double y) {
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

/// Cells count if their middle is covered: what is too much here is missing there.
class Raster {
 public:
  explicit Raster(const std::vector<Point>& points) : filled_(static_cast<std::size_t>(cells) * cells) {
    low_ = high_ = points.front();
    for (const Point& p : points)
      for (std::size_t k = 0; k < 2; ++k) {
        low_[k] = std::min(low_[k], p[k]);
        high_[k] = std::max(high_[k], p[k]);
      }
  }
  void fill(Point a, Point b, Point c) {
    for (Point* p : {&a, &b, &c})
      for (std::size_t k = 0; k < 2; ++k)
        (*p)[k] = high_[k] > low_[k] ? ((*p)[k] - low_[k]) / (high_[k] - low_[k]) * cells : 0;
    const auto [left, right] = std::minmax({a[0], b[0], c[0]});
    const auto [bottom, top] = std::minmax({a[1], b[1], c[1]});
    for (int i = std::max(0, static_cast<int>(left)); i <= std::min(cells - 1, static_cast<int>(right)); ++i)
      for (int j = std::max(0, static_cast<int>(bottom)); j <= std::min(cells - 1, static_cast<int>(top));
           ++j)
        if (covers(a, b, c, i + 0.5, j + 0.5))
          filled_[static_cast<std::size_t>(i) * cells + static_cast<std::size_t>(j)] = true;
  }
  [[nodiscard]] double area() const {
    const auto count = static_cast<double>(std::count(filled_.begin(), filled_.end(), true));
    return count / cells / cells * (high_[0] - low_[0]) * (high_[1] - low_[1]);
  }

 private:
  static bool covers(const Point& a, const Point& b, const Point& c, double x, double y) {
    const double s = side(a, b, x, y), t = side(b, c, x, y), u = side(c, a, x, y);
    return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
  }
  Point low_{}, high_{};
  std::vector<bool> filled_;
};

}  // namespace

double swept_area(const GridImage& image) {
  Raster raster(image.points);
  const auto at = [&](std::size_t i, std::size_t j) { return image.points[i * image.columns + j]; };
  for (std::size_t i = 0; i + 1 < image.rows; ++i)
    for (std::size_t j = 0; j + 1 < image.columns; ++j) {
      raster.fill(at(i, j), at(i + 1, j), at(i, j + 1));
      raster.fill(at(i + 1, j + 1), at(i + 1, j), at(i, j + 1));
    }
  return raster.area();
}

}  // namespace qvgen::report
