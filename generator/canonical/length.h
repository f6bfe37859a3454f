// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <cln/real.h>

#include "model/robot.h"

namespace qvgen::canonical {

/// Names of a canonical arm for the description's quotients, roots and sines of symbols, with their
/// definitions.
using Definitions = std::map<std::string, model::Expression>;

/// A length as a polynomial: products of symbols (sorted; the empty one for a number) with real coefficients,
/// each in model::evaluation_digits digits. Coefficients that vanish are left out.
using Length = std::map<std::vector<std::string>, cln::cl_R>;
using LengthVector = std::array<Length, 3>;

/// Reads an expression. What is no polynomial in the symbols becomes a symbol of its own, defined in
/// `definitions`.
Length to_length(const model::Expression& expression, Definitions& definitions);
/// Coefficients that are rational stand as such, others as named constants (exact/named_constant.h).
model::Expression to_expression(const Length& length);

Length operator+(const Length& a, const Length& b);
Length operator*(const Length& a, const Length& b);
Length operator*(const cln::cl_R& factor, const Length& a);

/// Made of rational numbers, symbols, sums and products alone.
bool is_polynomial(const model::Expression& expression);

/// The expression with names for what is neither rational nor a polynomial; others stay as they are written.
model::Expression named_constants(const model::Expression& expression, Definitions& definitions);

}  // namespace qvgen::canonical
