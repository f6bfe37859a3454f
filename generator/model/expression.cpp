// SPDX-License-Identifier: MIT
#include "model/expression.h"

#include <set>
#include <utility>

#include <cln/rational_io.h>

namespace qvgen::model {

Expression::Expression(const cln::cl_RA& value) {
  node_ = std::make_shared<const Node>(Node{Kind::number, value, {}, 1, {}});
}

Expression Expression::pi() {
  static const Expression instance(std::make_shared<const Node>(Node{Kind::pi, 0, {}, 1, {}}));
  return instance;
}

Expression Expression::symbol(std::string name) {
  return Expression(std::make_shared<const Node>(Node{Kind::symbol, 0, std::move(name), 1, {}}));
}

Expression Expression::make(Kind kind, std::vector<Expression> operands) {
  return Expression(std::make_shared<const Node>(Node{kind, 0, {}, 1, std::move(operands)}));
}

Expression Expression::power(Expression base, long exponent) {
  return Expression(std::make_shared<const Node>(Node{Kind::power, 0, {}, exponent, {std::move(base)}}));
}

bool Expression::is_literal_zero() const { return kind() == Kind::number && cln::zerop(number()); }

namespace {

void collect(const Expression& expression, std::set<std::string>& names) {
  if (expression.kind() == Expression::Kind::symbol) names.insert(expression.name());
  for (const Expression& operand : expression.operands()) collect(operand, names);
}

}  // namespace

std::vector<std::string> symbols(const Expression& expression) {
  std::set<std::string> names;
  collect(expression, names);
  return {names.begin(), names.end()};
}

}  // namespace qvgen::model
