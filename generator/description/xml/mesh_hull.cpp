// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "description/xml/mesh_vectors.h"

// Quickhull (Barber, Dobkin, Huhdanpaa 1996): a tetrahedron grows. Every face keeps the points in front of
// it. The farthest of them is taken in: the faces that it sees go, and it is joined to the edges around them.
// A point that rounding alone puts in front of a face counts as inside: faces of many points in one plane do
// not grow, and every point is taken in once at most.
namespace qvgen::description::xml {
namespace {

using Triangle = std::array<std::size_t, 3>;
using Edge = std::pair<std::size_t, std::size_t>;

double length(const Point& a) { return std::sqrt(dot(a, a)); }

struct HullFace {
  Triangle corners;
  Point normal;  ///< of length one, outwards
  std::vector<std::size_t> outside;
  bool is_gone = false;
};

class Hull {
 public:
  explicit Hull(const std::vector<Point>& points) : points_(points) {
    for (const Point& point : points)
      for (const double x : point) size_ = std::max(size_, std::abs(x));
    near_ = 32 * std::numeric_limits<double>::epsilon() * size_;
  }

  /// False if all points lie in a plane.
  bool grow() {
    const auto start = tetrahedron();
    if (!start) return false;
    begin(*start);
    for (std::size_t at = 0; at < faces_.size(); ++at)
      while (!faces_[at].is_gone && !faces_[at].outside.empty()) take_in(at);
    return true;
  }

  [[nodiscard]] std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    for (const HullFace& face : faces_)
      if (!face.is_gone) result.push_back(face.corners);
    return result;
  }

 private:
  [[nodiscard]] double height(const HullFace& face, std::size_t point) const {
    return dot(face.normal, minus(points_[point], points_[face.corners[0]]));
  }

  /// The point for which a measure is largest.
  template <class Measure>
  [[nodiscard]] std::size_t farthest(const Measure& measure) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
      if (measure(points_[i]) > measure(points_[best])) best = i;
    return best;
  }

  /// Four points far from each other.
  [[nodiscard]] std::optional<std::array<std::size_t, 4>> tetrahedron() const {
    if (points_.size() < 4) return std::nullopt;
    const std::size_t a = farthest([](const Point& p) { return p[0]; });
    const std::size_t b = farthest([&](const Point& p) { return length(minus(p, points_[a])); });
    const Point along = minus(points_[b], points_[a]);
    const auto beside = [&](const Point& p) { return length(cross(along, minus(p, points_[a]))); };
    const std::size_t c = farthest(beside);
    if (!(beside(points_[c]) > near_ * length(along))) return std::nullopt;
    const Point normal = cross(along, minus(points_[c], points_[a]));
    const auto off = [&](const Point& p) { return std::abs(dot(normal, minus(p, points_[a]))); };
    const std::size_t d = farthest(off);
    if (!(off(points_[d]) > near_ * length(normal))) return std::nullopt;
    const bool is_behind = dot(normal, minus(points_[d], points_[a])) < 0;
    return is_behind ? std::array{a, b, c, d} : std::array{a, c, b, d};
  }

  /// d is behind the triangle a, b, c.
  void begin(const std::array<std::size_t, 4>& corners) {
    const auto [a, b, c, d] = corners;
    std::vector<std::size_t> all(points_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    std::vector<std::size_t> added;
    for (const Triangle& triangle : {Triangle{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}})
      added.push_back(add(triangle));
    share(all, added);
  }

  std::size_t add(const Triangle& corners) {
    const Point normal = cross(minus(points_[corners[1]], points_[corners[0]]),
                               minus(points_[corners[2]], points_[corners[0]]));
    const double size = length(normal);
    const double scale = size > 0 ? 1 / size : 0;
    for (std::size_t i = 0; i < 3; ++i) face_of_[{corners.at(i), corners.at((i + 1) % 3)}] = faces_.size();
    faces_.push_back({corners, {scale * normal[0], scale * normal[1], scale * normal[2]}, {}});
    return faces_.size() - 1;
  }

  /// Gives each point to the first of the faces that it is in front of.
  void share(const std::vector<std::size_t>& points, const std::vector<std::size_t>& faces) {
    for (const std::size_t point : points)
      for (const std::size_t face : faces)
        if (height(faces_[face], point) > near_) {
          faces_[face].outside.push_back(point);
          break;
        }
  }

  void take_in(std::size_t from) {
    const auto& outside = faces_[from].outside;
    const std::size_t eye = *std::max_element(
        outside.begin(), outside.end(),
        [&](std::size_t p, std::size_t q) { return height(faces_[from], p) < height(faces_[from], q); });
    std::vector<std::size_t> seen{from}, orphans;
    std::vector<Edge> horizon;
    faces_[from].is_gone = true;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const Triangle corners = faces_[seen[k]].corners;
      orphans.insert(orphans.end(), faces_[seen[k]].outside.begin(), faces_[seen[k]].outside.end());
      faces_[seen[k]].outside.clear();
      for (std::size_t i = 0; i < 3; ++i) {
        const Edge edge{corners.at(i), corners.at((i + 1) % 3)};
        const std::size_t beyond = face_of_.at({edge.second, edge.first});
        if (faces_[beyond].is_gone) continue;
        if (height(faces_[beyond], eye) > near_) {
          faces_[beyond].is_gone = true;
          seen.push_back(beyond);
        } else {
          horizon.push_back(edge);
        }
      }
    }
    orphans.erase(std::remove(orphans.begin(), orphans.end(), eye), orphans.end());
    std::vector<std::size_t> added;
    // A face seen from beyond one of its edges only after that edge was met has gone since.
    for (const Edge& edge : horizon)
      if (!faces_[face_of_.at({edge.second, edge.first})].is_gone)
        added.push_back(add({edge.first, edge.second, eye}));
    share(orphans, added);
  }

  const std::vector<Point>& points_;
  double size_ = 0, near_ = 0;
  std::vector<HullFace> faces_;
  std::map<Edge, std::size_t> face_of_;  ///< which has this edge in this sense
};

}  // namespace

Mesh convex_hull(const Mesh& mesh) {
  Mesh result{mesh.points, {}, ""};
  Hull hull(result.points);
  if (hull.grow())
    result.triangles = hull.triangles();
  else
    result.problem = "its points lie in a plane";
  return result;
}

}  // namespace qvgen::description::xml
