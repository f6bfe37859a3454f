// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace qvgen::emit {

/// Fills the mustache template of that name ("cpp/inverse.h", built into the tool) with the values.
/// A key that the template names and the values lack is an error: std::invalid_argument with template and
/// key.
std::string render(const std::string& template_name, const nlohmann::json& values);

}  // namespace qvgen::emit
