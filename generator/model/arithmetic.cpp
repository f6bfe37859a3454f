// SPDX-License-Identifier: MIT
#include "model/arithmetic.h"

#include <algorithm>

#include <cln/integer.h>

namespace qvgen::model {
namespace {

using Kind = Expression::Kind;

bool is_number(const Expression& e) { return e.kind() == Kind::number; }
bool is_literal(const Expression& e, long value) { return is_number(e) && e.number() == value; }

/// Quarter turns in 0..3 where the angle is a multiple of pi/2.
std::optional<int> quarter_turns(const Expression& angle) {
  const auto form = angle_form(angle);
  if (!form || !cln::zerop(form->radians)) return std::nullopt;
  const cln::cl_RA quarters = form->half_turns * 2;
  if (cln::denominator(quarters) != 1) return std::nullopt;
  return cln::cl_I_to_int(cln::mod(cln::numerator(quarters), 4));
}

/// Adds the term, or strikes out its literal opposite; numbers are gathered in one term.
void add_term(std::vector<Term>& sum, const Term& term) {
  const auto partner = std::find_if(sum.begin(), sum.end(), [&](const Term& other) {
    if (is_number(term.value)) return is_number(other.value);
    return term.negative != other.negative && same(term.value, other.value);
  });
  if (partner == sum.end()) {
    sum.push_back(term);
  } else if (!is_number(term.value)) {
    sum.erase(partner);
  } else {
    const auto signed_value = [](const Term& t) -> cln::cl_RA {
      return t.negative ? -t.value.number() : t.value.number();
    };
    const cln::cl_RA total = signed_value(*partner) + signed_value(term);
    if (cln::zerop(total)) {
      sum.erase(partner);
    } else {
      *partner = {cln::minusp(total), cln::abs(total)};
    }
  }
}

void append_terms(std::vector<Term>& result, const Expression& e, bool negative) {
  if (e.is_literal_zero()) return;
  if (e.kind() == Kind::sum) {
    for (const Expression& operand : e.operands()) append_terms(result, operand, negative);
  } else if (e.kind() == Kind::negate) {
    append_terms(result, e.operands().front(), !negative);
  } else if (is_number(e) && cln::minusp(e.number())) {
    add_term(result, {!negative, Expression(-e.number())});
  } else {
    add_term(result, {negative, e});
  }
}

}  // namespace

bool same(const Expression& a, const Expression& b) {
  if (a.kind() != b.kind()) return false;
  if (a.kind() == Kind::number) return a.number() == b.number();
  return a.name() == b.name() && a.exponent() == b.exponent() &&
         std::equal(a.operands().begin(), a.operands().end(), b.operands().begin(), b.operands().end(), same);
}

std::vector<Term> terms(const Expression& expression) {
  std::vector<Term> result;
  append_terms(result, expression, false);
  return result;
}

Expression sum_of(const std::vector<Term>& terms) {
  std::vector<Expression> operands;
  operands.reserve(terms.size());
  for (const Term& term : terms) operands.push_back(term.negative ? negate(term.value) : term.value);
  if (operands.empty()) return {};
  return operands.size() == 1 ? operands.front() : Expression::make(Kind::sum, std::move(operands));
}

Expression add(const Expression& a, const Expression& b) {
  std::vector<Term> result;
  append_terms(result, a, false);
  append_terms(result, b, false);
  return sum_of(result);
}

Expression subtract(const Expression& a, const Expression& b) {
  std::vector<Term> result;
  append_terms(result, a, false);
  append_terms(result, b, true);
  return sum_of(result);
}

Expression negate(const Expression& a) {
  if (is_number(a)) return -a.number();
  if (a.kind() == Kind::negate) return a.operands().front();
  return Expression::make(Kind::negate, {a});
}

Expression multiply(const Expression& a, const Expression& b) {
  if (is_number(a) && is_number(b)) return a.number() * b.number();
  if (a.is_literal_zero() || b.is_literal_zero()) return {};
  if (is_literal(a, 1)) return b;
  if (is_literal(b, 1)) return a;
  if (is_literal(a, -1)) return negate(b);
  if (is_literal(b, -1)) return negate(a);
  return Expression::make(Kind::product, {a, b});
}

Expression divide(const Expression& a, const Expression& b) {
  if (is_number(a) && is_number(b)) return a.number() / b.number();
  if (a.is_literal_zero() || is_literal(b, 1)) return a;
  return Expression::make(Kind::quotient, {a, b});
}

Expression raise(const Expression& base, long exponent) {
  if (exponent == 1) return base;
  if (is_number(base) && (exponent >= 0 || !base.is_literal_zero())) {
    return cln::expt(base.number(), cln::cl_I(exponent));
  }
  return Expression::power(base, exponent);
}

Expression sine(const Expression& angle) {
  static constexpr std::array<long, 4> values{0, 1, 0, -1};
  if (const auto quarters = quarter_turns(angle)) return {values.at(static_cast<std::size_t>(*quarters))};
  return Expression::make(Kind::sine, {angle});
}

Expression cosine(const Expression& angle) {
  static constexpr std::array<long, 4> values{1, 0, -1, 0};
  if (const auto quarters = quarter_turns(angle)) return {values.at(static_cast<std::size_t>(*quarters))};
  return Expression::make(Kind::cosine, {angle});
}

std::optional<AngleForm> angle_form(const Expression& e) {
  if (is_number(e)) return AngleForm{e.number(), 0};
  if (e.kind() == Kind::pi) return AngleForm{0, 1};
  std::vector<AngleForm> parts;
  for (const Expression& operand : e.operands()) {
    const auto part = angle_form(operand);
    if (!part) return std::nullopt;
    parts.push_back(*part);
  }
  AngleForm result;
  switch (e.kind()) {
    case Kind::negate:
      return AngleForm{-parts[0].radians, -parts[0].half_turns};
    case Kind::sum:
      for (const AngleForm& part : parts) {
        result = {result.radians + part.radians, result.half_turns + part.half_turns};
      }
      return result;
    case Kind::product:
      result.radians = 1;
      for (const AngleForm& part : parts) {
        if (!cln::zerop(result.half_turns) && !cln::zerop(part.half_turns)) return std::nullopt;
        result = {result.radians * part.radians,
                  result.radians * part.half_turns + result.half_turns * part.radians};
      }
      return result;
    case Kind::quotient:
      if (!cln::zerop(parts[1].half_turns) || cln::zerop(parts[1].radians)) return std::nullopt;
      return AngleForm{parts[0].radians / parts[1].radians, parts[0].half_turns / parts[1].radians};
    default:
      return std::nullopt;
  }
}

}  // namespace qvgen::model
