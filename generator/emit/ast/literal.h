// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "exact/angle.h"
#include "exact/number.h"

namespace qvgen::emit {

/// C++ literal of the double nearest to a number, the shortest text that reads back as it: "2", "0.4318".
std::string literal(const exact::Number& number);
/// Returns the sine, and the cosine, of an angle without a variable as a literal; empty if it has one.
std::string sine_literal(const exact::Angle& angle);
std::string cosine_literal(const exact::Angle& angle);

}  // namespace qvgen::emit
