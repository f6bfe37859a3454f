// SPDX-License-Identifier: MIT
#pragma once

#include "emit/ast/printer.h"

namespace qvgen::emit::ast {

/// Writes operators and control flow, which C and C++ have alike. The rest is the language's.
class CLikePrinter : public Printer {
 public:
  [[nodiscard]] std::string text(const Expression& expression) const final;
  [[nodiscard]] Lines lines(const Statements& statements, int depth = 0) const final;
  [[nodiscard]] Lines body(const std::vector<std::string>& parameters,
                           const Statements& statements) const override;

 protected:
  /// Expressions and statements that the languages write differently.
  [[nodiscard]] virtual std::string spelled(const Expression& expression) const = 0;
  [[nodiscard]] virtual Lines spelled(const Statement& statement) const = 0;
  /// Text between an object and its member.
  [[nodiscard]] virtual std::string arrow(const Expression& object) const = 0;
  /// Statement in front of a loop that compilers shall write out; empty if there is none.
  [[nodiscard]] virtual std::string unroll() const { return {}; }

  /// Texts of expressions with commas between; nothing is left out.
  [[nodiscard]] std::string list(const Expressions& expressions, std::size_t first = 0) const;
  [[nodiscard]] std::string called(const std::string& name, const Expressions& arguments,
                                   std::size_t first = 0) const {
    return name + "(" + list(arguments, first) + ")";
  }

 private:
  [[nodiscard]] std::string factor(const Expression& expression) const;
  [[nodiscard]] std::string divisor(const Expression& expression) const;
  [[nodiscard]] std::string sum(const Expressions& terms) const;
  [[nodiscard]] std::string product(const Expressions& factors) const;
  void add(const Statement& statement, int depth, Lines& lines) const;
  void add_block(const std::string& head, const Statements& body, int depth, Lines& lines) const;
};

/// A line of code inside that many blocks.
std::string indented(int depth, const std::string& line);

}  // namespace qvgen::emit::ast
