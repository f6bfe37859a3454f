// SPDX-License-Identifier: MIT
#include "outline.h"

#include <array>

namespace qvgen::test {

using namespace emit::ast;

namespace {

constexpr std::array expressions{"nothing",  "real",          "literal",  "name",     "member",
                                 "entry",    "convert",       "negative", "sum",      "product",
                                 "quotient", "grouped",       "compare",  "is_not",   "condition",
                                 "sign",     "sign_of_round", "rotor",    "turned",   "scaled",
                                 "inverse",  "angle",         "pair",     "make",     "direction",
                                 "pi",       "reference",     "usual",    "block",    "direction_block",
                                 "runtime",  "method",        "own",      "polishes", "polishes_seed",
                                 "function", "mathematical",  "named"};
constexpr std::array statements_of_tree{
    "declare",    "declare_array", "declare_row", "assign", "evaluate", "guard",       "choose",      "loop",
    "leave_loop", "next_round",    "give",        "scope",  "gap",      "take_nearer", "nearest_root"};

template <class Names, class Kind>
std::string name_of(const Names& names, Kind kind) {
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace

std::string Outline::text(const Expression& e) const {
  std::string result = "(" + name_of(expressions, e.kind) + (e.text.empty() ? "" : " " + e.text);
  for (const Expression& operand : e.operands) result += " " + text(operand);
  return result + ")";
}

Lines Outline::lines(const Statements& statements, int depth) const {
  Lines result;
  for (const Statement& s : statements) {
    std::string line =
        std::string(static_cast<std::size_t>(2 * depth), ' ') + name_of(statements_of_tree, s.kind);
    for (const std::string& word : {s.type.name, s.name})
      if (!word.empty()) line += " " + word;
    for (const Expression& value : s.values) line += " " + text(value);
    result.push_back(line);
    for (const std::string& each : lines(s.body, depth + 1)) result.push_back(each);
  }
  return result;
}

Lines Outline::function(const Function& function) const {
  std::string head = "function " + function.name;
  for (const Function::Parameter& each : function.parameters) head += " " + each.type.name + " " + each.name;
  Lines result{head};
  for (const std::string& each : lines(function.body, 1)) result.push_back(each);
  for (const std::string& each : lines(function.task.back, 1)) result.push_back(each);
  return result;
}

}  // namespace qvgen::test
