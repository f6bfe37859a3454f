// SPDX-License-Identifier: MIT
#include "emit/c/printer.h"

#include <map>
#include <stdexcept>
#include <utility>

namespace qvgen::emit::c {

using ast::Expression;
using ast::Lines;
using ast::Reach;
using ast::Statement;

namespace {

/// Functions of the runtime that C++ tells apart by their first argument.
std::string overloaded(const std::string& name, const std::string& type) {
  static const std::map<std::pair<std::string, std::string>, std::string> names{
      {{"apart", "Rotor"}, "turn_apart"},
      {{"apart", "real"}, "slide_apart"},
      {{"apart", "WristAngles"}, "wrist_apart"},
      {{"append", "Nearest"}, "take_row"}};
  const auto place = names.find({name, type});
  return place == names.end() ? name : place->second;
}

/// Function that stands for a method of an object.
std::string function_of(const std::string& type, const std::string& name) {
  static const std::map<std::pair<std::string, std::string>, std::string> names{
      {{"Tracker", "settled"}, "is_settled"},     {{"Visited", "settled"}, "visit_is_settled"},
      {{"Tracker", "close"}, "close_branch"},     {{"Visited", "close"}, "close_branch"},
      {{"Tracker", "reopen"}, "reopen_branch"},   {{"Visited", "reopen"}, "reopen_visit"},
      {{"Branch", "resume"}, "resume"},           {{"Forks", "takes_other"}, "takes_other"},
      {{"Forks", "leave_if_far"}, "leave_if_far"}};
  return names.at({type, name});
}

/// A decimal text as a double.
std::string number(const std::string& decimal) {
  const bool whole = decimal.find_first_not_of("-0123456789") == std::string::npos;
  const std::string text = whole ? decimal + ".0" : decimal;
  return text[0] == '-' ? "(" + text + ")" : text;
}

/// Members of pairs are arguments of their own.
ast::Expressions spread_out(const ast::Expressions& arguments) {
  ast::Expressions result;
  for (const Expression& each : arguments)
    if (each.kind == Expression::Kind::pair)
      result.insert(result.end(), each.operands.begin(), each.operands.end());
    else
      result.push_back(each);
  return result;
}

}  // namespace

std::string Printer::type(const ast::Type& type) const {
  if (type.name.empty()) return "void";
  if (type.name == "real") return "double";
  return (type.name == "Work" || type.name == "Target" ? prefix_ : "") + type.name;
}

std::string Printer::arrow(const Expression& object) const {
  return object.reach == Reach::value ? "." : "->";
}

std::string Printer::address(const Expression& place) const {
  return (place.reach == Reach::value ? "&" : "") + text(place);
}

std::string Printer::method(const Expression& e) const {
  const Expression& object = e.operands[0];
  if (e.text == "size") return text(object) + "->count";
  const std::string arguments = list(e.operands, 1);
  return function_of(object.type.name, e.text) + "(" + address(object) + (arguments.empty() ? "" : ", ") +
         arguments + ")";
}

std::string Printer::call(const Expression& e) const {
  using Kind = Expression::Kind;
  switch (e.kind) {
    case Kind::runtime:
      return called(overloaded(e.text, e.operands[0].type.name), spread_out(e.operands));
    case Kind::method:
      return method(e);
    case Kind::own:
      return called(prefix_ + e.text, e.operands);
    case Kind::polishes:
      return called(prefix_ + "solve_" + e.text, e.operands);
    case Kind::polishes_seed:
      return called(prefix_ + "solve_" + e.text + "_near_seed",
                    {e.operands[0], e.operands[2], e.operands[3]});
    default:
      return called(e.text, e.operands);
  }
}

std::string Printer::spelled(const Expression& e) const {
  using Kind = Expression::Kind;
  const auto operand = [&](std::size_t i) { return text(e.operands[i]); };
  switch (e.kind) {
    case Kind::nothing:
    case Kind::pi:
      return {};
    case Kind::real:
      return number(e.text);
    case Kind::entry:
      return operand(0) + (e.operands[0].type.name == "JointValues" ? "->of[" : "[") + operand(1) + "]";
    case Kind::convert:
    case Kind::usual:
      return operand(0);
    case Kind::is_not:
      return "!" + operand(0);
    case Kind::sign:
      return operand(0) + ".0";
    case Kind::sign_of_round:
      return operand(0) + " == 0 ? 1.0 : -1.0";
    case Kind::rotor:
      return called("rotor", e.operands);
    case Kind::turned:
      return called("product", e.operands);
    case Kind::scaled:
      return called("scaled", e.operands);
    case Kind::inverse:
      return called("inverse", e.operands);
    case Kind::angle:
      return called("arctangent", {e.operands[1], e.operands[0]});
    case Kind::direction:
      return "(" + operand(0) + " > 0 ? 1.0 : " + operand(0) + " < 0 ? -1.0 : 0.0)";
    case Kind::make:
      return "(" + e.text + "){" + list(e.operands) + "}";
    case Kind::reference:
      return address(e.operands[0]);
    default:
      return call(e);
  }
}

/// Work is handed on by pointers, so that a name is one too.
Lines Printer::declared_work(const Statement& s) const {
  const std::string work = type(s.type), own = "own_" + s.name;
  Lines result;
  if (!s.values.empty()) {
    result.push_back(work + " " + own + " = *" + text(s.values[0]) + ";");
  } else {
    result.push_back(work + " " + own + ";");
    if (s.zeroed) result.push_back("memset(&" + own + ", 0, sizeof " + own + ");");
    result.push_back(own + ".branch = new_branch;");
  }
  result.push_back(work + "* const " + s.name + " = &" + own + ";");
  return result;
}

Lines Printer::declared(const Statement& s) const {
  if (s.type.name == "Work") return declared_work(s);
  const std::string head = (s.constant ? "const " : "") + type(s.type) + " " + s.name;
  return {s.values.empty() ? head + ";" : head + " = " + text(s.values[0]) + ";"};
}

std::string Printer::assigned(const Statement& s) const {
  std::string line;
  for (const Expression& each : s.values) {
    const bool is_object = each.kind == Expression::Kind::name && each.reach == Reach::reference;
    line += (line.empty() ? "" : " = ") + std::string(is_object ? "*" : "") + text(each);
  }
  return line + ";";
}

Lines Printer::nearest_root(const Statement& s) const {
  const std::string k = "k" + s.name, each = "each" + s.name, nearest = "nearest" + s.name,
                    least = "least" + s.name, index = "index" + s.name;
  const Expression w = ast::name("w", {"Work"}, Reach::reference);
  const auto copied = [&](const std::string& name) {
    return declared_work({Statement::Kind::declare, name, {"Work"}, {w}});
  };
  Lines result = copied(nearest);
  const auto add = [&](const Lines& more) { result.insert(result.end(), more.begin(), more.end()); };
  add({nearest + "->branch.exists = false;", "double " + least + " = 0;", "int " + index + " = 0;",
       "for (int " + k + " = 0; " + k + " < roots.count; ++" + k + ") {"});
  for (const std::string& line : copied(each)) result.push_back("  " + line);
  add({"  " + text(s.values[0]) + ";", "  const double apart = " + text(s.values[1]) + ";",
       "  if (!" + each + "->branch.exists || (" + nearest + "->branch.exists && !(apart < " + least +
           "))) continue;",
       "  *" + nearest + " = *" + each + ";", "  " + least + " = apart;", "  " + index + " = " + k + ";", "}",
       "forks->label = " + text(s.values[2]) + " * forks->label + " + index + ";", "*w = *" + nearest + ";"});
  return result;
}

Lines Printer::spelled(const Statement& s) const {
  using Kind = Statement::Kind;
  switch (s.kind) {
    case Kind::declare:
      return declared(s);
    case Kind::declare_array:
      return {type(s.type) + " " + s.name + "[" + text(s.values[0]) + "];"};
    case Kind::declare_row:
      return {"double " + s.name + "[row_size];"};
    case Kind::assign:
      return {assigned(s)};
    case Kind::take_nearer: {
      const auto branch = [](const Expression& work) {
        return ast::reference(ast::member(work, "branch", {"Branch"}));
      };
      const Expression forks = ast::name("forks", {"Forks"}, Reach::reference);
      const Expression takes = ast::method(
          forks, "takes_other", {branch(s.values[0]), s.values[1], branch(s.values[2]), s.values[3]});
      const Expression leaves = ast::method(forks, "leave_if_far", {branch(s.values[2])});
      const ast::Statement takes_it = ast::guard(takes, ast::assign(s.values[2], s.values[0]));
      return s.name.empty() ? lines({takes_it}) : lines({takes_it, ast::evaluate(leaves)});
    }
    case Kind::gap:
      return {};
    case Kind::nearest_root:
      return nearest_root(s);
    default:
      throw std::logic_error("C: a statement without a spelling");
  }
}

Lines Printer::body(const std::vector<std::string>& parameters, const ast::Statements& statements) const {
  Lines result;
  for (const std::string& each : parameters)
    if (!ast::mentions(statements, each)) result.push_back("(void)" + each + ";");
  for (const std::string& each : lines(statements)) result.push_back(each);
  return result;
}

std::string Printer::parameters(const ast::Function& function) const {
  std::string result;
  for (const auto& each : function.parameters) {
    const bool is_object = each.type.name == "Work" || each.type.name == "Target";
    result += (result.empty() ? "" : ", ") + std::string(is_object && !each.changed ? "const " : "") +
              type(each.type) + (is_object ? "* " : " ") + each.name;
  }
  return result;
}

Lines Printer::function(const ast::Function& function) const {
  if (function.role == ast::Function::Role::polish) return polish(function);
  Lines result;
  for (const std::string& each : function.comment) result.push_back("/// " + each);
  result.push_back("static " + type(function.result) + " " + prefix_ + function.name + "(" +
                   parameters(function) + ") {");
  std::vector<std::string> names;
  for (const auto& each : function.parameters) names.push_back(each.name);
  for (const std::string& each : body(names, function.body)) result.push_back("  " + each);
  result.emplace_back("}");
  return result;
}

const ast::Printer& printer() {
  static const Printer plain("");
  return plain;
}

}  // namespace qvgen::emit::c
