// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "equations.h"

namespace qvgen::inverse::certified {

/// True if each box of a covering of all angles is shown to hold no solution, or lies in a region. At most
/// `most` boxes are looked at; `boxes` says how many.
bool is_covered(const Equations& equations, const Region* regions, int count, int most, int& boxes);

/// Returns what of some boxes is left: no box of them is shown to hold no solution or lies in a region, and
/// those narrower than `narrowest` are not halved. Looks at `most` boxes at most, and counts them in `boxes`.
std::vector<Box> uncovered(const Equations& equations, const std::vector<Region>& regions,
                           const std::vector<Box>& start, double narrowest, long most, long& boxes);

/// All angles.
Box all_angles(int unknowns);

}  // namespace qvgen::inverse::certified
