// SPDX-License-Identifier: MIT
// How large a mechanism is: gaps of its loops count as shares of this.
#pragma once

#include "derive/loops/assembly_plan.h"

namespace qvgen::derive::loops {

/// Returns the square of a length of the mechanism's size, in the geometry and the lengths of given slides.
GiNaC::ex size_square(const AssemblyPlan& assembly);

}  // namespace qvgen::derive::loops
