// SPDX-License-Identifier: MIT
// Cells of one line of a table: split at the file's separator, without blanks and quotation marks around
// them. Nothing is copied: a cell is a view into the line, so a million rows cost no allocation.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace qvgen::measured {

/// Separator of cells; `blank` is any number of blanks.
enum class Separator { comma, semicolon, tab, blank };

/// Returns the separator of a header: a tab, else a semicolon, else a comma outside brackets, else blanks.
Separator separator_of(std::string_view header);

/// Splits a line into cells; `cells` is overwritten, so that its memory is used again. With blanks "q1 [deg]"
/// is one cell: a bracket belongs to the word before it.
void split(std::string_view line, Separator separator, std::vector<std::string_view>& cells);

/// Returns the text without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// Returns the number that a cell is, infinities and NaN among them; nothing if it is no number.
std::optional<double> number_of(std::string_view cell);

}  // namespace qvgen::measured
