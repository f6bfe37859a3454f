// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "report/html.h"

namespace qvgen::report {

/// The functions that a folder's headers of a robot declare, and what it lacks by its entry there.
Section function_section(const std::string& robot, const std::filesystem::path& generated,
                         const nlohmann::ordered_json& entry);

}  // namespace qvgen::report
