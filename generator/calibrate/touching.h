// SPDX-License-Identifier: MIT
// Random exact postures in which the target lies on a surface. With the others at random values, the
// surface's equation is linear in cosine and sine of one joint, so that joint has a value in the field for
// every second choice.
#pragma once

#include <optional>

#include "calibrate/observe.h"

namespace qvgen::calibrate {

/// Returns a random posture; for planes and spheres one that touches. Nothing if this seed has none.
std::optional<Posture<Field>> touching_posture(const Model<Field>& model, Data data,
                                               const Frames<Field>& frames, std::size_t target,
                                               const Surface<Field>& surface, std::uint64_t seed);

}  // namespace qvgen::calibrate
