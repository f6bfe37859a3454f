// SPDX-License-Identifier: MIT
// Kinds of characters in descriptions, the same whatever the user's locale calls a letter.
#pragma once

namespace qvgen::description {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace qvgen::description
