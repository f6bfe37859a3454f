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

/// What both documents say first.
std::string introduction();
/// On names, verdicts and slips.
std::string legend();

}  // namespace qvgen::test::sources
