// SPDX-License-Identifier: MIT
#include "emit/octave/straight.h"

#include <algorithm>
#include <map>
#include <set>

#include "emit/blocks/types.h"

namespace qvgen::emit::octave {
namespace {

using blocks::Expression;
using blocks::Statement;
using blocks::Type;
using Kind = Expression::Kind;
using Lines = std::vector<std::string>;

/// Thrown for what is no list of assignments.
struct NotStraight {};

constexpr int atom = 9, unary = 5, product = 4, sum = 3;

/// A text and how strongly it binds.
struct Text {
  std::string text;
  int level;
};

bool is_literal(const Expression& e) { return e.kind == Kind::real || e.kind == Kind::integer; }

bool is_number_of(const Expression& e, double value) {
  if (e.kind == Kind::negative) return is_number_of(e.operands[0], -value);
  return is_literal(e) && std::stod(e.text) == value;
}

/// The place that an expression reads or writes: the root's name and the indices and fields behind it.
struct Place {
  std::string root, fields;
  std::vector<std::string> indices;
};

Place place_of(const Expression& e) {
  switch (e.kind) {
    case Kind::name:
      return {e.text, "", {}};
    case Kind::dereference:
    case Kind::address:
      return place_of(e.operands[0]);
    case Kind::member: {
      Place place = place_of(e.operands[0]);
      if (!place.indices.empty()) throw NotStraight{};
      place.fields += "." + e.text;
      return place;
    }
    case Kind::index: {
      Place place = place_of(e.operands[0]);
      if (e.operands[1].kind != Kind::integer) throw NotStraight{};
      place.indices.push_back(e.operands[1].text);
      return place;
    }
    default:
      throw NotStraight{};
  }
}

/// The function whose sign is asked for by x > 0 ? 1 : x < 0 ? -1 : 0; nothing for other choices.
const Expression* asks_sign(const Expression& e) {
  const auto compares = [](const Expression& test, const char* sign) {
    return test.kind == Kind::binary && test.text == sign && is_number_of(test.operands[1], 0);
  };
  if (e.kind != Kind::conditional || !compares(e.operands[0], ">") || !is_number_of(e.operands[1], 1))
    return nullptr;
  const Expression& other = e.operands[2];
  if (other.kind != Kind::conditional || !compares(other.operands[0], "<") ||
      !is_number_of(other.operands[1], -1) || !is_number_of(other.operands[2], 0))
    return nullptr;
  return &e.operands[0].operands[0];
}

class BodyWriter {
 public:
  BodyWriter(const blocks::Unit& unit, const Signature& signature) : unit_(unit), signature_(signature) {
    for (const Output& each : signature.outputs) outputs_[each.place] = &each;
  }

  Lines lines() {
    for (const Output& each : signature_.outputs)
      lines_.push_back(value_name(each.name) + " = zeros(" + sizes(each) + ", n_columns);");
    write(signature_.function->body, 0);
    return std::move(lines_);
  }

 private:
  static std::string sizes(const Output& output) {
    if (output.sizes.empty()) return "1";
    std::string text;
    for (const int size : output.sizes) text += (text.empty() ? "" : ", ") + std::to_string(size);
    return text;
  }

  void write(const blocks::Statements& statements, int depth) {
    for (const Statement& each : statements) write(each, depth);
  }

  void write(const Statement& s, int depth) {
    for (const std::string& each : s.comment) lines_.push_back("% " + each);
    switch (s.kind) {
      case Statement::Kind::declare:
        return declare(s, depth);
      case Statement::Kind::evaluate:
        return evaluate(s.values[0]);
      case Statement::Kind::block:
        return write(s.body, depth + 1);
      case Statement::Kind::give:
        if (!s.values.empty()) lines_.push_back("result(1, :) = " + value(s.values[0]).text + ";");
        return;
      case Statement::Kind::nothing:
        return;
      default:
        throw NotStraight{};
    }
  }

  /// A name in a block that the function has had is another variable in C, and would be the same here.
  void declare(const Statement& s, int depth) {
    if (depth == 0) names_.insert(s.name);
    if (depth > 0 && names_.count(s.name) > 0) throw NotStraight{};
    if (s.type->kind == Type::Kind::array && s.values.empty()) return;
    if (s.type->kind != Type::Kind::real || s.values.empty()) throw NotStraight{};
    lines_.push_back(value_name(s.name) + " = " + value(s.values[0]).text + ";");
  }

  void evaluate(const Expression& whole) {
    const Expression& e = whole.kind == Kind::cast ? whole.operands[0] : whole;
    if (e.kind == Kind::name) return;  // (void)g
    if (e.kind != Kind::assign || e.text != "=") throw NotStraight{};
    const Expression& from = e.operands[1];
    const bool is_chain = from.kind == Kind::assign;
    if (is_chain) evaluate(from);
    lines_.push_back(place(e.operands[0]) + " = " + (is_chain ? place(from.operands[0]) : value(from).text) +
                     ";");
  }

  std::string place(const Expression& e) const {
    const Place place = place_of(e);
    std::string indices;
    for (const std::string& each : place.indices) indices += std::to_string(std::stoi(each) + 1) + ", ";
    if (const auto found = outputs_.find(place.root + place.fields); found != outputs_.end())
      return value_name(found->second->name) + "(" + (indices.empty() ? "1, " : indices) + ":)";
    const auto input = std::find_if(signature_.inputs.begin(), signature_.inputs.end(),
                                    [&](const Input& each) { return each.name == place.root; });
    if (input != signature_.inputs.end()) {
      if (input->kind == Input::Kind::row) return value_name(place.root) + "(" + indices + ":)";
      return value_name(place.root) + place.fields;
    }
    if (!place.fields.empty()) throw NotStraight{};
    std::string name = value_name(place.root);
    for (const std::string& each : place.indices) name += (&each == &place.indices[0] ? "" : "_") + each;
    return name;
  }

  Text value(const Expression& e) const {
    switch (e.kind) {
      case Kind::real:
      case Kind::integer:
        return {e.text, atom};
      case Kind::negative:
        return {"-" + within(e.operands[0], unary), unary};
      case Kind::binary:
        return binary(e);
      case Kind::conditional:
        if (const Expression* of = asks_sign(e)) return {"sign(" + value(*of).text + ")", atom};
        throw NotStraight{};
      case Kind::call:
        return {call(e), atom};
      case Kind::name:
        if (unit_.constant_of(e) != nullptr) throw NotStraight{};
        return {place(e), atom};
      default:
        return {place(e), atom};
    }
  }

  std::string within(const Expression& e, int level) const {
    const Text text = value(e);
    return text.level >= level && text.text[0] != '-' ? text.text : "(" + text.text + ")";
  }

  Text binary(const Expression& e) const {
    const Expression &a = e.operands[0], &b = e.operands[1];
    const bool is_sum = e.text == "+" || e.text == "-";
    if (!is_sum && e.text != "*" && e.text != "/") throw NotStraight{};
    const bool has_number = is_literal(b) || (e.text == "*" && is_literal(a));
    const std::string sign = is_sum || has_number ? e.text : "." + e.text;
    const int level = is_sum ? sum : product;
    const Text left = value(a);
    return {
        (left.level >= level ? left.text : "(" + left.text + ")") + " " + sign + " " + within(b, level + 1),
        level};
  }

  std::string call(const Expression& e) const {
    static const std::map<std::string, std::string> known{{"sin", "sin"},     {"cos", "cos"},
                                                          {"sqrt", "sqrt"},   {"fabs", "abs"},
                                                          {"atan2", "atan2"}, {"tan", "tan"}};
    const auto name = known.find(e.text);
    if (name == known.end()) throw NotStraight{};
    std::string list;
    for (const Expression& each : e.operands) list += (list.empty() ? "" : ", ") + value(each).text;
    return name->second + "(" + list + ")";
  }

  const blocks::Unit& unit_;
  const Signature& signature_;
  std::map<std::string, const Output*> outputs_;
  std::set<std::string> names_;
  Lines lines_;
};

}  // namespace

std::optional<Lines> straight_body(const blocks::Unit& unit, const Signature& signature) {
  try {
    return BodyWriter(unit, signature).lines();
  } catch (const NotStraight&) {
    return std::nullopt;
  }
}

std::string constant_text(const blocks::Unit& unit, const Expression& e) {
  static const std::map<std::string, std::string> numbers{
      {"HUGE_VAL", "Inf"}, {"INFINITY", "Inf"}, {"NAN", "NaN"}, {"DBL_EPSILON", "eps"}};
  switch (e.kind) {
    case Kind::negative:
      return "-" + constant_text(unit, e.operands[0]);
    case Kind::text:
      return "'" + e.text.substr(1, e.text.size() - 2) + "'";
    case Kind::name:
      if (const auto known = numbers.find(e.text); known != numbers.end()) return known->second;
      if (const blocks::Constant* other = unit.constant_of(e)) return constant_text(unit, other->value.at(0));
      throw blocks::NotInSubset(e.text + ": a constant that Octave has no text for");
    case Kind::list: {
      std::string list;
      const bool has_texts = !e.operands.empty() && e.operands[0].kind == Kind::text;
      for (const Expression& each : e.operands)
        list += (list.empty() ? "" : "; ") + constant_text(unit, each);
      return (has_texts ? "{" : "[") + list + (has_texts ? "}" : "]");
    }
    case Kind::real:
    case Kind::integer:
      return e.text;
    default:
      throw blocks::NotInSubset("a constant that Octave has no text for");
  }
}

std::string value_name(const std::string& name) {
  static const std::set<std::string> words{"end",       "function", "global", "persistent",
                                           "otherwise", "until",    "catch",  "try",
                                           "endif",     "endfor",   "parfor", "classdef"};
  return words.count(name) > 0 || name[0] == '_' ? "v_" + name : name;
}

}  // namespace qvgen::emit::octave
