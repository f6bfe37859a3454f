// SPDX-License-Identifier: MIT
#include "canonical/right_matrix.h"

#include <algorithm>

#include "model/evaluate.h"

namespace qvgen::canonical {

Right product(const Right& a, const Right& b) {
  Right result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}

IntVector applied(const Right& r, const IntVector& v) {
  IntVector result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] += r[i][j] * v[j];
  return result;
}

Right turned(const IntVector& axis, int quarters) {
  Right quarter{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    quarter[i][i] = axis[i] * axis[i];
    quarter[k][j] = axis[i];
    quarter[j][k] = -axis[i];
  }
  Right result = unturned;
  for (int n = 0; n < quarters; ++n) result = product(result, quarter);
  return result;
}

std::optional<Right> to_right(const Rotation& rotation) {
  if (!is_right_angled(rotation)) return std::nullopt;
  Right result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = static_cast<int>(model::to_double(rotation[i][j]));
  return result;
}

Rotation to_rotation(const Right& right) {
  Rotation result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = right[i][j];
  return result;
}

std::size_t direction_of(const IntVector& axis) {
  return static_cast<std::size_t>(std::find_if(axis.begin(), axis.end(), [](int x) { return x != 0; }) -
                                  axis.begin());
}

int sense_of(const IntVector& axis) { return axis[direction_of(axis)]; }

}  // namespace qvgen::canonical
