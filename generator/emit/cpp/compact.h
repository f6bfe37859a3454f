// SPDX-License-Identifier: MIT
// Functions of thousands of values, as humanoids have them, in a third fewer bytes: numbers that come back
// have names, and one declaration has many values. What is computed stays the same, bit for bit.
#pragma once

#include "emit/code.h"

namespace qvgen::emit {

/// Returns code of C++ in fewer bytes if it has so many values that bytes count; else as it is, a line for
/// each value. `temporaries` are then declarations that go on behind a comma.
Code compact(const Code& code);

}  // namespace qvgen::emit
