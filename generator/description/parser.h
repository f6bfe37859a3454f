// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/lexer.h"
#include "model/expression.h"

namespace qvgen::description {

struct ParsedExpression {
  struct SymbolUse {
    std::string name;
    std::size_t offset = 0;
  };
  model::Expression value;
  std::vector<SymbolUse> symbols;  ///< in order of appearance
  bool has_unit = false;           ///< `deg` or `rad` was written: nobody mistook degrees for radians
};

/// Parses the exact expressions of a description; throws ExpressionError at the first mistake.
///
///     expression = term { ("+" | "-") term }
///     term       = factor { ("*" | "/") factor | "deg" | "rad" }
///     factor     = ("-" | "+") factor | primary [ ("^" | "**") [ "-" ] integer ]
///     primary    = number | name | "pi" | ("sqrt" | "sin" | "cos") "(" expression ")" | "(" expression ")"
///
/// A unit belongs to the whole term before it (45/2 deg is 22.5 degrees); sine and cosine take constants
/// only.
ParsedExpression parse_expression(std::string_view text);

}  // namespace qvgen::description
