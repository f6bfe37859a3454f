// SPDX-License-Identifier: MIT
#include "emit/ast/statement.h"

#include <algorithm>

namespace qvgen::emit::ast {

using Kind = Statement::Kind;

Statement declare(const Type& type, const std::string& name) { return {Kind::declare, name, type}; }

Statement constant(const Type& type, const std::string& name, const Expression& value) {
  Statement result{Kind::declare, name, type, {value}};
  result.constant = true;
  return result;
}

Statement deduced(const Type& type, const std::string& name, const Expression& value) {
  Statement result{Kind::declare, name, type, {value}};
  result.deduced = true;
  return result;
}

Statement array(const Type& type, const std::string& name, int size) {
  return {Kind::declare_array, name, type, {whole(size)}};
}

Statement row(const std::string& name, int size, Element number) {
  return {Kind::declare_row, name, {"real", number}, {whole(size)}};
}

Statement assign(const Expression& place, const Expression& value) {
  return {Kind::assign, "", {}, {place, value}};
}

Statement evaluate(const Expression& call) { return {Kind::evaluate, "", {}, {call}}; }

Statement guard(const Expression& condition, const Statement& then) {
  return {Kind::guard, "", {}, {condition}, {then}};
}

Statement choose(const Expression& condition, const Statements& body) {
  return {Kind::choose, "", {}, {condition}, body};
}

Statement loop(const std::string& variable, const Expression& rounds, const Statements& body) {
  return {Kind::loop, variable, {}, {rounds}, body};
}

Statement leave_loop() { return {Kind::leave_loop}; }
Statement next_round() { return {Kind::next_round}; }

Statement give(const Expression& value) { return {Kind::give, "", {}, {value}}; }

Statement scope(const Statements& body) { return {Kind::scope, "", {}, {}, body}; }

Statement gap() { return {Kind::gap}; }

void append(Statements& statements, const Statements& more) {
  statements.insert(statements.end(), more.begin(), more.end());
}

bool mentions(const Statements& statements, const std::string& name) {
  return std::any_of(statements.begin(), statements.end(), [&](const Statement& each) {
    return mentions(each.body, name) ||
           std::any_of(each.values.begin(), each.values.end(),
                       [&](const Expression& value) { return mentions(value, name); });
  });
}

}  // namespace qvgen::emit::ast
