// SPDX-License-Identifier: MIT
#include <sstream>

#include <cln/rational_io.h>

#include "model/expression.h"

namespace qvgen::model {
namespace {

using Kind = Expression::Kind;

/// How tightly an expression's text binds; an operand that binds less than its place asks for is
/// parenthesised.
enum class Binding { sum, product, power, atom };

std::string number_text(const cln::cl_RA& value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

bool is_negative_number(const Expression& e) { return e.kind() == Kind::number && cln::minusp(e.number()); }

Binding binding(const Expression& e) {
  switch (e.kind()) {
    case Kind::number:
      if (is_negative_number(e)) return Binding::sum;
      return cln::denominator(e.number()) == 1 ? Binding::atom : Binding::product;
    case Kind::sum:
    case Kind::negate:
      return Binding::sum;
    case Kind::product:
    case Kind::quotient:
      return Binding::product;
    case Kind::power:
      return Binding::power;
    default:
      return Binding::atom;
  }
}

std::string text_at(const Expression& e, Binding least) {
  const std::string text = to_string(e);
  return binding(e) < least ? "(" + text + ")" : text;
}

std::string sum_text(const Expression& e) {
  std::string text;
  for (const Expression& term : e.operands()) {
    if (text.empty()) {
      text = to_string(term);
    } else if (term.kind() == Kind::negate) {
      text += " - " + text_at(term.operands().front(), Binding::product);
    } else if (is_negative_number(term)) {
      text += " - " + number_text(-term.number());
    } else {
      text += " + " + text_at(term, Binding::product);
    }
  }
  return text.empty() ? "0" : text;
}

std::string product_text(const Expression& e) {
  std::string text;
  for (const Expression& factor : e.operands()) {
    // Division is left-associative: only the first factor may be a bare fraction.
    text += text.empty() ? text_at(factor, Binding::product) : "*" + text_at(factor, Binding::power);
  }
  return text.empty() ? "1" : text;
}

std::string call_text(const char* function, const Expression& e) {
  return function + ("(" + to_string(e.operands().front()) + ")");
}

}  // namespace

std::string to_string(const Expression& e) {
  switch (e.kind()) {
    case Kind::number:
      return number_text(e.number());
    case Kind::pi:
      return "pi";
    case Kind::symbol:
      return e.name();
    case Kind::negate:
      return "-" + text_at(e.operands().front(), Binding::product);
    case Kind::sum:
      return sum_text(e);
    case Kind::product:
      return product_text(e);
    case Kind::quotient:
      return text_at(e.operands().front(), Binding::product) + "/" +
             text_at(e.operands().back(), Binding::power);
    case Kind::power:
      return text_at(e.operands().front(), Binding::atom) + "^" + std::to_string(e.exponent());
    case Kind::root:
      return call_text("sqrt", e);
    case Kind::sine:
      return call_text("sin", e);
    case Kind::cosine:
      return call_text("cos", e);
  }
  return {};
}

}  // namespace qvgen::model
