// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "description/source.h"

namespace qvgen::description {

/// Far beyond any robot, and small enough for recursion and for what grows with the square.
inline constexpr std::size_t max_bytes = 1U << 18U;
inline constexpr int max_dots = 1000;     ///< of dotted keys, in the whole file
inline constexpr int max_symbols = 1000;  ///< declared ones

/// Returns the place where a text has more dotted keys than any description has: each part is a table inside
/// the one before, and the parser's recursion must not reach the end of the stack. Nullopt: nowhere.
std::optional<Place> too_many_dots(std::string_view text);

}  // namespace qvgen::description
