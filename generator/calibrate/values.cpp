// SPDX-License-Identifier: MIT
#include "calibrate/values.h"

#include "model/arithmetic.h"

namespace qvgen::calibrate {

using model::Expression;
using Kind = Expression::Kind;

FieldValues::FieldValues(const model::Robot& robot) : point_(1) {
  for (const model::Parameter& parameter : robot.geometry)
    if (parameter.default_value) defaults_[parameter.name] = *parameter.default_value;
}

Field FieldValues::symbol(const std::string& name) {
  const auto found = defaults_.find(name);
  return found == defaults_.end() ? point_.symbol(name) : number(found->second);
}

Field FieldValues::root(const Expression& e) {
  try {
    if (const auto value = model::rational_value(model::evaluate(e.operands().front())))
      return point_.number(exact::Number::root(*value));
  } catch (const std::domain_error&) {  // symbols, or a radicand that is too long
  }
  return point_.symbol(to_string(e));
}

Field FieldValues::number(const Expression& e) {
  const auto& operands = e.operands();
  switch (e.kind()) {
    case Kind::number:
      return point_.number(exact::Number(e.number()));
    case Kind::pi:
      return point_.symbol("pi");
    case Kind::symbol:
      return symbol(e.name());
    case Kind::negate:
      return -number(operands[0]);
    case Kind::sum:
    case Kind::product: {
      Field result = number(operands[0]);
      for (std::size_t i = 1; i < operands.size(); ++i)
        result = e.kind() == Kind::sum ? result + number(operands[i]) : result * number(operands[i]);
      return result;
    }
    case Kind::quotient:
      return number(operands[0]) * number(operands[1]).inverse();
    case Kind::power: {
      const Field base = number(operands[0]);
      const auto power = base.power(static_cast<std::uint64_t>(std::abs(e.exponent())));
      return e.exponent() < 0 ? power.inverse() : power;
    }
    case Kind::root:
      return root(e);
    case Kind::sine:
      return circular(operands[0]).sine;
    case Kind::cosine:
      return circular(operands[0]).cosine;
  }
  return {};
}

CosSin<Field> FieldValues::circular(const Expression& angle) {
  exact::Angle exact;
  if (const auto form = model::angle_form(angle)) {
    exact.pi = form->half_turns;
    if (!cln::zerop(form->radians)) {
      const bool negative = cln::minusp(form->radians);
      exact.terms[to_string(Expression(cln::abs(form->radians)))] = negative ? -1 : 1;
    }
  } else {
    exact.terms[to_string(angle)] = 1;
  }
  const auto value = point_.circular(exact);
  return {value.cosine, value.sine};
}

}  // namespace qvgen::calibrate
