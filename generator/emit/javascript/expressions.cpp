// SPDX-License-Identifier: MIT
// Values and places. A struct or array that is copied in C is copied here; numbers are what they are.
#include <algorithm>
#include <map>

#include "emit/javascript/names.h"
#include "emit/javascript/writer.h"
#include "emit/rust/names.h"

namespace qvgen::emit::javascript {

using blocks::Expression;
using blocks::Shape;
using blocks::Type;
using blocks::TypeRef;
using Kind = Expression::Kind;

namespace {

constexpr int atom = 20, unary_level = 14;

int level_of(const std::string& sign) {
  static const std::map<std::string, int> levels{
      {"*", 12}, {"/", 12}, {"%", 12}, {"+", 11}, {"-", 11}, {"<<", 10}, {">>", 10}, {"<", 9},  {">", 9},
      {"<=", 9}, {">=", 9}, {"==", 8}, {"!=", 8}, {"&", 7},  {"^", 6},   {"|", 5},   {"&&", 4}, {"||", 3}};
  return levels.at(sign);
}

bool is_object(const TypeRef& type) {
  return type->kind == Type::Kind::structure || type->kind == Type::Kind::array;
}

bool is_zero(const Expression& e) {
  if (e.kind == Kind::list) return std::all_of(e.operands.begin(), e.operands.end(), is_zero);
  return (e.kind == Kind::integer && e.text == "0") || (e.kind == Kind::boolean && e.text == "false");
}

/// Functions of <math.h>: those of Math, and those that the module has itself.
std::string library_name(const std::string& name) {
  static const std::map<std::string, std::string> others{
      {"fabs", "Math.abs"},   {"fmax", "Math.max"},      {"fmin", "Math.min"},
      {"rint", "rint"},       {"round", "round"},        {"copysign", "copysign"},
      {"signbit", "signbit"}, {"isnan", "Number.isNaN"}, {"isfinite", "Number.isFinite"}};
  const auto known = others.find(name);
  return known == others.end() ? "Math." + name : known->second;
}

}  // namespace

std::string zero_text(const blocks::Unit& unit, const TypeRef& type) {
  const std::string size = std::to_string(type->size);
  switch (type->kind) {
    case Type::Kind::boolean:
      return "false";
    case Type::Kind::structure:
      return "zero" + type_name(unit, type->name) + "()";
    case Type::Kind::pointer:
      return "null";
    case Type::Kind::array:
      if (type->of->kind == Type::Kind::real) return "new Float64Array(" + size + ")";
      if (type->of->kind == Type::Kind::integer) return "new Int32Array(" + size + ")";
      return "Array.from({ length: " + size + " }, () => " + zero_text(unit, type->of) + ")";
    default:
      return "0";
  }
}

const Expression* FunctionWriter::alias(const Expression& e) const {
  if (e.kind != Kind::name || e.type->kind != Type::Kind::pointer) return nullptr;
  const auto known = aliases_.find(e.text);
  return known == aliases_.end() ? nullptr : &known->second;
}

std::string FunctionWriter::name(const Expression& e) {
  static const std::map<std::string, std::string> numbers{{"DBL_EPSILON", "Number.EPSILON"},
                                                          {"DBL_MAX", "Number.MAX_VALUE"},
                                                          {"DBL_MIN", "2.2250738585072014e-308"},
                                                          {"HUGE_VAL", "Infinity"},
                                                          {"INFINITY", "Infinity"},
                                                          {"NAN", "NaN"}};
  if (const auto known = numbers.find(e.text); known != numbers.end()) return known->second;
  if (const blocks::Constant* known = context_.unit.constant_of(e))
    return constant_name(context_.unit, *known);
  return local(e.text);
}

std::string FunctionWriter::place(const Expression& e) {
  switch (e.kind) {
    case Kind::name:
      if (const Expression* other = alias(e)) return place(*other);
      return name(e);
    case Kind::member: {
      const blocks::Structure& structure = context_.unit.structures.at(e.operands[0].type->name);
      return place(e.operands[0]) + "." + field_name(structure, e.text);
    }
    case Kind::index:
      return place(e.operands[0]) + "[" + value(e.operands[1]).text + "]";
    case Kind::address:
      return place(e.operands[0]);
    case Kind::dereference: {
      const Expression& pointer = e.operands[0];
      if (const Expression* other = alias(pointer)) return place({Kind::dereference, "", {*other}, e.type});
      if (pointer.kind == Kind::address) return place(pointer.operands[0]);
      return place(pointer) + (blocks::is_number(e.type) ? ".v" : "");
    }
    default: {
      const Text text = value(e);
      return text.level == atom ? text.text : "(" + text.text + ")";
    }
  }
}

std::string FunctionWriter::as(const Expression& e, const TypeRef& wanted) {
  const Type::Kind to = wanted->kind, from = e.type->kind;
  if (e.kind == Kind::integer && to == Type::Kind::boolean) return e.text == "0" ? "false" : "true";
  if (is_object(wanted)) return fresh(e);
  if (from == Type::Kind::boolean && to != from && blocks::is_number(wanted)) {
    if (e.kind == Kind::conditional)
      return within(e.operands[0], 3, e.operands[0].type) + " ? " + as(e.operands[1], wanted) + " : " +
             as(e.operands[2], wanted);
    return "Number(" + value(e).text + ")";
  }
  if (to == Type::Kind::boolean && from != to && blocks::is_number(e.type))
    return within(e, 9, e.type) + " !== 0";
  return value(e).text;
}

/// An object that nobody else has.
std::string FunctionWriter::fresh(const Expression& e) {
  if (e.kind == Kind::call) return call(e);
  if (e.kind == Kind::list) return list(e);
  if (e.kind == Kind::conditional)
    return within(e.operands[0], 3, blocks::basic(Type::Kind::boolean)) + " ? " + fresh(e.operands[1]) +
           " : " + fresh(e.operands[2]);
  if (e.type->kind == Type::Kind::structure)
    return "copy" + type_name(context_.unit, e.type->name) + "(" + place(e) + ")";
  return "copyOf(" + place(e) + ")";
}

std::string FunctionWriter::within(const Expression& e, int level, const TypeRef& wanted) {
  const bool converts = blocks::is_number(wanted) && wanted->kind != e.type->kind &&
                        (wanted->kind == Type::Kind::boolean || e.type->kind == Type::Kind::boolean);
  if (converts) {
    const std::string text = as(e, wanted);
    return text.rfind("Number(", 0) == 0 || e.kind == Kind::integer ? text : "(" + text + ")";
  }
  const Text text = value(e);
  return text.level >= level ? text.text : "(" + text.text + ")";
}

FunctionWriter::Text FunctionWriter::binary(const Expression& e) {
  const Expression &a = e.operands[0], &b = e.operands[1];
  if (a.kind == Kind::null || b.kind == Kind::null)
    return {place(a.kind == Kind::null ? b : a) + " " + e.text + " null", level_of(e.text)};
  if (e.type->kind == Type::Kind::pointer || e.type->kind == Type::Kind::array)
    return {"behind(" + place(a) + ", " + value(b).text + ")", atom};
  const int level = level_of(e.text);
  const bool is_logic = e.text == "&&" || e.text == "||";
  const bool both_truths = a.type->kind == Type::Kind::boolean && b.type->kind == Type::Kind::boolean;
  const TypeRef wanted =
      is_logic || both_truths ? blocks::basic(Type::Kind::boolean) : blocks::common(a.type, b.type);
  const std::string sign = e.text == "==" ? "===" : e.text == "!=" ? "!==" : e.text;
  if (e.text == "/" && wanted->kind != Type::Kind::real)
    return {"Math.trunc(" + within(a, level, wanted) + " / " + within(b, level + 1, wanted) + ")", atom};
  // JavaScript allows no || beside && without brackets only for ??; these are as in C.
  return {within(a, level, wanted) + " " + sign + " " + within(b, level + 1, wanted), level};
}

FunctionWriter::Text FunctionWriter::value(const Expression& e) {
  switch (e.kind) {
    case Kind::real: {
      const std::string text = rust::real_text(e.text);
      return {text.ends_with(".0") ? text.substr(0, text.size() - 2) : text, atom};
    }
    case Kind::integer:
    case Kind::boolean:
    case Kind::text:
      return {e.text, atom};
    case Kind::null:
      return {"null", atom};
    case Kind::negative: {
      const std::string inner = within(e.operands[0], unary_level, e.type);
      return {"-" + (inner[0] == '-' ? "(" + inner + ")" : inner), unary_level};
    }
    case Kind::complement:
      return {"~" + within(e.operands[0], unary_level, e.type), unary_level};
    case Kind::is_not:
      return {"!" + within(e.operands[0], unary_level, blocks::basic(Type::Kind::boolean)), unary_level};
    case Kind::binary:
      return binary(e);
    case Kind::conditional:
      return {within(e.operands[0], 3, blocks::basic(Type::Kind::boolean)) + " ? " +
                  as(e.operands[1], e.type) + " : " + as(e.operands[2], e.type),
              2};
    case Kind::before:
      return {e.text + place(e.operands[0]), unary_level};
    case Kind::after:
      return {place(e.operands[0]) + e.text, unary_level};
    case Kind::call:
      return {call(e), atom};
    case Kind::cast:
      if (e.type->kind == Type::Kind::integer && e.operands[0].type->kind == Type::Kind::real)
        return {"Math.trunc(" + value(e.operands[0]).text + ")", atom};
      return value(e.operands[0]);
    case Kind::list:
      return {list(e), atom};
    case Kind::name:
    case Kind::member:
    case Kind::index:
    case Kind::address:
    case Kind::dereference:
      return {place(e), atom};
    default:
      throw blocks::NotInSubset(function_.name + ": an expression that JavaScript has no text for");
  }
}

std::string FunctionWriter::list(const Expression& e) {
  if (is_zero(e)) return zero_text(context_.unit, e.type);
  std::string text;
  if (e.type->kind == Type::Kind::structure) {
    const blocks::Structure& structure = context_.unit.structures.at(e.type->name);
    for (std::size_t i = 0; i < structure.fields.size(); ++i) {
      const blocks::Field& field = structure.fields[i];
      if (field.type->kind == Type::Kind::text) continue;
      const Expression* given = nullptr;
      for (const Expression& each : e.operands)
        if (each.kind == Kind::designated && each.text == field.name) given = &each.operands[0];
      if (given == nullptr && i < e.operands.size() && e.operands[i].kind != Kind::designated)
        given = &e.operands[i];
      text += (text.empty() ? " " : ", ") + field_name(structure, field.name) + ": " +
              (given != nullptr ? as(*given, field.type) : zero_text(context_.unit, field.type));
    }
    return "{" + text + " }";
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.type->size); ++i)
    text += (i == 0 ? "" : ", ") +
            (i < e.operands.size() ? as(e.operands[i], e.type->of) : zero_text(context_.unit, e.type->of));
  const bool is_real = e.type->of->kind == Type::Kind::real;
  return is_real ? "Float64Array.of(" + text + ")" : "[" + text + "]";
}

/// An object whose member v is the number that a pointer leads to.
std::string FunctionWriter::box(const Expression& pointer) {
  if (const Expression* other = alias(pointer)) return box(*other);
  if (pointer.kind != Kind::address) return place(pointer);
  const std::string at = place(pointer.operands[0]);
  return "{ get v() { return " + at + "; }, set v(x) { " + at + " = x; } }";
}

std::string FunctionWriter::argument(const Expression& e, const TypeRef& wanted, const Shape& shape) {
  if (wanted->kind != Type::Kind::pointer) return is_object(wanted) ? place(e) : as(e, wanted);
  if (e.kind == Kind::null) return "null";
  if (e.kind == Kind::conditional)
    return within(e.operands[0], 3, blocks::basic(Type::Kind::boolean)) + " ? " +
           argument(e.operands[1], wanted, shape) + " : " + argument(e.operands[2], wanted, shape);
  if (!shape.many && blocks::is_scalar_pointer(wanted)) return box(e);
  // One object where an array is wanted is an array of one.
  if (shape.many && e.kind == Kind::address && e.operands[0].type->kind == Type::Kind::structure)
    return "[" + place(e) + "]";
  return place(e);
}

std::string FunctionWriter::call(const Expression& e) {
  const blocks::Function* callee = context_.unit.function(e.text);
  std::string list;
  if (callee == nullptr) {
    for (const Expression& each : e.operands)
      list += (list.empty() ? "" : ", ") + as(each, blocks::basic(Type::Kind::real));
    return library_name(e.text) + "(" + list + ")";
  }
  const std::vector<Shape>& shapes = context_.shapes.of(e.text);
  const std::size_t count = e.operands.size() - (blocks::returns_last(*callee) ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i)
    list += (i == 0 ? "" : ", ") + argument(e.operands[i], callee->parameters[i].type, shapes[i]);
  return function_name(context_.unit, *callee) + "(" + list + ")";
}

}  // namespace qvgen::emit::javascript
