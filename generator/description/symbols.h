// SPDX-License-Identifier: MIT
#pragma once

#include "description/document.h"

namespace qvgen::description {

/// Checks all names of a chain that has been read against each other, and fills in the robot's parameters
/// with their defaults: symbols of the geometry in the order of the text, those of inertia alone joint by
/// joint.
void resolve_symbols(const Table& root, model::Robot& robot);

/// Denominators and roots that have no value at the defaults.
void check_default_values(Context& context, const model::Robot& robot);

}  // namespace qvgen::description
