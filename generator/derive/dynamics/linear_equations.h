// SPDX-License-Identifier: MIT
// Linear equations with a symmetric matrix of scalars that are still to be computed.
#pragma once

#include <vector>

#include "derive/dynamics/scalar.h"

namespace qvgen::derive::dynamics {

using SquareMatrix = std::vector<std::vector<Scalar>>;

/// Returns x with m x = b for a symmetric m, eliminated from the last unknown to the first; zeros of m cost
/// nothing. Throws MasslessLink where a pivot is zero.
std::vector<Scalar> solved(SquareMatrix m, std::vector<Scalar> b, const Scalar& one);

}  // namespace qvgen::derive::dynamics
