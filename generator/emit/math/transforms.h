// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/math/notation.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The homogeneous transform of the tool in matrix form, as lines: first each factor, world to base, link by
/// link, last link to tool (those that are not 1), then the entries of their product with parallel neighbours
/// merged. Every factor and the product are certified against the pairs. The product is left out where a
/// constant rotation is by a symbolic angle.
std::vector<std::string> transform_lines(const model::Robot& described, Notation notation);

}  // namespace qvgen::emit
