// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

// Deterministic sets of any size that are spread evenly.
namespace qvgen::map {

inline constexpr double turn = 6.283185307179586476925;

/// The i-th of `count` orientations, w x y z: a super-Fibonacci spiral (M. Alexa, Super-Fibonacci spirals:
/// fast, low-discrepancy sampling of SO(3), CVPR 2022). The pitches of its two circles are the root of two
/// and the positive root of x^4 = x + 4, as found there.
inline std::array<double, 4> even_orientation(std::size_t i, std::size_t count) {
  constexpr double first_pitch = 1.4142135623730950488, second_pitch = 1.533751168755204288118041;
  const double place = static_cast<double>(i) + 0.5;
  const double share = place / static_cast<double>(count);
  const double alpha = turn * place / first_pitch, beta = turn * place / second_pitch;
  const double inner = std::sqrt(share), outer = std::sqrt(1 - share);
  return {inner * std::sin(alpha), inner * std::cos(alpha), outer * std::sin(beta), outer * std::cos(beta)};
}

/// The i-th of `count` unit vectors: heights in equal steps, so that areas are equal, turned by the golden
/// angle.
inline std::array<double, 3> even_direction(std::size_t i, std::size_t count) {
  constexpr double golden = 1.6180339887498948482;
  const double height = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
  const double radius = std::sqrt(1 - height * height), angle = turn * static_cast<double>(i) / golden;
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

/// The i-th of `count` angles of a whole turn.
inline double even_angle(std::size_t i, std::size_t count) {
  return turn * static_cast<double>(i) / static_cast<double>(count);
}

/// The middle of the i-th of `count` equal pieces of a range.
inline double even_value(std::size_t i, std::size_t count, double lower, double upper) {
  return lower + (upper - lower) * ((static_cast<double>(i) + 0.5) / static_cast<double>(count));
}

}  // namespace qvgen::map
