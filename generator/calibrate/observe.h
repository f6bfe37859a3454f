// SPDX-License-Identifier: MIT
// Derivatives of what is measured by all parameters, from those of the pose; over either scalar.
#pragma once

#include "calibrate/setup.h"

namespace qvgen::calibrate {

/// A plane (normal, offset) or a sphere (point, radius), or the fixed end of a distance (point).
template <class S>
struct Surface {
  Vec<S> normal{}, first{},
      second{};  ///< the plane's unit normal, and what perpendicular to it the tilts are about
  S offset{};
  Vec<S> point{};
  S radius{};
};

template <class S>
using Row = std::vector<S>;

/// Returns the pose as the instrument reports it: the target in the tracker's frame, or the board in the
/// camera's.
template <class S>
Prediction<S> seen_by_camera(const Prediction<S>& prediction) {
  Prediction<S> seen{inverse(prediction.pose), prediction.columns};
  for (Column<S>& column : seen.columns) {
    const Vec<S> swung = cross(column.angular, prediction.pose.position) - column.linear;
    const Vec<S> back = turned_back(prediction.pose, column.angular);
    column = {turned_back(prediction.pose, swung), {-back[0], -back[1], -back[2]}};
  }
  return seen;
}

/// Appends the derivatives of a vector that is measured: three rows.
template <class S, class Part>
void append_vector(const Prediction<S>& prediction, Part part, std::vector<Row<S>>& rows) {
  for (std::size_t i = 0; i < 3; ++i) {
    Row<S> row;
    for (const Column<S>& column : prediction.columns) row.push_back(part(column)[i]);
    rows.push_back(std::move(row));
  }
}

/// Returns the derivative of a surface's own number of this index.
template <class S>
S by_surface(Data data, const Surface<S>& surface, std::size_t index, const Vec<S>& at, const S& one) {
  if (data == Data::plane)
    return index == 2 ? -one : dot(index == 0 ? surface.first : surface.second, cross(surface.normal, at));
  if (index == 3) return -surface.radius;
  return surface.point[index] - at[index];
}

/// Returns the derivative of a scalar that is measured: n.p - d, or (p - c)^2 / 2 - r^2 / 2.
template <class S>
Row<S> scalar_row(const std::vector<Parameter>& parameters, Data data, const Prediction<S>& prediction,
                  const Surface<S>& surface, std::size_t object, const S& one) {
  const Vec<S> at = prediction.pose.position;
  const Vec<S> along = data == Data::plane ? surface.normal : at - surface.point;
  Row<S> row;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool own = parameters[i].kind == Kind::surface && parameters[i].object == object;
    row.push_back(own ? by_surface(data, surface, parameters[i].direction, at, one)
                      : dot(along, prediction.columns[i].linear));
  }
  return row;
}

/// Returns the rows of one measurement: six of a pose, linear first, three of a position, one of a surface.
template <class S>
std::vector<Row<S>> rows_of(const std::vector<Parameter>& parameters, Data data,
                            const Prediction<S>& prediction, const Surface<S>& surface, std::size_t object,
                            const S& one) {
  std::vector<Row<S>> rows;
  if (data == Data::distance || data == Data::plane || data == Data::sphere)
    return {scalar_row(parameters, data, prediction, surface, object, one)};
  const Prediction<S> seen = data == Data::camera ? seen_by_camera(prediction) : prediction;
  append_vector(
      seen, [](const Column<S>& column) { return column.linear; }, rows);
  if (data != Data::position)
    append_vector(
        seen, [](const Column<S>& column) { return column.angular; }, rows);
  return rows;
}

}  // namespace qvgen::calibrate
