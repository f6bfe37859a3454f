// SPDX-License-Identifier: MIT
#include "calibrate/exact_rank.h"

#include <algorithm>

#include "calibrate/observe.h"
#include "calibrate/touching.h"

namespace qvgen::calibrate {
namespace {

using Matrix = std::vector<Row<Field>>;

Vec<Field> random_vector(const passes::search_detail::Fingerprint& point, const std::string& name) {
  return {point.symbol(name + "x"), point.symbol(name + "y"), point.symbol(name + "z")};
}

/// Returns frames in general position. The tracker's does not matter, for it only turns rows into one
/// another.
Frames<Field> random_frames(const Setup& setup) {
  const passes::search_detail::Fingerprint point(2);
  const Field one = Field::from(1);
  Frames<Field> frames{identity(one), {}};
  for (std::size_t i = 0; i < setup.targets; ++i)
    frames.targets.push_back(
        setup.target_known ? identity(one) : shift(random_vector(point, "target" + std::to_string(i)), one));
  return frames;
}

Surface<Field> random_surface(std::size_t object) {
  const passes::search_detail::Fingerprint point(3);
  const std::string name = std::to_string(object);
  Surface<Field> surface;
  surface.normal = random_vector(point, "normal" + name);
  surface.first = cross(surface.normal, random_vector(point, "first" + name));
  surface.second = cross(surface.normal, surface.first);
  surface.offset = point.symbol("offset" + name);
  surface.point = random_vector(point, "point" + name);
  surface.radius = point.symbol("radius" + name);
  return surface;
}

/// Returns the rows of measurements at random postures, with the columns in the order of priority.
Matrix random_rows(const Model<Field>& model, const Setup& setup, const std::vector<std::size_t>& priority) {
  const Frames<Field> frames = random_frames(setup);
  const std::size_t enough = priority.size() + 12 * (setup.targets + setup.surfaces);
  Matrix matrix;
  for (std::uint64_t i = 0; matrix.size() < enough && i < 4 * enough; ++i) {
    const std::size_t target = i % setup.targets;
    const std::size_t object = setup.surfaces > 0 ? i / setup.targets % setup.surfaces : 0;
    const Surface<Field> surface = random_surface(object);
    const auto posture = touching_posture(model, setup.data, frames, target, surface, 100 + i);
    if (!posture) continue;
    const Prediction<Field> prediction = predict(model, *posture, frames, target);
    for (const Row<Field>& row :
         rows_of(model.parameters, setup.data, prediction, surface, object, Field::from(1))) {
      matrix.emplace_back();
      for (const std::size_t index : priority) matrix.back().push_back(row[index]);
    }
  }
  return matrix;
}

/// Makes the pivot's column zero but for its row, whose entry becomes 1.
void eliminate(Matrix& matrix, std::size_t row, std::size_t column) {
  const Field scale = matrix[row][column].inverse();
  for (std::size_t j = column; j < matrix[row].size(); ++j) matrix[row][j] = scale * matrix[row][j];
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    const Field factor = matrix[i][column];
    if (i == row || factor.is_zero()) continue;
    for (std::size_t j = column; j < matrix[i].size(); ++j)
      matrix[i][j] = matrix[i][j] - factor * matrix[row][j];
  }
}

}  // namespace

Rank exact_rank(const Model<Field>& model, const Setup& setup, const std::vector<std::size_t>& priority) {
  Matrix matrix = random_rows(model, setup, priority);
  Rank rank;
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < priority.size(); ++column) {
    const auto begin = matrix.begin() + static_cast<std::ptrdiff_t>(std::min(pivots.size(), matrix.size()));
    const auto found =
        std::find_if(begin, matrix.end(), [&](const Row<Field>& row) { return !row[column].is_zero(); });
    if (found != matrix.end()) {
      std::swap(*begin, *found);
      eliminate(matrix, pivots.size(), column);
      pivots.push_back(column);
      rank.independent.push_back(priority[column]);
      continue;
    }
    Dependence dependence{priority[column], {}};
    for (std::size_t i = 0; i < pivots.size(); ++i)
      if (!matrix[i][column].is_zero()) dependence.on.push_back(priority[pivots[i]]);
    rank.dependent.push_back(std::move(dependence));
  }
  std::sort(rank.independent.begin(), rank.independent.end());
  return rank;
}

}  // namespace qvgen::calibrate
