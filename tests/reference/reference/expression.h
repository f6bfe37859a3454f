// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace reference {

using Values = std::map<std::string, double>;

/// Value of an expression of a robot description in double: numbers, names, + - * / ^ **, parentheses, sqrt,
/// sin, cos, pi; `deg` and `rad` belong to the whole term before them. Throws std::runtime_error for anything
/// else and for names without a value.
double evaluate(const std::string& text, const Values& values);

}  // namespace reference
