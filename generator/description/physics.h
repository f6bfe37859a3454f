// SPDX-License-Identifier: MIT
#pragma once

#include "description/context.h"

namespace qvgen::description {

/// Warns of masses and inertia tensors that no body can have; symbols count with their default values, and a
/// link with a symbol that has none is not judged.
void check_inertia(Context& context, const model::Robot& robot);

/// Warns of an arm of hundreds of metres, whose lengths are in millimetres, most likely.
void check_size(Context& context, const model::Robot& robot);

}  // namespace qvgen::description
