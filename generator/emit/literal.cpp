// SPDX-License-Identifier: MIT
#include "emit/literal.h"

#include <fmt/format.h>

namespace qvgen::emit {

std::string literal(const exact::Number& number) { return fmt::format("{}", number.to_double()); }

}  // namespace qvgen::emit
