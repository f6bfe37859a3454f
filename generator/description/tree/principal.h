// SPDX-License-Identifier: MIT
#pragma once

#include "description/tree/rigid.h"

namespace qvgen::description::tree {

/// A symmetric matrix as axes * diagonal * axes^T; the axes are columns. Jacobi's rotations, to
/// `evaluation_digits`.
struct Principal {
  Vector moments;
  Matrix axes;
};
Principal principal(const Matrix& symmetric);
Matrix tensor(const Principal& principal);

}  // namespace qvgen::description::tree
