// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace reference {

using Values = std::map<std::string, double>;

/// Value of an expression of a robot description in double: numbers, names, + - * / ^ **, parentheses, sqrt,
/// sin, cos, pi; `deg` and `rad` belong to the whole term before them. Throws std::runtime_error for anything
/// else and for names without a value.
double evaluate(const std::string& text, const Values& values);

/// Functions by name, for texts that are no descriptions; they take what stands between their commas.
using Functions = std::map<std::string, std::function<double(const std::vector<double>&)>>;
double evaluate(const std::string& text, const Values& values, const Functions& functions);

}  // namespace reference
