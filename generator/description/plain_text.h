// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace qvgen::description {

/// Returns what keeps a text from being one line of a comment in generated code, and from being read as it is
/// written: control characters (a carriage return ends a comment), line separators, marks that turn the
/// direction of writing, a backslash at the end (it joins the next line to the comment). Empty: nothing.
std::string problem_of_text(std::string_view text);

/// The text with every control character and direction mark spelt out, for messages on a terminal.
std::string printable(std::string_view text);

}  // namespace qvgen::description
