// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "emit/cpp/code.h"

/// What templates are filled with.
namespace qvgen::emit {

/// A line an entry: line.
nlohmann::json lines_of(const std::vector<std::string>& lines);

/// A value an entry: name, expression, last.
nlohmann::json values_of(const std::vector<Code::Value>& values);

}  // namespace qvgen::emit
