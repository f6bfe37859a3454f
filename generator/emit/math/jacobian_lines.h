// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/math/notation.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The Jacobian by the lecture's three methods for people: velocities link by link, axes and points,
/// derivatives; the matrix in which all of them end, its determinant and, of up to three rows, its inverse.
/// Text or LaTeX.
std::vector<std::string> jacobian_lines(const model::Robot& described, Notation notation);

}  // namespace qvgen::emit
