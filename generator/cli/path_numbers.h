// SPDX-License-Identifier: MIT
// Numbers in options of paths: with or without a unit behind them, and ranges of them.
#pragma once

#include <string>
#include <utility>

namespace qvgen::cli {

/// Returns a number with an optional unit behind it, deg or mm, in rad or m; throws UsageError.
double number_of(const std::string& option, std::string text);

/// Splits NAME=REST; throws UsageError.
std::pair<std::string, std::string> named(const std::string& option, const std::string& text);

/// Reads LOWER:UPPER; a unit behind the upper one is stated once for both. Throws UsageError.
std::pair<double, double> range_of(const std::string& option, const std::string& range);

}  // namespace qvgen::cli
