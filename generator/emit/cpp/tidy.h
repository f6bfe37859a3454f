// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::emit {

/// The longest line of a generated file.
inline constexpr std::size_t line_width = 120;

/// Generated C++ as it is written to a file: [[maybe_unused]], which templates put wherever a thing may turn
/// out not to be needed, stays only where it is not; and lines are broken.
std::string tidy(const std::string& code);

/// Takes [[maybe_unused]] away from parameters and variables that the code behind them names.
std::string without_needless_attributes(const std::string& code);

/// Without the blank lines that empty sections of a template leave.
std::string without_spare_lines(const std::string& text);

/// Lines of at most `line_width`, broken where fewest brackets are open; indented by four more. Comments by
/// words.
std::string wrapped(const std::string& code);

}  // namespace qvgen::emit
