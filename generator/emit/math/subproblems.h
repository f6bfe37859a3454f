// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "emit/math/describe.h"

namespace qvgen::emit {

/// The inverse kinematics of six turns with a spherical wrist as a sequence of the subproblems of Paden and
/// Kahan (runtime: qvgen/paden_kahan.h), where the first two axes meet or the second and third are parallel;
/// nothing for other arms.
std::vector<Passage> subproblem_passages(const derive::inverse::Derivation& derivation, Notation notation);

}  // namespace qvgen::emit
