// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/table.h"
#include "compare/comparison.h"

namespace qvgen::cli {

/// A comparison for people or programs: a line for each row. As a table or Markdown also, where pairs and
/// Denavit-Hartenberg matrices were compared, their ratios by workspace class beside those that the thesis
/// measured; JSON has the same numbers; CSV has the rows alone. `machine` says where times were
/// taken.
std::string comparison_report(const std::vector<compare::Row>& rows,
                              const std::map<std::string, std::string>& classes, ReportFormat format,
                              const std::string& machine = "");

}  // namespace qvgen::cli
