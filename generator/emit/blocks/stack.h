// SPDX-License-Identifier: MIT
// Bytes of stack that C needs, computed from its text: a function's variables, arguments and registers, and
// the deepest chain of calls below it. Blocks call nothing by a pointer and nothing twice on one way, so a
// chain ends.
//
// The sum is a bound of what GCC takes: it gives each variable one place at most, and shares places in
// practice. What a compiler adds for values between two operations is counted for each operation with such a
// value.
#pragma once

#include <map>
#include <string>

#include "emit/blocks/unit.h"

namespace qvgen::emit::blocks {

/// Returns the stack of each function in bytes, with all that it calls but functions of <math.h>. A number
/// has `real_bytes`, a pointer 8. Throws NotInSubset if functions call each other in a circle.
std::map<std::string, int> stack_bytes(const Unit& unit, int real_bytes);

}  // namespace qvgen::emit::blocks
