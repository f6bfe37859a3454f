// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::report {

/// The page of a document in Markdown: headings of three levels, paragraphs, tables whose first line is their
/// head, and `code`. Its third headings and tables go into the sections that its second ones begin.
std::string errata_page(const std::string& markdown);

inline constexpr const char* errata_name = "errata.html";

}  // namespace qvgen::report
