// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "emit/code.h"

/// Values that templates are filled with.
namespace qvgen::emit {

/// A line an entry: line.
nlohmann::json lines_of(const std::vector<std::string>& lines);

/// The lines of a text that may end with one.
std::vector<std::string> split_lines(const std::string& text);

/// A value an entry: name, expression, last.
nlohmann::json values_of(const std::vector<Code::Value>& values);

/// Straight code: `temporaries` and `outputs`, and both one behind the other as `declarations`, for places
/// where outputs are constants like the others.
nlohmann::json values_of(const Code& code);
nlohmann::json values_of(const ast::Straight& code, const ast::Printer& language);

}  // namespace qvgen::emit
