// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "map/part.h"

namespace qvgen::map {

/// One number of each cell.
struct Quantity {
  std::string name;   ///< in files: letters and underscores
  std::string label;  ///< for people
  float (*of)(const Cell& cell, double targets);
};

/// All that a map has: share, mean_solutions, most_solutions, manipulability, and limit_distance where a
/// joint has limits.
std::vector<Quantity> quantities_of(const About& about);

/// A whole map as a cube of cells, (2 half + 1)^3 of them, k running fastest. Outside the sphere nothing is
/// reached; it is not known there if the sphere was not the arm's own.
class Cube {
 public:
  explicit Cube(const Part& part);
  [[nodiscard]] std::int64_t half() const { return grid_.half(); }
  [[nodiscard]] std::size_t edge() const { return static_cast<std::size_t>(2 * half() + 1); }
  /// Null outside the sphere.
  [[nodiscard]] const Cell* at(std::int64_t i, std::int64_t j, std::int64_t k) const;
  [[nodiscard]] float value(const Quantity& quantity, std::int64_t i, std::int64_t j, std::int64_t k) const;
  /// The place of a layer along x, y or z (m).
  [[nodiscard]] double place(std::size_t axis, std::int64_t index) const;

 private:
  const Part& part_;
  Grid grid_;
  std::vector<const Cell*> cells_;
};

/// Whole files.
std::string npz_text(const Part& part);
std::string vtk_text(const Part& part);
/// The planes x, y and z through the centre, a row of them for each quantity.
std::string svg_text(const Part& part);

}  // namespace qvgen::map
