// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <cln/rational.h>

namespace qvgen::model {

/// Exact scalar expression over the parameters of a robot: an immutable, shared tree.
///
/// It knows no simplification and no evaluation: it only holds what the description said, so that the
/// symbolic stage decides what to make of it. Numbers are rationals; a decimal such as 0.4318 is 4318/10000.
class Expression {
 public:
  enum class Kind { number, pi, symbol, negate, sum, product, quotient, power, root, sine, cosine };

  Expression() : Expression(cln::cl_RA(0)) {}
  Expression(const cln::cl_RA& value);  // NOLINT(google-explicit-constructor): numbers are expressions
  static Expression pi();
  static Expression symbol(std::string name);
  /// sum, product: any number of operands; quotient: two; negate, root, sine, cosine: one.
  static Expression make(Kind kind, std::vector<Expression> operands);
  static Expression power(Expression base, long exponent);

  [[nodiscard]] Kind kind() const { return node_->kind; }
  [[nodiscard]] const cln::cl_RA& number() const { return node_->number; }
  [[nodiscard]] const std::string& name() const { return node_->name; }
  [[nodiscard]] long exponent() const { return node_->exponent; }
  [[nodiscard]] const std::vector<Expression>& operands() const { return node_->operands; }
  /// True only for the number 0 itself; an expression that happens to vanish is the symbolic stage's
  /// business.
  [[nodiscard]] bool is_literal_zero() const;

 private:
  struct Node {
    Kind kind;
    cln::cl_RA number;
    std::string name;
    long exponent = 1;
    std::vector<Expression> operands;
  };
  explicit Expression(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

/// Text in the description's own syntax, fully parenthesised where needed; for messages and comments.
std::string to_string(const Expression& expression);

/// The symbols of an expression, sorted, each once.
std::vector<std::string> symbols(const Expression& expression);

}  // namespace qvgen::model
