// SPDX-License-Identifier: MIT
// Types as C declares them: specifiers, then stars in front of a name and sizes behind it.
#include "emit/blocks/parser.h"

namespace qvgen::emit::blocks {

using Kind = Type::Kind;

TypeRef basic(Kind kind) { return std::make_shared<const Type>(Type{kind}); }
TypeRef structure_type(const std::string& name) {
  return std::make_shared<const Type>(Type{Kind::structure, name});
}
TypeRef array_of(const TypeRef& element, int size, const std::string& constant) {
  return std::make_shared<const Type>(Type{Kind::array, constant, element, size});
}
TypeRef pointer_to(const TypeRef& element, bool constant, int size) {
  return std::make_shared<const Type>(Type{Kind::pointer, "", element, size, constant});
}

TypeRef reference_to(const TypeRef& type, bool constant) {
  return std::make_shared<const Type>(Type{Kind::pointer, "", type, 0, constant, true});
}

bool is_number(const TypeRef& type) {
  return type->kind == Kind::real || type->kind == Kind::integer || type->kind == Kind::natural ||
         type->kind == Kind::boolean;
}

TypeRef common(const TypeRef& a, const TypeRef& b) {
  if (a->kind == Kind::pointer || a->kind == Kind::array || a->kind == Kind::structure) return a;
  if (a->kind == Kind::real || b->kind == Kind::real) return basic(Kind::real);
  if (a->kind == Kind::natural || b->kind == Kind::natural) return basic(Kind::natural);
  return basic(Kind::integer);
}

bool Parser::begins_type(std::size_t ahead) const {
  const Token& token = peek(ahead);
  if (token.kind != Token::Kind::name) return false;
  for (const char* word :
       {"const", "static", "inline", "extern", "double", "int", "unsigned", "bool", "char", "void", "size_t"})
    if (token.text == word) return true;
  return scope_.types.count(token.text) > 0;
}

TypeRef Parser::base_type(Specifiers&) {
  static const std::map<std::string, Kind> words{
      {"double", Kind::real},  {"int", Kind::integer}, {"size_t", Kind::integer}, {"unsigned", Kind::natural},
      {"bool", Kind::boolean}, {"char", Kind::text},   {"void", Kind::nothing}};
  const std::string word = name();
  if (const auto known = words.find(word); known != words.end()) return basic(known->second);
  if (const auto known = scope_.types.find(word); known != scope_.types.end()) return known->second;
  fail("\"" + word + "\" is no type that blocks have");
}

Parser::Specifiers Parser::specifiers() {
  Specifiers all;
  for (;;) {
    if (accept("const"))
      all.constant = true;
    else if (accept("static"))
      all.is_static = true;
    else if (accept("extern"))
      all.is_extern = true;
    else if (!accept("inline"))
      break;
  }
  all.type = base_type(all);
  if (accept("const")) all.constant = true;
  return all;
}

Parser::Declarator Parser::declarator(const Specifiers& all, bool is_parameter) {
  TypeRef type = all.type;
  bool constant = all.constant;
  while (accept("*")) {
    type = pointer_to(type, constant);
    constant = accept("const");
  }
  if (accept("&")) type = reference_to(type, constant);
  if (is("(") && is("*", 1)) fail("pointers to arrays or to functions are not in the subset");
  Declarator declared{name(), type};
  std::vector<std::pair<int, std::string>> sizes;
  while (accept("[")) {
    const std::string text = peek().kind == Token::Kind::name && is("]", 1) ? peek().text : "";
    sizes.emplace_back(is("]") ? 0 : constant_value(), text);
    expect("]");
  }
  for (std::size_t i = sizes.size(); i-- > (is_parameter ? 1U : 0U);)
    declared.type = array_of(declared.type, sizes[i].first, sizes[i].second);
  if (is_parameter && !sizes.empty()) declared.type = pointer_to(declared.type, constant, sizes[0].first);
  return declared;
}

int Parser::constant_value() { return value_of(conditional()); }

int Parser::value_of(const Expression& e) const {
  using Expr = Expression::Kind;
  const auto operand = [&](std::size_t i) { return value_of(e.operands[i]); };
  if (e.kind == Expr::integer) return std::stoi(e.text);
  if (e.kind == Expr::negative) return -operand(0);
  if (e.kind == Expr::conditional) return operand(0) != 0 ? operand(1) : operand(2);
  if (e.kind == Expr::name)
    if (const auto known = scope_.numbers.find(e.text); known != scope_.numbers.end()) return known->second;
  if (e.kind == Expr::binary && e.text == "+") return operand(0) + operand(1);
  if (e.kind == Expr::binary && e.text == "-") return operand(0) - operand(1);
  if (e.kind == Expr::binary && e.text == "*") return operand(0) * operand(1);
  if (e.kind == Expr::binary && e.text == ">") return operand(0) > operand(1) ? 1 : 0;
  fail("a size that is no whole number here");
}

}  // namespace qvgen::emit::blocks
