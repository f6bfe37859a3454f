// SPDX-License-Identifier: MIT
#pragma once

#include "equations.h"

namespace qvgen::inverse::certified {

/// True if each box of a covering of all angles is shown to hold no solution, or lies in a region. At most
/// `most` boxes are looked at; `boxes` says how many.
bool is_covered(const Equations& equations, const Region* regions, int count, int most, int& boxes);

}  // namespace qvgen::inverse::certified
