// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/columns/signature.h"

/// Prints a function of C that is a list of assignments for all columns at once: `t = a * q[1];` is
///
///     t = a .* q(2, :);
///
/// Operators keep their order and grouping, and so every bit.
namespace qvgen::emit::octave {

using columns::Input;
using columns::Output;
using columns::Signature;

/// Lines of the body; nothing if the function has branches or loops, or calls others.
std::optional<std::vector<std::string>> straight_body(const blocks::Unit& unit, const Signature& signature);

/// A constant's value, arrays as columns.
std::string constant_text(const blocks::Unit& unit, const blocks::Expression& value);

/// A name that is no word of Octave's or MATLAB's.
std::string value_name(const std::string& name);

}  // namespace qvgen::emit::octave
