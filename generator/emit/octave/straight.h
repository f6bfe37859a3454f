// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/octave/signature.h"

/// Prints a function of C that is a list of assignments for all columns at once: `t = a * q[1];` is
///
///     t = a .* q(2, :);
///
/// Operators keep their order and grouping, and so every bit.
namespace qvgen::emit::octave {

/// Lines of the body; nothing if the function has branches or loops, or calls others.
std::optional<std::vector<std::string>> straight_body(const blocks::Unit& unit, const Signature& signature);

/// A constant's value, arrays as columns.
std::string constant_text(const blocks::Unit& unit, const blocks::Expression& value);

}  // namespace qvgen::emit::octave
