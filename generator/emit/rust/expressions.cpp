// SPDX-License-Identifier: MIT
// Values and places. Conversions that C makes by itself are written out: f64::from(i), i as f32, b != 0,
// i32::from(b).
#include <algorithm>
#include <map>

#include "emit/rust/names.h"
#include "emit/rust/writer.h"

namespace qvgen::emit::rust {

using blocks::Expression;
using blocks::Type;
using blocks::TypeRef;
using Kind = Expression::Kind;

namespace {

constexpr int atom = 20, unary_level = 12, cast_level = 11;

int level_of(const std::string& sign) {
  static const std::map<std::string, int> levels{
      {"*", 10}, {"/", 10}, {"%", 10}, {"+", 9}, {"-", 9}, {"<<", 8}, {">>", 8}, {"&", 7},  {"^", 6},
      {"|", 5},  {"==", 4}, {"!=", 4}, {"<", 4}, {">", 4}, {"<=", 4}, {">=", 4}, {"&&", 3}, {"||", 2}};
  return levels.at(sign);
}

/// True if a list has zeros alone.
bool is_zero(const Expression& e) {
  if (e.kind == Kind::list) return std::all_of(e.operands.begin(), e.operands.end(), is_zero);
  return (e.kind == Kind::integer && e.text == "0") || (e.kind == Kind::boolean && e.text == "false");
}

std::string basic_name(Type::Kind kind) {
  switch (kind) {
    case Type::Kind::integer:
      return "i32";
    case Type::Kind::natural:
      return "u32";
    case Type::Kind::boolean:
      return "bool";
    case Type::Kind::text:
      return "&str";
    default:
      return "()";
  }
}

}  // namespace

std::string type_text(const TypeRef& type, const Context& context) {
  if (type->kind == Type::Kind::real) return context.scalar.type;
  if (type->kind == Type::Kind::structure) return type_name(type->name, context.unit.robot);
  if (type->kind == Type::Kind::array)
    return "[" + type_text(type->of, context) + "; " + std::to_string(type->size) + "]";
  if (type->kind == Type::Kind::pointer)
    return type->of->kind == Type::Kind::text ? "&str" : type_text(type->of, context);
  return basic_name(type->kind);
}

std::string zero_text(const TypeRef& type, const std::string& robot) {
  switch (type->kind) {
    case Type::Kind::real:
      return "0.0";
    case Type::Kind::boolean:
      return "false";
    case Type::Kind::structure:
      return type_name(type->name, robot) + "::ZERO";
    case Type::Kind::array:
      return "[" + zero_text(type->of, robot) + "; " + std::to_string(type->size) + "]";
    case Type::Kind::pointer:
      return zero_text(type->of, robot);
    default:
      return "0";
  }
}

std::string parameter_text(const TypeRef& type, const blocks::Shape& shape, const Context& context) {
  if (type->kind != Type::Kind::pointer) return type_text(type, context);
  std::string text = shape.changed ? "&mut " : "&";
  const std::string element = type_text(type->of, context);
  if (!shape.many)
    text += element;
  else
    text += "[" + element + (shape.size > 0 ? "; " + std::to_string(shape.size) : "") + "]";
  return shape.optional ? "Option<" + text + ">" : text;
}

const Expression* FunctionWriter::alias(const Expression& e) const {
  if (e.kind != Kind::name || e.type->kind != Type::Kind::pointer) return nullptr;
  const auto known = aliases_.find(e.text);
  return known == aliases_.end() ? nullptr : &known->second;
}

bool FunctionWriter::is_optional(const Expression& e) const {
  if (e.kind != Kind::name) return false;
  if (const Expression* other = alias(e)) return is_optional(*other);
  const auto known = parameters_.find(e.text);
  return known != parameters_.end() && known->second.optional;
}

std::string FunctionWriter::index(const Expression& e) {
  const Expression& at = e.operands[1];
  if (at.kind == Kind::integer) return at.text;
  if (at.kind == Kind::name)
    if (const blocks::Constant* known = context_.unit.constant_of(at)) return known->value[0].text;
  const Text text = value(at);
  return (text.level > cast_level ? text.text : "(" + text.text + ")") + " as usize";
}

/// True if a pointer is a reference of its own, not another name of a place.
bool FunctionWriter::is_reference(const Expression& pointer) const {
  if (const Expression* other = alias(pointer)) return is_reference(*other);
  return pointer.kind == Kind::name;
}

/// The object that a pointer leads to.
std::string FunctionWriter::pointed_place(const Expression& pointer) {
  if (const Expression* other = alias(pointer)) return pointed_place(*other);
  if (pointer.kind == Kind::address) return place(pointer.operands[0]);
  if (is_optional(pointer)) return value_name(pointer.text) + ".unwrap()";
  return place(pointer);
}

std::string FunctionWriter::place(const Expression& e) {
  switch (e.kind) {
    case Kind::name:
      if (const Expression* other = alias(e)) return pointed_place(*other);
      if (is_optional(e)) return value_name(e.text) + ".unwrap()";
      return name(e).text;
    case Kind::member:
      if (e.operands[0].kind == Kind::call) return call(e.operands[0]) + "." + value_name(e.text);
      return place(e.operands[0]) + "." + value_name(e.text);
    case Kind::index:
      return place(e.operands[0]) + "[" + index(e) + "]";
    case Kind::dereference:
      return pointed_place(e.operands[0]);
    default: {
      const Text text = value(e);
      return text.level == atom ? text.text : "(" + text.text + ")";
    }
  }
}

FunctionWriter::Text FunctionWriter::name(const Expression& e) {
  static const std::map<std::string, std::string> numbers{
      {"DBL_EPSILON", "EPSILON"}, {"DBL_MAX", "MAX"},       {"DBL_MIN", "MIN_POSITIVE"},
      {"HUGE_VAL", "INFINITY"},   {"INFINITY", "INFINITY"}, {"NAN", "NAN"}};
  if (const auto known = numbers.find(e.text); known != numbers.end())
    return {context_.scalar.type + "::" + known->second, atom};
  if (context_.unit.constant_of(e) != nullptr) return {constant_name(e.text, robot_), atom};
  return {value_name(e.text), atom};
}

FunctionWriter::Text FunctionWriter::literal_as(const Expression& e, const TypeRef& wanted) {
  const bool is_real = wanted->kind == Type::Kind::real;
  return {is_real ? real_text(e.text) : e.text, atom};
}

/// A value of another type than the expression's, if need be.
std::string FunctionWriter::as(const Expression& e, const TypeRef& wanted) {
  const Type::Kind to = wanted->kind, from = e.type->kind;
  if (e.kind == Kind::integer)
    return to == Type::Kind::boolean ? (e.text == "0" ? "false" : "true") : literal_as(e, wanted).text;
  if (e.kind == Kind::conditional && to != from && blocks::is_number(wanted)) {
    return "if " + condition(e.operands[0]) + " { " + as(e.operands[1], wanted) + " } else { " +
           as(e.operands[2], wanted) + " }";
  }
  if (e.kind == Kind::negative && e.operands[0].kind == Kind::integer)
    return "-" + literal_as(e.operands[0], wanted).text;
  if (e.kind == Kind::list) return list(e);
  // A pointer that a struct keeps is a copy of what it leads to.
  if (to == Type::Kind::pointer && e.kind != Kind::text) return copied(e);
  if (to == from || !blocks::is_number(wanted)) return value(e).text;
  const std::string text = value(e).text;
  if (to == Type::Kind::boolean) return within(e, 5, e.type) + " != " + zero_text(e.type, robot_);
  if (to == Type::Kind::real && from == Type::Kind::boolean)
    return context_.scalar.type + "::from(u8::from(" + text + "))";
  if (to == Type::Kind::real && context_.scalar.holds_integers)
    return context_.scalar.type + "::from(" + text + ")";
  if (from == Type::Kind::boolean)
    return (to == Type::Kind::natural ? "u32" : "i32") + ("::from(" + text + ")");
  return within(e, cast_level, e.type) + " as " + type_text(wanted, context_);
}

/// Value of the wanted type, in brackets where it binds less than `level`.
std::string FunctionWriter::within(const Expression& e, int level, const TypeRef& wanted) {
  if (wanted->kind != e.type->kind && blocks::is_number(wanted)) {
    const std::string text = as(e, wanted);
    const bool is_literal = e.kind == Kind::integer;
    const bool is_atom = is_literal || text.rfind(context_.scalar.type + "::from(", 0) == 0 ||
                         text.rfind("i32::from(", 0) == 0;
    return is_atom ? text : "(" + text + ")";
  }
  const Text text = value(e);
  return text.level >= level ? text.text : "(" + text.text + ")";
}

FunctionWriter::Text FunctionWriter::binary(const Expression& e) {
  const Expression &a = e.operands[0], &b = e.operands[1];
  for (const auto& [pointer, other] : {std::pair{&a, &b}, {&b, &a}})
    if (other->kind == Kind::null) {
      if (!is_optional(*pointer)) return {e.text == "==" ? "false" : "true", atom};
      return {value_name(pointer->text) + (e.text == "==" ? ".is_none()" : ".is_some()"), atom};
    }
  const int level = level_of(e.text);
  const bool is_logic = e.text == "&&" || e.text == "||";
  const bool is_shift = e.text == "<<" || e.text == ">>";
  const bool both_truths = a.type->kind == Type::Kind::boolean && b.type->kind == Type::Kind::boolean;
  const TypeRef wanted =
      is_logic || both_truths ? blocks::basic(Type::Kind::boolean) : blocks::common(a.type, b.type);
  const int left = level == 4 ? 5 : level;
  // "a as u32 < b" would begin type arguments; a cast has brackets on the left.
  const std::string first = within(a, left, is_shift ? a.type : wanted);
  return {first + " " + e.text + " " + within(b, level + 1, is_shift ? b.type : wanted), level};
}

FunctionWriter::Text FunctionWriter::value(const Expression& e) {
  const auto inner = [&](int level) { return within(e.operands[0], level, e.type); };
  switch (e.kind) {
    case Kind::real:
      return {real_text(e.text), atom};
    case Kind::integer:
      return literal_as(e, e.type);
    case Kind::boolean:
    case Kind::text:
      return {e.text, atom};
    case Kind::null:
      return {"None", atom};
    case Kind::negative:
      return {inner(unary_level)[0] == '-' ? "-(" + inner(unary_level) + ")" : "-" + inner(unary_level),
              unary_level};
    case Kind::complement:
      return {"!" + inner(unary_level), unary_level};
    case Kind::is_not:
      return {"!" + within(e.operands[0], unary_level, blocks::basic(Type::Kind::boolean)), unary_level};
    case Kind::dereference:
      return is_reference(e.operands[0]) ? Text{"*" + place(e), unary_level} : Text{place(e), atom};
    case Kind::binary:
      return binary(e);
    case Kind::conditional:
      return {"if " + condition(e.operands[0]) + " { " + as(e.operands[1], e.type) + " } else { " +
                  as(e.operands[2], e.type) + " }",
              0};
    case Kind::call:
      return {call(e), atom};
    case Kind::cast:
      if (e.type->kind == Type::Kind::integer && e.operands[0].type->kind == Type::Kind::real)
        return {within(e.operands[0], cast_level, e.operands[0].type) + " as i32", cast_level};
      return {within(e.operands[0], atom, e.type), atom};
    case Kind::list:
      return {list(e), atom};
    case Kind::name:
    case Kind::member:
    case Kind::index:
      return {place(e), atom};
    default:
      throw blocks::NotInSubset(function_.name + ": an expression that Rust has no text for");
  }
}

std::string FunctionWriter::structure_list(const Expression& e) {
  const auto& fields = context_.unit.structures.at(e.type->name).fields;
  std::string text;
  std::size_t given = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Expression* of_field = nullptr;
    for (const Expression& each : e.operands)
      if (each.kind == Kind::designated && each.text == fields[i].name) of_field = &each.operands[0];
    if (of_field == nullptr && i < e.operands.size() && e.operands[i].kind != Kind::designated)
      of_field = &e.operands[i];
    if (fields[i].type->kind == Type::Kind::text) continue;
    if (of_field == nullptr) continue;
    ++given;
    const std::string field = value_name(fields[i].name), own = as(*of_field, fields[i].type);
    text += (text.empty() ? "" : ", ") + (field == own ? field : field + ": " + own);
  }
  const std::string type = type_text(e.type, context_);
  if (text.empty()) return type + "::ZERO";
  return type + " { " + text + (given == fields.size() ? " }" : ", .." + type + "::ZERO }");
}

std::string FunctionWriter::list(const Expression& e) {
  if (e.type->kind == Type::Kind::structure) return structure_list(e);
  const auto size = static_cast<std::size_t>(e.type->size);
  if (is_zero(e)) return zero_text(e.type, robot_);
  std::string text;
  for (std::size_t i = 0; i < size; ++i)
    text += (i == 0 ? "" : ", ") +
            (i < e.operands.size() ? as(e.operands[i], e.type->of) : zero_text(e.type->of, robot_));
  return "[" + text + "]";
}

}  // namespace qvgen::emit::rust
