// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

namespace qvgen::emit {

/// Template that cannot be filled in: a defect of this tool, whatever the robot.
struct TemplateError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Fills the mustache template of that name ("cpp/inverse.h", built into the tool) with the values.
/// A key that the template names and the values lack is an error: TemplateError with template and key.
std::string render(const std::string& template_name, const nlohmann::json& values);

}  // namespace qvgen::emit
