// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/table.h"

namespace qvgen::cli {

/// Filter of the operation counts; nothing named means all.
struct CountsFilter {
  std::vector<std::string> robots;
  std::vector<std::string> functions;
  std::vector<std::string> columns;  ///< of `counts_columns`
};
const std::vector<std::string>& counts_columns();

/// Throws UsageError for names of robots and functions that the counts do not have.
void check(const CountsFilter& filter, const nlohmann::ordered_json& counts);
/// The counts of the robots and functions that are wanted.
nlohmann::ordered_json filtered(const nlohmann::ordered_json& counts, const CountsFilter& filter);

/// The operation counts (the content of operation_counts.json) for people or programs, one line a function;
/// with `forms` also a line for each form that competed, by itself after the passes. No columns named: all.
std::string report(const nlohmann::ordered_json& counts, ReportFormat format, bool forms = false,
                   const std::vector<std::string>& columns = {});

/// Returns the changes from one file of operation counts to another: a line for each function whose numbers
/// differ, or that is in one of the files alone, and how many became cheaper by the cost model. JSON has the
/// numbers of both.
std::string changes(const nlohmann::ordered_json& before, const nlohmann::ordered_json& after,
                    ReportFormat format, const std::vector<std::string>& columns = {});

}  // namespace qvgen::cli
