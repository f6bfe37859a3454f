// SPDX-License-Identifier: MIT
#include "emit/cpp/printer.h"

#include <stdexcept>

namespace qvgen::emit {

using ast::Element;
using ast::Expression;
using ast::Function;
using ast::Statement;

namespace {

/// Scalar's own function, or the standard library's for its type.
std::string found(const std::string& name, const std::string& value) {
  return "[](const Scalar& operand) { using std::" + name + "; return " + name + "(operand); }(" + value +
         ")";
}

}  // namespace

std::string CppPrinter::number(Element number) const {
  switch (number) {
    case Element::generic:
      return "Scalar";
    case Element::plain:
      return "double";
    case Element::lanes:
      return lane_;
  }
  return {};
}

std::string CppPrinter::type(const ast::Type& type) const {
  if (type.name.empty()) return "void";
  if (type.name == "real") return number(type.number);
  if (type.name == "int" || type.name == "bool" || type.name == "Target") return type.name;
  const std::string scope = type.name == "Work" ? "" : "inverse::";
  return scope + type.name + "<" + number(type.number) + ">";
}

std::string CppPrinter::arrow(const Expression& object) const {
  return object.reach == ast::Reach::pointer ? "->" : ".";
}

std::string CppPrinter::real(const std::string& decimal) const { return "Scalar(" + decimal + ")"; }

std::string CppPrinter::function(const std::string& name, const std::string& value) const {
  return name == "sqrt" ? name + "(" + value + ")" : found(name, value);
}

std::string CppPrinter::mathematical(const std::string& name, const std::string& value) const {
  return (lane_.empty() ? "std::" : "") + name + "(" + value + ")";
}

std::string CppPrinter::sign(const Expression& e) const {
  const bool is_lane = e.type.number == Element::lanes;
  if (e.kind == Expression::Kind::sign && is_lane) return called(lane_, e.operands);
  if (e.kind == Expression::Kind::sign) return text(e.operands[0]) + ".0";
  const std::string signs = text(e.operands[0]) + " == 0 ? 1.0 : -1.0";
  return is_lane ? lane_ + "(" + signs + ")" : signs;
}

std::string CppPrinter::call(const Expression& e) const {
  using Kind = Expression::Kind;
  switch (e.kind) {
    case Kind::block:
      return called("inverse::" + e.text + "<Scalar>", e.operands);
    case Kind::direction_block:
      return called("inverse::" + e.text + (text(e.operands[0]) == "true" ? "<Scalar, true>" : "<Scalar>"),
                    e.operands, 1);
    case Kind::runtime:
      return called("inverse::" + e.text, e.operands);
    case Kind::method:
      return called(text(e.operands[0]) + arrow(e.operands[0]) + e.text, e.operands, 1);
    case Kind::polishes:
    case Kind::polishes_seed:
      return called("solve_" + e.text, e.operands);
    case Kind::function:
      return function(e.text, list(e.operands));
    case Kind::mathematical:
      return mathematical(e.text, list(e.operands));
    default:
      return called(e.text, e.operands);
  }
}

std::string CppPrinter::spelled(const Expression& e) const {
  using Kind = Expression::Kind;
  const auto operand = [&](std::size_t i) { return text(e.operands[i]); };
  switch (e.kind) {
    case Kind::nothing:
    case Kind::usual:
      return {};
    case Kind::real:
      return real(e.text);
    case Kind::entry: {
      const bool is_variable = e.operands[1].kind == Kind::name;
      return operand(0) + "[" + (is_variable ? "static_cast<std::size_t>(" + operand(1) + ")" : operand(1)) +
             "]";
    }
    case Kind::convert:
      return e.type.number == Element::plain ? operand(0) : number(e.type.number) + "(" + operand(0) + ")";
    case Kind::is_not:
      return e.operands[0].type.number == Element::lanes ? "!any(" + operand(0) + ")" : "!" + operand(0);
    case Kind::sign:
    case Kind::sign_of_round:
      return sign(e);
    case Kind::rotor:
      return "inverse::Rotor<Scalar>{" + list(e.operands) + "}";
    case Kind::turned:
    case Kind::scaled:
      return operand(0) + " * " + operand(1);
    case Kind::inverse:
      return "inverse::inverse(" + operand(0) + ")";
    case Kind::angle:
      return "inverse::angle(" + text(ast::rotor(e.operands[0], e.operands[1])) + ")";
    case Kind::make:
      return "{" + list(e.operands) + "}";
    case Kind::pi:
      return "inverse::pi<Scalar>()";
    case Kind::direction:
      return "direction(" + operand(0) + ")";
    case Kind::reference:
      return operand(0);
    default:
      return call(e);
  }
}

ast::Lines CppPrinter::declared(const Statement& s) const {
  const std::string auto_type = s.alias ? "auto&" : "auto";
  const std::string head =
      (s.constant ? "const " : "") + (s.deduced ? auto_type : type(s.type)) + " " + s.name;
  if (s.values.empty()) return {head + (s.zeroed ? "{};" : ";")};
  return {head + " = " + text(s.values[0]) + ";"};
}

ast::Lines CppPrinter::nearest_root(const Statement& s) const {
  const std::string k = "k" + s.name, each = "each" + s.name, nearest = "nearest" + s.name;
  return {"inverse::NearestRoot<Work<double>> " + nearest + "(w);",
          "for (int " + k + " = 0; " + k + " < roots.count; ++" + k + ") {",
          "  Work<double> " + each + " = w;",
          "  " + text(s.values[0]) + ";",
          "  " + nearest + ".add(" + each + ", " + text(s.values[1]) + ", " + k + ");",
          "}",
          "forks.label = " + text(s.values[2]) + " * forks.label + " + nearest + ".index;",
          "w = " + nearest + ".work;"};
}

ast::Lines CppPrinter::spelled(const Statement& s) const {
  using Kind = Statement::Kind;
  switch (s.kind) {
    case Kind::declare:
      return declared(s);
    case Kind::declare_array:
      return {type(s.type) + " " + s.name + "[" + text(s.values[0]) + "];"};
    case Kind::declare_row:
      if (s.type.number == Element::lanes) return {lane_ + " " + s.name + "[" + text(s.values[0]) + "];"};
      return {"qvgen::Joints<" + text(s.values[0]) + "> " + s.name + ";"};
    case Kind::assign: {
      std::string line;
      for (const Expression& each : s.values) line += (line.empty() ? "" : " = ") + text(each);
      return {line + ";"};
    }
    case Kind::take_nearer:
      return {"inverse::take_nearer(" + list(s.values) + ", forks);"};
    case Kind::gap:
      return {""};
    case Kind::nearest_root:
      return nearest_root(s);
    default:
      throw std::logic_error("C++: a statement without a spelling");
  }
}

std::string CppPrinter::parameter(const Function& function, const Function::Parameter& each) const {
  if (each.type.name == "Tracker" || each.type.name == "Visited") return "Tracker& " + each.name;
  if (each.type.name == "int") return "int " + each.name;
  const bool is_read =
      each.changed || function.role == Function::Role::polish || ast::mentions(function.body, each.name);
  return (is_read ? "" : "[[maybe_unused]] ") + std::string(each.changed ? "" : "const ") + type(each.type) +
         "& " + each.name;
}

/// The first line has the values that a step reads, the second those that it takes or leaves.
std::string CppPrinter::head(const Function& function) const {
  using Role = Function::Role;
  const std::size_t count = function.parameters.size();
  const std::size_t second_line = function.role == Role::solve  ? count - 1
                                  : function.role == Role::take ? 1
                                                                : count;
  std::string text = "inline " + type(function.result) + " " + function.name + "(";
  for (std::size_t i = 0; i < count; ++i)
    text += (i == 0 ? "" : i == second_line ? ",\n    " : ", ") + parameter(function, function.parameters[i]);
  return text + ") {";
}

ast::Lines CppPrinter::function(const Function& function) const {
  using Role = Function::Role;
  ast::Lines result;
  for (const std::string& each : function.comment) result.push_back("/// " + each);
  const bool is_polish = function.role == Role::polish;
  result.emplace_back(is_polish ? "template <typename Scalar, class Tracker>" : "template <typename Scalar>");
  result.push_back(head(function));
  if (function.role != Role::take) result.emplace_back("  using std::sqrt;");
  for (const std::string& each : lines(function.body, 1)) result.push_back(each);
  if (is_polish)
    for (const std::string& each : polish(function.task)) result.push_back("  " + each);
  result.emplace_back("}");
  return result;
}

namespace {

class PlainCpp : public CppPrinter {
  [[nodiscard]] std::string function(const std::string& name, const std::string& value) const override {
    return found(name, value);
  }
};

}  // namespace

const ast::Printer& cpp() {
  static const CppPrinter printer;
  return printer;
}

const ast::Printer& plain_cpp() {
  static const PlainCpp printer;
  return printer;
}

}  // namespace qvgen::emit
