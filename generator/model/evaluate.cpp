// SPDX-License-Identifier: MIT
#include "model/evaluate.h"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational_ring.h>
#include <cln/real.h>

namespace qvgen::model {
namespace {

using Kind = Expression::Kind;
using Reason = EvaluationError::Reason;

cln::float_format_t format() { return cln::float_format(evaluation_digits); }

cln::cl_R inverse(const cln::cl_R& value, const Expression& where) {
  if (vanishes(value)) throw EvaluationError(Reason::division_by_zero, to_string(where) + " is zero");
  return cln::recip(value);
}

cln::cl_R root(const cln::cl_R& radicand, const Expression& where) {
  if (vanishes(radicand)) return 0;
  if (cln::minusp(radicand)) throw EvaluationError(Reason::negative_root, to_string(where) + " is negative");
  cln::cl_RA exact;
  const auto rational = rational_value(radicand);
  if (rational && cln::sqrtp(*rational, &exact)) return exact;
  return cln::sqrt(cln::cl_float(radicand, format()));
}

cln::cl_R sine_or_cosine(Kind kind, const cln::cl_R& angle) {
  if (cln::zerop(angle)) return kind == Kind::sine ? 0 : 1;
  const cln::cl_F wide = cln::cl_float(angle, format());
  return kind == Kind::sine ? cln::sin(wide) : cln::cos(wide);
}

cln::cl_R value_of(const std::string& name, const Bindings& bindings) {
  const auto found = bindings.find(name);
  if (found == bindings.end()) throw EvaluationError(Reason::unbound_symbol, name + " has no value");
  return found->second;
}

cln::cl_R power(const Expression& e, const Bindings& bindings) {
  const cln::cl_R base = evaluate(e.operands().front(), bindings);
  if (e.exponent() < 0) return cln::expt(inverse(base, e.operands().front()), cln::cl_I(-e.exponent()));
  return cln::expt(base, cln::cl_I(e.exponent()));
}

cln::cl_R fold(const Expression& e, const Bindings& bindings) {
  cln::cl_R result = e.kind() == Kind::sum ? 0 : 1;
  for (const Expression& operand : e.operands()) {
    const cln::cl_R value = evaluate(operand, bindings);
    result = e.kind() == Kind::sum ? result + value : result * value;
  }
  return result;
}

}  // namespace

cln::cl_R evaluate(const Expression& e, const Bindings& bindings) {
  const auto operand = [&] { return evaluate(e.operands().front(), bindings); };
  switch (e.kind()) {
    case Kind::number:
      return e.number();
    case Kind::pi:
      return cln::pi(format());
    case Kind::symbol:
      return value_of(e.name(), bindings);
    case Kind::negate:
      return -operand();
    case Kind::sum:
    case Kind::product:
      return fold(e, bindings);
    case Kind::quotient:
      return operand() * inverse(evaluate(e.operands().back(), bindings), e.operands().back());
    case Kind::power:
      return power(e, bindings);
    case Kind::root:
      return root(operand(), e.operands().front());
    case Kind::sine:
    case Kind::cosine:
      return sine_or_cosine(e.kind(), operand());
  }
  return 0;
}

double to_double(const cln::cl_R& value) { return cln::double_approx(value); }

// clang-format takes `instanceof` for a keyword of another language.
// clang-format off
std::optional<cln::cl_RA> rational_value(const cln::cl_R& value) {
  if (!cln::instanceof(value, cln::cl_RA_ring)) return std::nullopt;
  return cln::the<cln::cl_RA>(value);
}
// clang-format on

bool vanishes(const cln::cl_R& value) {
  if (rational_value(value)) return cln::zerop(value);
  static const cln::cl_RA threshold = cln::expt(cln::cl_RA(10), -static_cast<long>(evaluation_digits) + 10);
  return cln::abs(value) < threshold;
}

Bindings default_bindings(const Robot& robot) {
  Bindings bindings;
  for (const auto* parameters : {&robot.geometry, &robot.inertia_parameters}) {
    for (const Parameter& parameter : *parameters) {
      if (parameter.default_value) bindings[parameter.name] = evaluate(*parameter.default_value);
    }
  }
  return bindings;
}

}  // namespace qvgen::model
