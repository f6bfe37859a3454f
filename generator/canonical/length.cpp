// SPDX-License-Identifier: MIT
#include "canonical/length.h"

#include <algorithm>

#include "exact/named_constant.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::canonical {
namespace {

using model::Expression;
using Kind = Expression::Kind;

/// A product of more factors is kept as a name: multiplied out it would fill pages.
constexpr std::size_t most_terms = 64;

void add(Length& sum, const std::vector<std::string>& symbols, const cln::cl_R& coefficient) {
  const auto [place, inserted] = sum.try_emplace(symbols, coefficient);
  if (!inserted) place->second = place->second + coefficient;
  if (model::vanishes(place->second)) sum.erase(place);
}

Length number(const cln::cl_R& value) {
  Length result;
  add(result, {}, value);
  return result;
}

Length symbol(const std::string& name) {
  Length result;
  add(result, {name}, 1);
  return result;
}

bool is_number(const Length& length) {
  return length.empty() || (length.size() == 1 && length.begin()->first.empty());
}
cln::cl_R value_of(const Length& length) { return length.empty() ? cln::cl_R(0) : length.begin()->second; }

Length named(const Expression& expression, Definitions& definitions) {
  const std::string name = "value(" + model::to_string(expression) + ")";
  definitions.emplace(name, expression);
  return symbol(name);
}

Length power(const Expression& expression, Definitions& definitions) {
  const Length base = to_length(expression.operands().front(), definitions);
  if (expression.exponent() < 0 || expression.exponent() > 4) return named(expression, definitions);
  Length result = number(1);
  for (long i = 0; i < expression.exponent(); ++i) result = result * base;
  return result;
}

}  // namespace

Length operator+(const Length& a, const Length& b) {
  Length sum = a;
  for (const auto& [symbols, coefficient] : b) add(sum, symbols, coefficient);
  return sum;
}

Length operator*(const cln::cl_R& factor, const Length& a) {
  Length result;
  for (const auto& [symbols, coefficient] : a) add(result, symbols, factor * coefficient);
  return result;
}

Length operator*(const Length& a, const Length& b) {
  Length product;
  for (const auto& [first, x] : a) {
    for (const auto& [second, y] : b) {
      std::vector<std::string> symbols = first;
      symbols.insert(symbols.end(), second.begin(), second.end());
      std::sort(symbols.begin(), symbols.end());
      add(product, symbols, x * y);
    }
  }
  return product;
}

Length to_length(const Expression& e, Definitions& definitions) {
  if (model::symbols(e).empty()) return number(model::evaluate(e));
  const auto operand = [&](std::size_t i) { return to_length(e.operands()[i], definitions); };
  switch (e.kind()) {
    case Kind::symbol:
      return symbol(e.name());
    case Kind::negate:
      return cln::cl_R(-1) * operand(0);
    case Kind::sum: {
      Length sum;
      for (const Expression& each : e.operands()) sum = sum + to_length(each, definitions);
      return sum;
    }
    case Kind::product: {
      Length product = number(1);
      for (const Expression& each : e.operands()) {
        product = product * to_length(each, definitions);
        if (product.size() > most_terms) return named(e, definitions);
      }
      return product;
    }
    case Kind::quotient: {
      const Length below = operand(1);
      if (is_number(below) && !below.empty()) return cln::recip(value_of(below)) * operand(0);
      return named(e, definitions);
    }
    case Kind::power:
      return power(e, definitions);
    default:
      return named(e, definitions);
  }
}

Expression to_expression(const Length& length) {
  Expression sum;
  for (const auto& [symbols, coefficient] : length) {
    const auto rational = exact::rational_near(coefficient);
    Expression term =
        rational ? Expression(*rational) : Expression::symbol(exact::name_of_number(coefficient));
    for (const std::string& name : symbols) term = model::multiply(term, Expression::symbol(name));
    sum = model::add(sum, term);
  }
  return sum;
}

bool is_polynomial(const Expression& e) {
  const auto& parts = e.operands();
  switch (e.kind()) {
    case Kind::number:
    case Kind::symbol:
      return true;
    case Kind::negate:
    case Kind::sum:
    case Kind::product:
      return std::all_of(parts.begin(), parts.end(), is_polynomial);
    case Kind::quotient:
      return parts[1].kind() == Kind::number && is_polynomial(parts[0]);
    case Kind::power:
      return e.exponent() > 0 && is_polynomial(parts[0]);
    default:
      return false;
  }
}

Expression named_constants(const Expression& expression, Definitions& definitions) {
  if (is_polynomial(expression)) return expression;
  return to_expression(to_length(expression, definitions));
}

}  // namespace qvgen::canonical
