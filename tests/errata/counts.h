// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "document.h"

namespace qvgen::test::sources {

/// How many rows of a part have which verdict, in the order of `verdict_names`.
using Counts = std::array<int, 6>;
inline constexpr std::array<const char*, 6> verdict_names{"right", "right on a condition", "wrong",
                                                          "name",  "definition",           "not judged"};
Counts counts_of(const Part& part);
int rows_of(const Part& part);
/// Returns how many rows of all parts are errata.
int errata_in(const std::vector<Part>& parts);

/// Returns the introduction of both documents.
std::string introduction();
/// On names, verdicts and slips.
std::string legend();
/// Returns the text before the list of errata, and the one before all other rows.
std::string about_errata(const std::vector<Part>& parts);
std::string about_rest();
/// Returns a table's title with the pages of the source: "pages 22 to 24: 3.1.1: SS".
std::string heading_of(const Table& table);

}  // namespace qvgen::test::sources
