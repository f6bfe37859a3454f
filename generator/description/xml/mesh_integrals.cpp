// SPDX-License-Identifier: MIT
#include <cmath>

#include "description/xml/mesh_vectors.h"

// Every triangle is the base of a pyramid whose top is inside: first at the centroid of the surface, to find
// the centre, then at that centre. MuJoCo does so too, and where the volumes are taken as positive it
// matters.
namespace qvgen::description::xml {
namespace {

using Corners = std::array<Point, 3>;

Corners corners(const Mesh& mesh, std::size_t triangle, const Point& from) {
  const auto& t = mesh.triangles[triangle];
  return {minus(mesh.points[t[0]], from), minus(mesh.points[t[1]], from), minus(mesh.points[t[2]], from)};
}

/// Twice the area, along the normal.
Point normal(const Corners& c) { return cross(minus(c[1], c[0]), minus(c[2], c[0])); }
double area(const Corners& c) { return std::sqrt(dot(normal(c), normal(c))) / 2; }
Point middle(const Corners& c) {
  Point sum{};
  for (std::size_t i = 0; i < 3; ++i) sum.at(i) = (c[0].at(i) + c[1].at(i) + c[2].at(i)) / 3;
  return sum;
}

/// Returns the weight of one triangle: the volume of its pyramid over the origin, or its area.
double weight(const Corners& c, MeshInertia inertia) {
  if (inertia == MeshInertia::shell) return area(c);
  const double volume = dot(middle(c), normal(c)) / 6;
  return inertia == MeshInertia::legacy ? std::abs(volume) : volume;
}

/// The sum of weighted points over the sum of weights; the origin where that is nothing.
struct Mean {
  double weight = 0;
  Point sum{};
  void add(double w, const Point& point, double share) {
    weight += w;
    for (std::size_t i = 0; i < 3; ++i) sum.at(i) += w * share * point.at(i);
  }
  [[nodiscard]] Point value(const Point& from) const {
    Point result = from;
    for (std::size_t i = 0; i < 3; ++i) result.at(i) += weight > 0 ? sum.at(i) / weight : 0;
    return result;
  }
};

Point centroid_of_surface(const Mesh& mesh) {
  Mean mean;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners c = corners(mesh, i, {});
    mean.add(area(c), middle(c), 1);
  }
  return mean.value({});
}

Point centre(const Mesh& mesh, MeshInertia inertia) {
  const Point inside = centroid_of_surface(mesh);
  if (inertia == MeshInertia::shell) return inside;
  Mean mean;  // the centre of a pyramid is at 3/4 of the way from its top to the middle of its base
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners c = corners(mesh, i, inside);
    mean.add(weight(c, inertia), middle(c), 0.75);
  }
  return mean.value(inside);
}

/// Integral of x_i x_j over the triangle or pyramid, divided by its measure and by `parts`.
double product(const Corners& c, std::size_t i, std::size_t j) {
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) sum += (a == b ? 2 : 1) * c.at(a).at(i) * c.at(b).at(j);
  return sum;
}

}  // namespace

MeshIntegrals integrals(const Mesh& mesh, MeshInertia inertia) {
  MeshIntegrals result;
  result.centre = centre(mesh, inertia);
  const double parts = inertia == MeshInertia::shell ? 12 : 20;
  std::array<Point, 3> products{};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners(mesh, t, result.centre);
    const double w = weight(c, inertia);
    result.volume += w;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) products.at(i).at(j) += w / parts * product(c, i, j);
  }
  const double trace = products[0][0] + products[1][1] + products[2][2];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result.inertia.at(i).at(j) = (i == j ? trace : 0) - products.at(i).at(j);
  return result;
}

}  // namespace qvgen::description::xml
