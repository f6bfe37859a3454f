// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "cli/table.h"

namespace qvgen::cli {

/// The operation counts (the content of operation_counts.json) for people or programs, one line a function;
/// with `forms` also a line for each form that competed, by itself after the passes.
std::string report(const nlohmann::ordered_json& counts, ReportFormat format, bool forms = false);

}  // namespace qvgen::cli
