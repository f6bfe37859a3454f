// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "exact/number.h"

namespace qvgen::emit {

/// C++ literal of the double nearest to a number, the shortest text that reads back as it: "2", "0.4318".
std::string literal(const exact::Number& number);

}  // namespace qvgen::emit
