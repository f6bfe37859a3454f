// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "canonical/placement.h"

namespace qvgen::canonical {

/// True if the angle of a constant rotation of the robot has symbols.
bool has_symbolic_turns(const model::Robot& robot);

/// The constant ways of a chain whose joint axes are all z: world to the first joint, joint to joint, last
/// joint to the tool.
std::vector<Placement> passages(const model::Robot& robot, Definitions& definitions);

/// The direction across z of a length vector if it is a known one: (x, y) of its coefficients.
std::optional<cln::cl_R> heading(const LengthVector& v);

}  // namespace qvgen::canonical
