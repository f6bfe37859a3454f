// SPDX-License-Identifier: MIT
// Continua of solutions in several pieces: each has to have a row.
#pragma once

#include <optional>

#include "pose_sets.h"

namespace qvgen::test {

/// True if in one direction, and no other, the sampled joints move without moving the tool, to first order.
bool is_on_a_curve(const Case& test, const Sample& sample);

/// True if the curve of joints that reach the pose, followed from the sampled ones until it closes or ends,
/// comes to a row. The tests' own steps: null vectors of the Jacobian, no more than 0.02 rad or m.
bool leads_to_a_row(const Case& test, const Found& found, const Sample& sample);

/// Joints at which a point of one joint's axis lies on the first or last joint's axis, so that this joint may
/// be free; nothing if the arm has no such joints of the i-th kind.
std::optional<Sample> point_on_an_end_axis(Case& test, int i);

}  // namespace qvgen::test
