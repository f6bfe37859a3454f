// SPDX-License-Identifier: MIT
#pragma once

#include "emit/ast/printer.h"

namespace qvgen::test {

/// A language of its own, as small as one can be: the syntax tree itself as text. `w.x = -a;` is
/// `assign (member x (name w)) (negative (name a))`. It shows what a further language costs, and that nothing
/// but a printer has to know of it.
class Outline : public emit::ast::Printer {
 public:
  [[nodiscard]] std::string text(const emit::ast::Expression& expression) const override;
  [[nodiscard]] emit::ast::Lines lines(const emit::ast::Statements& statements, int depth) const override;
  [[nodiscard]] emit::ast::Lines body(const std::vector<std::string>& /*parameters*/,
                                      const emit::ast::Statements& statements) const override {
    return lines(statements, 0);
  }
  [[nodiscard]] emit::ast::Lines function(const emit::ast::Function& function) const override;
};

}  // namespace qvgen::test
