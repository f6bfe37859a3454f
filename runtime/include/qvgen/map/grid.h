// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace qvgen::map {

/// The largest whole number whose square is not above another.
inline std::int64_t whole_root(std::int64_t square) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

/// A sphere, and cubes of an edge `resolution` in it, one of them at its centre; metres.
struct Sphere {
  std::array<double, 3> centre{};
  double radius = 0;
  double resolution = 0;
};

/// The cubes whose centres lie in the sphere, in one order: cell (i, j, k) is centred at centre + resolution
/// (i, j, k), k runs fastest. They are dealt into as many blocks of neighbours as every map has.
class Grid {
 public:
  static constexpr int blocks = 1000;

  explicit Grid(const Sphere& sphere) : sphere_(sphere) {
    // Whole numbers decide, so that rounding does not: a cell on the sphere is in it.
    const double ratio = sphere.radius / sphere.resolution;
    square_ = static_cast<std::int64_t>(ratio * ratio * (1 + 1e-9));
    half_ = whole_root(square_);
    for (std::int64_t i = -half_; i <= half_; ++i)
      for (std::int64_t j = -half_; j <= half_; ++j)
        first_.push_back(first_.back() +
                         static_cast<std::uint64_t>(std::max<std::int64_t>(2 * height(i, j) + 1, 0)));
  }

  [[nodiscard]] const Sphere& sphere() const { return sphere_; }
  /// i, j and k run from -half to half.
  [[nodiscard]] std::int64_t half() const { return half_; }
  [[nodiscard]] std::uint64_t cells() const { return first_.back(); }

  [[nodiscard]] std::array<std::int64_t, 3> cell(std::uint64_t index) const {
    const auto after = std::upper_bound(first_.begin(), first_.end(), index);
    const auto row = static_cast<std::int64_t>(after - first_.begin()) - 1;
    const std::int64_t i = row / (2 * half_ + 1) - half_, j = row % (2 * half_ + 1) - half_;
    const auto place = static_cast<std::int64_t>(index - first_[static_cast<std::size_t>(row)]);
    return {i, j, place - height(i, j)};
  }
  [[nodiscard]] std::array<double, 3> position(std::uint64_t index) const {
    const auto at = cell(index);
    std::array<double, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] = sphere_.centre[axis] + sphere_.resolution * static_cast<double>(at[axis]);
    return place;
  }
  /// The first cell of a block; of the block behind the last, how many cells there are.
  [[nodiscard]] std::uint64_t first_of(int block) const {
    const std::uint64_t whole = cells() / blocks, rest = cells() % blocks,
                        number = static_cast<unsigned>(block);
    return whole * number + rest * number / blocks;
  }

 private:
  /// Returns the height of a row: its cells' k are in [-height, height]; -1 if it has none.
  [[nodiscard]] std::int64_t height(std::int64_t i, std::int64_t j) const {
    const std::int64_t left = square_ - i * i - j * j;
    return left < 0 ? -1 : whole_root(left);
  }

  Sphere sphere_;
  std::int64_t square_ = 0, half_ = 0;
  std::vector<std::uint64_t> first_{0};
};

}  // namespace qvgen::map
