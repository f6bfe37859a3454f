// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace qvgen {

/// How far |q|² of a valid pose of doubles may be from 1.
inline constexpr double most_excess = 1e-6;

/// How far |q|² of a valid pose may be from 1: 1e-6 for double, so that quaternions typed in with six digits
/// or rounded to float pass, and a forgotten normalisation does not; for float 1e-4. What is off by more may
/// still have few digits: see `qvgen/orientation/decimals.h`.
template <class Scalar>
constexpr Scalar unit_tolerance() {
  return std::numeric_limits<Scalar>::digits > 30 ? Scalar(most_excess) : Scalar(1e-4);
}

}  // namespace qvgen
