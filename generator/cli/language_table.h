// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::cli {

/// Returns the parts by language, "yes" or a number that a line below gives the reason of, and what a
/// language's files and numbers are.
std::string language_table();

}  // namespace qvgen::cli
