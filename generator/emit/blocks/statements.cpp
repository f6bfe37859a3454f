// SPDX-License-Identifier: MIT
// Statements: declarations, if, for, while, and expressions that end with a semicolon.
#include "emit/blocks/parser.h"

namespace qvgen::emit::blocks {

using Kind = Statement::Kind;

Statement Parser::made(Kind kind) const {
  Statement result;
  result.kind = kind;
  result.comment = peek().comment;
  result.line = peek().line;
  return result;
}

Statements Parser::block() {
  expect("{");
  locals_.emplace_back();
  Statements list;
  while (!is("}")) {
    if (peek().kind == Token::Kind::end) fail("a block without an end");
    if (begins_type()) {
      for (Statement& each : declarations()) list.push_back(std::move(each));
    } else {
      list.push_back(statement());
    }
  }
  expect("}");
  locals_.pop_back();
  return list;
}

Statements Parser::declarations() {
  Statement first = made(Kind::declare);
  const Specifiers all = specifiers();
  Statements list;
  do {
    Statement each = first;
    const Declarator declared = declarator(all);
    each.name = declared.name;
    each.type = declared.type;
    each.constant = all.constant && declared.type->kind != Type::Kind::pointer;
    locals_.back()[each.name] = each.type;
    if (accept("=")) each.values = {initializer(declared.type)};
    list.push_back(each);
    first.comment.clear();
  } while (accept(","));
  expect(";");
  return list;
}

Statement Parser::choose() {
  Statement result = made(Kind::choose);
  expect("if");
  expect("(");
  result.values = {expression()};
  expect(")");
  result.body = {statement()};
  if (accept("else")) result.otherwise = {statement()};
  return result;
}

Statement Parser::loop_for() {
  Statement result = made(Kind::loop_for);
  expect("for");
  expect("(");
  locals_.emplace_back();
  if (begins_type())
    result.first = declarations();
  else
    expect(";");
  Expression always{Expression::Kind::boolean, "true", {}, basic(Type::Kind::boolean)};
  result.values = {is(";") ? always : expression()};
  expect(";");
  if (!is(")")) result.values.push_back(expression());
  expect(")");
  result.body = {statement()};
  locals_.pop_back();
  return result;
}

Statement Parser::statement() {
  if (is("if")) return choose();
  if (is("for")) return loop_for();
  if (is("{")) {
    Statement result = made(Kind::block);
    result.body = block();
    return result;
  }
  if (is("while")) {
    Statement result = made(Kind::loop_while);
    take();
    expect("(");
    result.values = {expression()};
    expect(")");
    result.body = {statement()};
    return result;
  }
  for (const char* word : {"do", "switch", "goto"})
    if (is(word)) fail(std::string(word) + " is not in the subset: use if, for or while");
  return simple();
}

Statement Parser::simple() {
  Statement result = made(Kind::evaluate);
  if (accept("break"))
    result.kind = Kind::leave;
  else if (accept("continue"))
    result.kind = Kind::next;
  else if (accept("return"))
    result.kind = Kind::give;
  else if (is(";"))
    result.kind = Kind::nothing;
  if (!is(";")) result.values = {is("{") ? listed(result_) : expression()};
  expect(";");
  return result;
}

}  // namespace qvgen::emit::blocks
