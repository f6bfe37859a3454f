// SPDX-License-Identifier: MIT
// Functions of thousands of values, as humanoids have them, in half as many bytes: numbers that come back
// have names, names are short, no spaces stand between operators, one declaration has many values, and zeros
// are set at once. What is computed stays the same, bit for bit. Example: `const Scalar t800 = t7 *
// Scalar(0.5);` becomes `w4=t7*n3` in a list.
#pragma once

#include "emit/code.h"

namespace qvgen::emit {

/// True if code has so many values that bytes count, as no arm's function has.
bool has_many_values(const Code& code);

/// Returns code of C++ in fewer bytes. `temporaries` are declarations that go on behind a comma.
Code compact(const Code& code);

/// Returns the statements that assign values of compact code to `result`, several a line.
std::vector<std::string> compact_statements(const std::vector<Assignment>& assignments);

}  // namespace qvgen::emit
