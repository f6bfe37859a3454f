// SPDX-License-Identifier: MIT
#include "symbolic/model.h"

#include <map>
#include <stdexcept>

namespace qvgen::symbolic {

using GiNaC::ex;
using model::Expression;

GiNaC::symbol symbol(const std::string& name) {
  static std::map<std::string, GiNaC::symbol> known;
  const auto place = known.find(name);
  if (place != known.end()) return place->second;
  return known.emplace(name, GiNaC::realsymbol(name)).first->second;
}

namespace {

ex sum_of(const std::vector<Expression>& operands) {
  ex sum = 0;
  for (const Expression& operand : operands) sum += to_symbolic(operand);
  return sum;
}

ex product_of(const std::vector<Expression>& operands) {
  ex product = 1;
  for (const Expression& operand : operands) product *= to_symbolic(operand);
  return product;
}

}  // namespace

ex to_symbolic(const Expression& expression) {
  const auto operand = [&](std::size_t i) { return to_symbolic(expression.operands()[i]); };
  switch (expression.kind()) {
    case Expression::Kind::number:
      return GiNaC::numeric(expression.number());
    case Expression::Kind::pi:
      return GiNaC::Pi;
    case Expression::Kind::symbol:
      return symbol(expression.name());
    case Expression::Kind::negate:
      return -operand(0);
    case Expression::Kind::sum:
      return sum_of(expression.operands());
    case Expression::Kind::product:
      return product_of(expression.operands());
    case Expression::Kind::quotient:
      return operand(0) / operand(1);
    case Expression::Kind::power:
      return GiNaC::pow(operand(0), static_cast<int>(expression.exponent()));
    case Expression::Kind::root:
      return GiNaC::sqrt(operand(0));
    case Expression::Kind::sine:
      return GiNaC::sin(operand(0));
    case Expression::Kind::cosine:
      return GiNaC::cos(operand(0));
  }
  throw std::logic_error("unknown kind of expression");
}

Vector to_symbolic(const model::Vector3& vector) {
  return {to_symbolic(vector[0]), to_symbolic(vector[1]), to_symbolic(vector[2])};
}

Pair to_symbolic(const model::Displacement& displacement) {
  Quaternion orientation;
  for (const model::Turn& turn : displacement.turns)
    orientation = orientation * rotation(to_symbolic(turn.axis), to_symbolic(turn.angle));
  return {orientation, to_symbolic(displacement.translation)};
}

Pair motion(const model::Joint& joint) {
  const Vector axis = to_symbolic(joint.axis);
  const ex variable = symbol(joint.variable);
  if (joint.type == model::JointType::revolute) return {rotation(axis, variable), {}};
  return {{}, variable * axis};
}

}  // namespace qvgen::symbolic
