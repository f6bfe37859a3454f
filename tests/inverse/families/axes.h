// SPDX-License-Identifier: MIT
#pragma once

// Axes of random arms: unit vectors with rational components, so that what follows from them is exact. The
// first six lie along coordinates, the others are oblique.
#include <array>

namespace qvgen::test {

using Axis = std::array<int, 4>;  ///< x, y, z over a denominator: a unit vector

inline constexpr std::array<Axis, 14> unit_axes{{{1, 0, 0, 1},
                                                 {0, 1, 0, 1},
                                                 {0, 0, 1, 1},
                                                 {-1, 0, 0, 1},
                                                 {0, -1, 0, 1},
                                                 {0, 0, -1, 1},
                                                 {3, 0, 4, 5},
                                                 {0, -5, 12, 13},
                                                 {8, 15, 0, 17},
                                                 {2, -3, 6, 7},
                                                 {-1, 2, 2, 3},
                                                 {4, 4, -7, 9},
                                                 {6, 2, 3, 7},
                                                 {-4, 3, 0, 5}}};
inline constexpr int along_coordinates = 6;  ///< how many of them are not oblique

inline bool parallel(const Axis& a, const Axis& b) {
  return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

inline bool is_across(const Axis& a, const Axis& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] == 0; }

}  // namespace qvgen::test
