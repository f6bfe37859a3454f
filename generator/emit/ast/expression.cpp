// SPDX-License-Identifier: MIT
#include "emit/ast/expression.h"

#include <algorithm>

namespace qvgen::emit::ast {

using Kind = Expression::Kind;

Expression real(const std::string& decimal) { return {Kind::real, decimal, {}, {"real"}}; }
Expression whole(int value) { return {Kind::literal, std::to_string(value), {}, {"int"}}; }
Expression truth(bool value) { return {Kind::literal, value ? "true" : "false", {}, {"bool"}}; }

Expression name(const std::string& text, const Type& type, Reach reach) {
  return {Kind::name, text, {}, type, reach};
}

Expression member(const Expression& object, const std::string& member, const Type& type, Reach reach) {
  return {Kind::member, member, {object}, type, reach};
}

Expression entry(const Expression& array, const Expression& index, const Type& type) {
  return {Kind::entry, "", {array, index}, type};
}

Expression entry(const std::string& array, std::size_t index) {
  return entry(name(array), whole(static_cast<int>(index)), {"real"});
}

Expression convert(const Expression& value, Element number) {
  return {Kind::convert, "", {value}, {"real", number}};
}

Expression negative(const Expression& value) { return {Kind::negative, "", {value}, value.type}; }
Expression sum(const Expressions& terms) { return {Kind::sum, "", terms, terms.front().type}; }
Expression product(const Expressions& factors) { return {Kind::product, "", factors, factors.front().type}; }

Expression quotient(const Expression& numerator, const Expression& denominator) {
  return {Kind::quotient, "", {numerator, denominator}, numerator.type};
}

Expression grouped(const Expression& value) { return {Kind::grouped, "", {value}, value.type}; }

Expression compare(const Expression& a, const std::string& by, const Expression& b) {
  return {Kind::compare, by, {a, b}, {"bool"}};
}

Expression is_not(const Expression& condition) { return {Kind::is_not, "", {condition}, {"bool"}}; }

Expression condition(const Expression& holds, const Expression& yes, const Expression& no) {
  return {Kind::condition, "", {holds, yes, no}, yes.type};
}

Expression sign(const std::vector<int>& signs, Element number) {
  Expression result{Kind::sign, "", {}, {"real", number}};
  for (const int each : signs) result.operands.push_back(whole(each));
  return result;
}

Expression sign_of_round(const std::string& variable, Element number) {
  return {Kind::sign_of_round, "", {name(variable, {"int"})}, {"real", number}};
}

Expression rotor(const Expression& cosine, const Expression& sine) {
  return {Kind::rotor, "", {cosine, sine}, {"Rotor"}};
}

Expression turned(const Expression& a, const Expression& b) { return {Kind::turned, "", {a, b}, {"Rotor"}}; }

Expression scaled(const Expression& factor, const Expression& rotor) {
  return {Kind::scaled, "", {factor, rotor}, {"Rotor"}};
}

Expression inverse(const Expression& rotor) { return {Kind::inverse, "", {rotor}, {"Rotor"}}; }

Expression angle(const Expression& cosine, const Expression& sine) {
  return {Kind::angle, "", {cosine, sine}, {"real"}};
}

Expression pair(const Expressions& members, const Type& type) { return {Kind::pair, "", members, type}; }

Expression make(const std::string& type, const Expressions& members) {
  return {Kind::make, type, members, {type}};
}

Expression pi() { return {Kind::pi, "", {}, {"real"}}; }
Expression reference(const Expression& place) { return {Kind::reference, "", {place}, place.type}; }
Expression usual(const Expression& argument) { return {Kind::usual, "", {argument}, argument.type}; }

Expression call(Expression::Kind kind, const std::string& name, const Expressions& arguments) {
  return {kind, name, arguments};
}

Expression method(const Expression& object, const std::string& name, const Expressions& arguments) {
  Expression result{Kind::method, name, {object}};
  result.operands.insert(result.operands.end(), arguments.begin(), arguments.end());
  return result;
}

bool mentions(const Expression& expression, const std::string& name) {
  if (expression.kind == Kind::name && expression.text == name) return true;
  return std::any_of(expression.operands.begin(), expression.operands.end(),
                     [&](const Expression& each) { return mentions(each, name); });
}

}  // namespace qvgen::emit::ast
