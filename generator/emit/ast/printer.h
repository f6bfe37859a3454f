// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/ast/statement.h"

namespace qvgen::emit::ast {

using Lines = std::vector<std::string>;

/// Writes the tree down in a language.
class Printer {
 public:
  virtual ~Printer() = default;
  [[nodiscard]] virtual std::string text(const Expression& expression) const = 0;
  /// Statements, indented by so many blocks around them.
  [[nodiscard]] virtual Lines lines(const Statements& statements, int depth = 0) const = 0;
  [[nodiscard]] virtual Lines function(const Function& function) const = 0;
  /// Lines of the body of a function with those parameters, of which it need not read all.
  [[nodiscard]] virtual Lines body(const std::vector<std::string>& parameters,
                                   const Statements& statements) const = 0;
};

}  // namespace qvgen::emit::ast
