// SPDX-License-Identifier: MIT
// Curves of solutions at singular poses: which joints a marked row stands for.
#pragma once

#include "arms.h"

namespace qvgen::test {

/// True if joints that reach a pose stand in its set: as a row no farther off than `close`, as one that
/// rounding does not tell from them, as the row that a seed brings out of a marked continuum, or on a curve
/// of solutions that comes to a marked row.
bool is_covered(const Arm& arm, const inverse::elimination::Setup& setup,
                const inverse::elimination::Found& found, const Joints6& q, double close = 1e-3);

}  // namespace qvgen::test
