// SPDX-License-Identifier: MIT
// Definitions of a file: structs, enumerators, constants, functions.
#include "emit/blocks/parser.h"

#include <algorithm>

namespace qvgen::emit::blocks {

const Function* Unit::function(const std::string& name) const {
  const auto at =
      std::find_if(functions.begin(), functions.end(), [&](const auto& f) { return f.name == name; });
  return at == functions.end() ? nullptr : &*at;
}

const Constant* Unit::constant(const std::string& name) const {
  const auto at =
      std::find_if(constants.begin(), constants.end(), [&](const auto& c) { return c.name == name; });
  return at == constants.end() ? nullptr : &*at;
}

const Constant* Unit::constant_of(const Expression& expression) const {
  return expression.is_global ? constant(expression.text) : nullptr;
}

const Token& Parser::peek(std::size_t ahead) const {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

Token Parser::take() { return at_ + 1 < tokens_.size() ? tokens_[at_++] : tokens_.back(); }

bool Parser::is(const std::string& text, std::size_t ahead) const {
  const Token& token = peek(ahead);
  return token.kind != Token::Kind::text && token.kind != Token::Kind::end && token.text == text;
}

bool Parser::accept(const std::string& text) {
  if (!is(text)) return false;
  take();
  return true;
}

void Parser::expect(const std::string& text) {
  if (!accept(text)) fail("expected \"" + text + "\" in front of \"" + peek().text + "\"");
}

std::string Parser::name() {
  if (peek().kind != Token::Kind::name) fail("expected a name in front of \"" + peek().text + "\"");
  return take().text;
}

void Parser::fail(const std::string& what) const { throw error_at(file_, peek().line, what); }

void Parser::run() {
  while (peek().kind != Token::Kind::end) definition();
}

/// The name of a definition that its file keeps to itself. Where another module has one of that name it gets
/// the module's behind it, here and in all that follows.
std::string Parser::own_name(const std::string& name) {
  const Function* function = scope_.unit.function(name);
  const Constant* constant = scope_.unit.constant(name);
  const bool is_elsewhere =
      (function != nullptr && function->module != file_.module && !function->is_public) ||
      (constant != nullptr && constant->module != file_.module && !constant->is_public);
  if (!is_elsewhere) return name;
  const std::string own = name + "_of_" + file_.module;
  for (std::size_t i = at_; i < tokens_.size(); ++i)
    if (tokens_[i].text == name && tokens_[i - 1].text != "." && tokens_[i - 1].text != "->")
      tokens_[i].text = own;
  return own;
}

void Parser::definition() {
  const std::vector<std::string> doc = peek().comment;
  if (accept("typedef")) return type_definition(doc);
  if (accept("enum")) {
    enumerators(doc);
    return expect(";");
  }
  const Specifiers all = specifiers();
  const Declarator declared = declarator(all);
  if (is("("))
    function(all, declared, doc);
  else
    constants(all, declared, doc);
}

void Parser::type_definition(const std::vector<std::string>& doc) {
  TypeRef type;
  if (accept("enum")) {
    name();
    enumerators(doc);
    type = basic(Type::Kind::integer);
  } else if (is("struct")) {
    take();
    type = structure(name(), doc);
  } else {
    type = specifiers().type;
  }
  scope_.types[name()] = type;
  expect(";");
}

TypeRef Parser::structure(const std::string& name, const std::vector<std::string>& doc) {
  Structure made{name, doc, {}, file_.module, file_.is_header};
  fields(made);
  if (!scope_.unit.structures.emplace(name, made).second) fail("a second struct " + name);
  scope_.unit.structure_order.push_back(name);
  return structure_type(name);
}

void Parser::fields(Structure& into) {
  expect("{");
  while (!accept("}")) {
    std::vector<std::string> doc = peek().comment;
    if (is("struct") && is("{", 1)) {
      take();
      const std::string outer = into.name + "_part";
      const TypeRef inner = structure(outer, {});
      into.fields.push_back({name(), inner, doc});
      expect(";");
      continue;
    }
    const Specifiers all = specifiers();
    const std::size_t first = into.fields.size();
    do {
      const Declarator each = declarator(all);
      into.fields.push_back({each.name, each.type, {}});
    } while (accept(","));
    if (const std::string& behind = peek().behind; is(";") && !behind.empty()) doc.push_back(behind);
    expect(";");
    into.fields[first].doc = doc;
  }
}

void Parser::enumerators(const std::vector<std::string>& doc) {
  expect("{");
  int value = 0;
  std::vector<std::string> above = doc;
  while (!accept("}")) {
    if (!peek().comment.empty()) above = peek().comment;
    const std::string each = own_name(name());
    if (accept("=")) value = constant_value();
    scope_.numbers[each] = value;
    Expression number{Expression::Kind::integer, std::to_string(value), {}, basic(Type::Kind::integer)};
    scope_.unit.constants.push_back(
        {each, above, basic(Type::Kind::integer), {number}, file_.module, file_.is_header});
    above.clear();
    ++value;
    if (!accept(",") && !is("}")) fail("expected a comma or } in an enum");
  }
}

std::vector<Field> Parser::parameters() {
  std::vector<Field> list;
  expect("(");
  if (accept("void")) {
    expect(")");
    return list;
  }
  do {
    const Declarator each = declarator(specifiers(), true);
    list.push_back({each.name, each.type});
  } while (accept(","));
  expect(")");
  return list;
}

void Parser::function(const Specifiers& all, const Declarator& declared,
                      const std::vector<std::string>& doc) {
  const std::string own = all.is_static ? own_name(declared.name) : declared.name;
  Function made{own, doc, declared.type, parameters(), {}, file_.module, !all.is_static};
  auto& functions = scope_.unit.functions;
  const auto known = std::find_if(functions.begin(), functions.end(),
                                  [&](const Function& f) { return f.name == made.name; });
  if (known != functions.end() && known->is_defined) fail("a second function " + made.name);
  if (known != functions.end() && doc.empty()) made.doc = known->doc;
  if (known != functions.end()) functions.erase(known);
  functions.push_back(made);
  if (accept(";")) return;
  result_ = made.result;
  locals_.emplace_back();
  for (const Field& each : made.parameters) locals_.back()[each.name] = each.type;
  Statements body = block();
  locals_.pop_back();
  const auto place = std::find_if(functions.begin(), functions.end(),
                                  [&](const Function& f) { return f.name == made.name; });
  place->body = std::move(body);
  place->is_defined = true;
}

void Parser::constants(const Specifiers& all, Declarator declared, const std::vector<std::string>& doc) {
  auto& constants = scope_.unit.constants;
  if (all.is_static) declared.name = own_name(declared.name);
  const auto known = std::find_if(constants.begin(), constants.end(),
                                  [&](const auto& c) { return c.name == declared.name; });
  Constant made{declared.name, doc, declared.type, {}, file_.module, !all.is_static};
  if (known != constants.end()) {
    if (doc.empty()) made.doc = known->doc;
    made.is_public = true;
    constants.erase(known);
  }
  if (!all.constant && declared.type->kind != Type::Kind::pointer) fail("a variable outside of functions");
  if (accept("=")) made.value = {initializer(declared.type)};
  expect(";");
  constants.push_back(made);
}

Unit parse(const std::string& robot, const std::vector<File>& files) {
  Scope scope;
  scope.unit.robot = robot;
  for (const File& file : files) {
    auto& modules = scope.unit.modules;
    if (std::find(modules.begin(), modules.end(), file.module) == modules.end())
      modules.push_back(file.module);
    Parser(file, scope).run();
  }
  return std::move(scope.unit);
}

}  // namespace qvgen::emit::blocks
