// SPDX-License-Identifier: MIT
#include "emit/ast/literal.h"

#include <cln/real.h>
#include <fmt/format.h>

#include "exact/constant_angle.h"

namespace qvgen::emit {

std::string literal(const exact::Number& number) { return fmt::format("{}", number.to_double()); }

namespace {

using RealFunction = const cln::cl_R (*)(const cln::cl_R&);

std::string literal_of(RealFunction function, const exact::Angle& angle) {
  const auto radians = exact::radians(angle);
  if (!radians) return "";
  return fmt::format("{}", cln::double_approx(function(cln::cl_float(*radians, cln::float_format(40)))));
}

}  // namespace

std::string sine_literal(const exact::Angle& angle) { return literal_of(cln::sin, angle); }
std::string cosine_literal(const exact::Angle& angle) { return literal_of(cln::cos, angle); }

}  // namespace qvgen::emit
