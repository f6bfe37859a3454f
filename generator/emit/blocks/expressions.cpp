// SPDX-License-Identifier: MIT
// Expressions by precedence, each with its type.
#include <algorithm>
#include <map>
#include <utility>

#include "emit/blocks/parser.h"

namespace qvgen::emit::blocks {

using Kind = Expression::Kind;

int precedence(const std::string& sign) {
  static const std::map<std::string, int> all{
      {"||", 1}, {"&&", 2}, {"|", 3},  {"^", 4},  {"&", 5}, {"==", 6}, {"!=", 6}, {"<", 7},  {">", 7},
      {"<=", 7}, {">=", 7}, {"<<", 8}, {">>", 8}, {"+", 9}, {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10}};
  const auto known = all.find(sign);
  return known == all.end() ? 0 : known->second;
}

namespace {

bool is_truth(const std::string& sign) {
  return precedence(sign) <= 2 || (precedence(sign) >= 6 && precedence(sign) <= 7);
}

/// Kind of value that a function of the C library returns: a real one unless it is listed.
Type::Kind result_of_library(const std::string& name) {
  if (name == "isnan" || name == "isfinite" || name == "signbit") return Type::Kind::boolean;
  return name == "memcpy" || name == "memset" ? Type::Kind::nothing : Type::Kind::real;
}

}  // namespace

bool is_of_library(const std::string& name) {
  for (const char* each : {"sin",      "cos",   "tan",   "asin",     "acos",    "atan",   "atan2", "sqrt",
                           "cbrt",     "fabs",  "fmax",  "fmin",     "rint",    "floor",  "ceil",  "trunc",
                           "copysign", "round", "isnan", "isfinite", "signbit", "memcpy", "memset"})
    if (name == each) return true;
  return false;
}

Expression Parser::made(Kind kind, const std::string& text, Expressions operands, TypeRef type) const {
  return {kind, text, std::move(operands), std::move(type), peek().line};
}

bool Parser::is_local(const std::string& name) const {
  return std::any_of(locals_.begin(), locals_.end(),
                     [&](const auto& scope) { return scope.count(name) > 0; });
}

TypeRef Parser::type_of(const std::string& name) const {
  for (std::size_t i = locals_.size(); i-- > 0;)
    if (const auto known = locals_[i].find(name); known != locals_[i].end()) return known->second;
  if (const Constant* constant = scope_.unit.constant(name)) return constant->type;
  static const std::map<std::string, Type::Kind> numbers{
      {"DBL_EPSILON", Type::Kind::real}, {"DBL_MAX", Type::Kind::real},  {"DBL_MIN", Type::Kind::real},
      {"HUGE_VAL", Type::Kind::real},    {"INFINITY", Type::Kind::real}, {"NAN", Type::Kind::real}};
  if (const auto known = numbers.find(name); known != numbers.end()) return basic(known->second);
  fail("\"" + name + "\" is not declared");
}

Expression Parser::expression() {
  Expression left = conditional();
  for (const char* sign : {"=", "+=", "-=", "*=", "/=", "|=", "&="})
    if (is(sign)) {
      take();
      Expression right = is("{") ? listed(left.type) : expression();
      TypeRef type = left.type;
      return made(Kind::assign, sign, {std::move(left), std::move(right)}, type);
    }
  return left;
}

Expression Parser::conditional() {
  Expression condition = binary(1);
  if (!accept("?")) return condition;
  Expression yes = conditional();
  expect(":");
  Expression no = conditional();
  TypeRef type = yes.kind == Kind::null ? no.type
                 : is_number(yes.type)  ? common(yes.type, no.type)
                                        : yes.type;
  if (yes.type && no.type && yes.type->kind == Type::Kind::boolean && no.type->kind == Type::Kind::boolean)
    type = yes.type;
  return made(Kind::conditional, "", {std::move(condition), std::move(yes), std::move(no)}, type);
}

Expression Parser::binary(int least) {
  Expression left = unary();
  for (;;) {
    const std::string sign = peek().kind == Token::Kind::sign ? peek().text : "";
    const int own = precedence(sign);
    if (own == 0 || own < least) return left;
    take();
    Expression right = binary(own + 1);
    left = combined(sign, std::move(left), std::move(right));
  }
}

Expression Parser::combined(const std::string& sign, Expression left, Expression right) const {
  TypeRef type = is_truth(sign)                 ? basic(Type::Kind::boolean)
                 : sign == "<<" || sign == ">>" ? left.type
                                                : common(left.type, right.type);
  return made(Kind::binary, sign, {std::move(left), std::move(right)}, type);
}

Expression Parser::unary() {
  const TypeRef truth = basic(Type::Kind::boolean);
  if (accept("!")) return made(Kind::is_not, "", {unary()}, truth);
  for (const auto& [sign, kind] :
       {std::pair{"-", Kind::negative}, {"~", Kind::complement}, {"++", Kind::before}, {"--", Kind::before}})
    if (is(sign)) {
      take();
      Expression value = unary();
      TypeRef type = value.type->kind == Type::Kind::boolean ? basic(Type::Kind::integer) : value.type;
      return made(kind, sign, {std::move(value)}, type);
    }
  if (accept("*")) {
    Expression value = unary();
    TypeRef type = value.type->of;
    if (!type) fail("* of what is no pointer");
    return made(Kind::dereference, "", {std::move(value)}, type);
  }
  if (accept("&")) {
    Expression place = unary();
    TypeRef type = pointer_to(place.type, false);
    return made(Kind::address, "", {std::move(place)}, type);
  }
  if (is("sizeof")) return size_of();
  return is("(") ? cast_or_brackets() : postfix();
}

Expression Parser::size_of() {
  expect("sizeof");
  const TypeRef whole = basic(Type::Kind::integer);
  if (is("(") && begins_type(1)) {
    take();
    const TypeRef type = declarator_free_type();
    expect(")");
    return made(Kind::size_of, "", {made(Kind::name, "", {}, type)}, whole);
  }
  return made(Kind::size_of, "", {unary()}, whole);
}

/// A cast `(int)x`, or brackets.
Expression Parser::cast_or_brackets() {
  if (!begins_type(1)) return postfix();
  expect("(");
  const TypeRef type = declarator_free_type();
  expect(")");
  if (is("{")) return listed(type);
  return made(Kind::cast, "", {unary()}, type);
}

TypeRef Parser::declarator_free_type() {
  Specifiers all = specifiers();
  TypeRef type = all.type;
  while (accept("*")) type = pointer_to(type, all.constant);
  if (is("(")) fail("casts of arrays are not in the subset");
  return type;
}

Expression Parser::postfix() {
  if (accept("(")) {
    Expression inner = expression();
    expect(")");
    return behind(std::move(inner));
  }
  return behind(primary());
}

Expression Parser::field_of(Expression object, const std::string& field) const {
  if (object.type->kind != Type::Kind::structure) fail("a field of what is no struct");
  const Structure& structure = scope_.unit.structures.at(object.type->name);
  for (const Field& each : structure.fields)
    if (each.name == field) return made(Kind::member, field, {std::move(object)}, each.type);
  fail("struct " + structure.name + " has no field " + field);
}

Expression Parser::behind(Expression object) {
  for (;;) {
    if (accept("[")) {
      Expression index = expression();
      expect("]");
      object = entry_of(std::move(object), std::move(index));
    } else if (accept(".")) {
      object = part_of(std::move(object));
    } else if (accept("->")) {
      TypeRef pointed = object.type->of;
      if (object.type->kind != Type::Kind::pointer) fail("-> behind what is no pointer");
      Expression target = made(Kind::dereference, "", {std::move(object)}, pointed);
      object = field_of(std::move(target), name());
    } else if (is("++") || is("--")) {
      const std::string sign = take().text;
      TypeRef type = object.type;
      object = made(Kind::after, sign, {std::move(object)}, type);
    } else {
      return object;
    }
  }
}

Expression Parser::part_of(Expression object) { return field_of(std::move(object), name()); }

Expression Parser::entry_of(Expression object, Expression index) {
  TypeRef type = object.type->of;
  if (!type) fail("an index of what is no array");
  return made(Kind::index, "", {std::move(object), std::move(index)}, type);
}

Expression Parser::variable(const std::string& name) {
  Expression result = made(Kind::name, name, {}, type_of(name));
  result.is_global = !is_local(name);
  return result;
}

Expression Parser::primary() {
  const Token token = take();
  if (token.kind == Token::Kind::number) {
    std::string text = token.text;
    const bool hexadecimal = text.compare(0, 2, "0x") == 0, is_marked = text.back() == ')';
    if (is_marked || text.find_first_of(hexadecimal ? ".p" : ".eE") != std::string::npos)
      return made(Kind::real, text, {}, basic(Type::Kind::real));
    const bool natural = text.back() == 'U';
    if (natural) text.pop_back();
    return made(Kind::integer, text, {}, basic(natural ? Type::Kind::natural : Type::Kind::integer));
  }
  if (token.kind == Token::Kind::text) return made(Kind::text, token.text, {}, basic(Type::Kind::text));
  if (token.kind != Token::Kind::name) {
    --at_;
    fail("\"" + token.text + "\" begins no expression");
  }
  if (token.text == "true" || token.text == "false")
    return made(Kind::boolean, token.text, {}, basic(Type::Kind::boolean));
  if (token.text == "NULL") return made(Kind::null, "", {}, pointer_to(basic(Type::Kind::nothing), true));
  if (is("(")) return call(token.text);
  return variable(token.text);
}

Expression Parser::call(const std::string& name) {
  const Function* known = scope_.unit.function(name);
  if (known == nullptr && !is_of_library(name)) fail("the function " + name + " is not declared");
  const TypeRef result = known != nullptr ? known->result : basic(result_of_library(name));
  const std::size_t wanted = known != nullptr ? known->parameters.size() : 0;
  Expressions list = arguments();
  if (known != nullptr && list.size() != wanted) fail("another number of arguments than " + name + " has");
  return made(Kind::call, name, std::move(list), result);
}

Expressions Parser::arguments() {
  Expressions list;
  expect("(");
  if (!is(")")) {
    do list.push_back(conditional());
    while (accept(","));
  }
  expect(")");
  return list;
}

Expression Parser::initializer(const TypeRef& type) { return is("{") ? listed(type) : conditional(); }

/// Values in braces; of a struct its fields', of an array its entries'. What is left out is zero.
Expression Parser::listed(const TypeRef& type) {
  expect("{");
  Expressions values;
  while (!accept("}")) {
    if (accept(".")) {
      const std::string field = name();
      expect("=");
      values.push_back(made(Kind::designated, field, {conditional()}, type));
    } else {
      TypeRef inner = type->of;
      if (type->kind == Type::Kind::structure) {
        const auto& fields = scope_.unit.structures.at(type->name).fields;
        if (values.size() >= fields.size()) fail("more values than struct " + type->name + " has fields");
        inner = fields[values.size()].type;
      }
      values.push_back(initializer(inner));
    }
    if (!accept(",") && !is("}")) fail("expected a comma or } between values");
  }
  return made(Kind::list, "", std::move(values), type);
}

}  // namespace qvgen::emit::blocks
