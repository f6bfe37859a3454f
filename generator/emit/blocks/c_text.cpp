// SPDX-License-Identifier: MIT
#include "emit/blocks/c_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "emit/blocks/analysis.h"
#include "emit/blocks/parser.h"

namespace qvgen::emit::blocks {
namespace {

using Kind = Expression::Kind;

constexpr int lowest = 0, of_choice = 1, of_sign = 20, atom = 30;

/// A comment in ASCII; names of C have a point where C++ has colons. The mark of a comment behind a field
/// goes.
std::string in_ascii(std::string text) {
  if (text.rfind("< ", 0) == 0) text.erase(0, 2);
  static const std::array<std::pair<const char*, const char*>, 12> signs{{{"²", "^2"},
                                                                          {"³", "^3"},
                                                                          {"·", "."},
                                                                          {"±", "+-"},
                                                                          {"√", "root of "},
                                                                          {"φ", "phi"},
                                                                          {"λ", "lambda"},
                                                                          {"δ", "delta"},
                                                                          {"α", "alpha"},
                                                                          {"θ", "theta"},
                                                                          {"ᵀ", "^T"},
                                                                          {"::", "."}}};
  for (const auto& [sign, word] : signs)
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
      text.replace(at, std::string(sign).size(), word);
  return text;
}

std::string type_text(const TypeRef& type) {
  switch (type->kind) {
    case Type::Kind::nothing:
      return "void";
    case Type::Kind::real:
      return "double";
    case Type::Kind::integer:
      return "int";
    case Type::Kind::natural:
      return "unsigned";
    case Type::Kind::boolean:
      return "bool";
    case Type::Kind::text:
      return "char";
    case Type::Kind::structure:
      return type->name;
    case Type::Kind::array:
      return type_text(type->of);
    case Type::Kind::pointer:
      return (type->constant ? "const " : "") + type_text(type->of) + "*";
  }
  return {};
}

std::string declared(const TypeRef& type, const std::string& name) {
  std::string sizes;
  for (TypeRef each = type; each->kind == Type::Kind::array; each = each->of)
    sizes += "[" + (each->name.empty() ? std::to_string(each->size) : each->name) + "]";
  return type_text(type) + " " + name + sizes;
}

std::string comment(const std::vector<std::string>& lines, const std::string& mark,
                    const std::string& indent = "") {
  std::string text;
  for (const std::string& each : lines)
    text += indent + mark + (each.empty() ? "" : " " + in_ascii(each)) + "\n";
  return text;
}

class Writer {
 public:
  explicit Writer(const Unit& unit) : unit_(unit) {}

  std::string function(const Function& function) {
    bool loops = false;
    for_each_statement(function.body, [&](const Statement& each) {
      loops = loops || each.kind == Statement::Kind::loop_for || each.kind == Statement::Kind::loop_while;
    });
    result_ = function.result;
    std::string list;
    for (const Field& each : function.parameters)
      list += (list.empty() ? "" : ", ") + declared(each.type, each.name);
    text_ = comment(function.doc, "///") + "static " + (loops ? "" : "inline ") +
            declared(function.result, function.name) + "(" + (list.empty() ? "void" : list) + ") {\n";
    all(function.body, 1);
    return text_ + "}\n\n";
  }

  /// Text of an expression, in brackets if it binds more weakly than `least`.
  std::string in(const Expression& e, int least) const {
    const auto [text, level] = spelled(e);
    return level < least ? "(" + text + ")" : text;
  }

  /// A value behind an equals sign of a declaration.
  std::string initial(const Expression& e) const {
    return e.kind == Kind::list ? braces(e) : in(e, of_choice);
  }

 private:
  using Spelled = std::pair<std::string, int>;

  std::string list(const Expressions& all) const {
    std::string text;
    for (const Expression& each : all) text += (text.empty() ? "" : ", ") + in(each, of_choice);
    return text;
  }

  std::string braces(const Expression& e) const {
    std::string text;
    for (const Expression& each : e.operands) text += (text.empty() ? "" : ", ") + initial(each);
    return text.empty() ? zero(e.type) : "{" + text + "}";
  }

  /// Zeros of a type in braces, as many as C wants.
  std::string zero(const TypeRef& type) const {
    if (type->kind == Type::Kind::array) return "{" + zero(type->of) + "}";
    if (type->kind != Type::Kind::structure) return "0";
    return "{" + zero(unit_.structures.at(type->name).fields.front().type) + "}";
  }

  /// True if a function makes the struct of its fields: its parameters are these.
  bool has_maker(const Expression& e) const {
    const Function* maker =
        e.type->kind == Type::Kind::structure ? unit_.function(snake(e.type->name)) : nullptr;
    if (maker == nullptr || maker->parameters.size() != e.operands.size()) return false;
    const std::vector<Field>& fields = unit_.structures.at(e.type->name).fields;
    return std::equal(
        fields.begin(), fields.end(), maker->parameters.begin(), maker->parameters.end(),
        [](const Field& a, const Field& b) { return a.name == b.name && a.type->kind == b.type->kind; });
  }

  Spelled binary(const Expression& e) const {
    const int level = 2 + precedence(e.text);
    const auto side = [&](const Expression& each, int least) {
      const bool mixed = e.text == "||" && each.kind == Kind::binary && each.text == "&&";
      return mixed ? "(" + in(each, lowest) + ")" : in(each, least);
    };
    return {side(e.operands[0], level) + " " + e.text + " " + side(e.operands[1], level + 1), level};
  }

  Spelled spelled(const Expression& e) const {
    const auto operand = [&](int least) { return in(e.operands[0], least); };
    switch (e.kind) {
      case Kind::member:
        if (e.operands[0].kind == Kind::dereference)
          return {in(e.operands[0].operands[0], atom) + "->" + e.text, atom};
        return {operand(atom) + "." + e.text, atom};
      case Kind::index:
        return {operand(atom) + "[" + in(e.operands[1], lowest) + "]", atom};
      case Kind::call:
        return {e.text + "(" + list(e.operands) + ")", atom};
      case Kind::negative: {
        const std::string inner = operand(of_sign);
        return {"-" + (inner[0] == '-' ? "(" + inner + ")" : inner), of_sign};
      }
      case Kind::cast:
        return {"(" + type_text(e.type) + ")" + operand(of_sign), of_sign};
      case Kind::is_not:
        return {"!" + operand(of_sign), of_sign};
      case Kind::dereference:
        return {"*" + operand(of_sign), of_sign};
      case Kind::address:
        return {"&" + operand(of_sign), of_sign};
      case Kind::before:
        return {e.text + operand(of_sign), of_sign};
      case Kind::after:
        return {operand(atom) + e.text, atom};
      case Kind::binary:
        return binary(e);
      case Kind::conditional:
        return {in(e.operands[0], of_choice + 1) + " ? " + in(e.operands[1], of_choice) + " : " +
                    in(e.operands[2], of_choice),
                of_choice};
      case Kind::assign:
        return {operand(of_sign) + " " + e.text + " " + in(e.operands[1], lowest), lowest};
      case Kind::list:
        if (has_maker(e)) return {snake(e.type->name) + "(" + list(e.operands) + ")", atom};
        return {"(" + type_text(e.type) + ")" + braces(e), atom};
      case Kind::real:
      case Kind::integer:
      case Kind::boolean:
      case Kind::name:
        return {e.text, atom};
      default:
        throw NotInSubset("line " + std::to_string(e.line) + ": an expression that headers do not have");
    }
  }

  void line(int depth, const std::string& text) {
    text_ += std::string(static_cast<std::size_t>(2 * depth), ' ') + text + "\n";
  }

  void all(const Statements& statements, int depth) {
    for (const Statement& each : statements) one(each, depth);
  }

  std::string declaration(const Statement& s) const {
    const std::string value = s.values.empty() ? "" : " = " + initial(s.values[0]);
    return (s.constant ? "const " : "") + declared(s.type, s.name) + value;
  }

  /// A statement of one line without its semicolon.
  std::string simple(const Statement& s) const {
    switch (s.kind) {
      case Statement::Kind::declare:
        return declaration(s);
      case Statement::Kind::evaluate:
        return in(s.values[0], lowest);
      case Statement::Kind::leave:
        return "break";
      case Statement::Kind::next:
        return "continue";
      case Statement::Kind::give:
        return s.values.empty() ? "return" : "return " + in(s.values[0], lowest);
      default:
        throw NotInSubset("line " + std::to_string(s.line) + ": a statement that headers do not have");
    }
  }

  /// Writes one short statement behind a condition, or a block.
  void body(const std::string& head, const Statements& statements, int depth, bool may_be_short) {
    const Statements& inner = statements.size() == 1 && statements[0].kind == Statement::Kind::block
                                  ? statements[0].body
                                  : statements;
    const bool is_short = may_be_short && inner.size() == 1 && inner[0].kind != Statement::Kind::choose &&
                          inner[0].kind != Statement::Kind::loop_for && !gives_a_struct(inner[0]);
    if (is_short) return line(depth, head + " " + simple(inner[0]) + ";");
    line(depth, head + " {");
    all(inner, depth + 1);
    line(depth, "}");
  }

  bool gives_a_struct(const Statement& s) const {
    return s.kind == Statement::Kind::give && !s.values.empty() && s.values[0].kind == Kind::list &&
           !has_maker(s.values[0]);
  }

  void choose(const Statement& s, int depth, const std::string& before) {
    body(before + "if (" + in(s.values[0], lowest) + ")", s.body, depth,
         s.otherwise.empty() && before.empty());
    if (s.otherwise.empty()) return;
    text_.pop_back();  // "} else" is one line
    const std::size_t at = text_.rfind('\n') + 1;
    text_.erase(at);
    if (s.otherwise.size() == 1 && s.otherwise[0].kind == Statement::Kind::choose)
      return choose(s.otherwise[0], depth, "} else ");
    body("} else", s.otherwise, depth, false);
  }

  void loop(const Statement& s, int depth) {
    std::string first, step = s.values.size() > 1 ? in(s.values[1], lowest) : "";
    for (const Statement& each : s.first) first += (first.empty() ? "" : ", ") + declaration(each);
    body("for (" + first + "; " + in(s.values[0], lowest) + "; " + step + ")", s.body, depth, true);
  }

  void one(const Statement& s, int depth) {
    text_ += comment(s.comment, "//", std::string(static_cast<std::size_t>(2 * depth), ' '));
    if (s.kind == Statement::Kind::choose) return choose(s, depth, "");
    if (s.kind == Statement::Kind::loop_for) return loop(s, depth);
    if (gives_a_struct(s)) {
      line(depth, "const " + type_text(result_) + " result = " + braces(s.values[0]) + ";");
      return line(depth, "return result;");
    }
    line(depth, simple(s) + ";");
  }

  const Unit& unit_;
  TypeRef result_;
  std::string text_;
};

}  // namespace

std::string snake(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isupper(letter) != 0 && !result.empty()) result += '_';
    result += static_cast<char>(std::tolower(letter));
  }
  return result;
}

std::string c_text(const Unit& /*unit*/, const Structure& structure) {
  std::string text = comment(structure.doc, "///") + "typedef struct " + structure.name + " {\n";
  for (const Field& each : structure.fields)
    text += comment(each.doc, "//", "  ") + "  " + declared(each.type, each.name) + ";\n";
  return text + "} " + structure.name + ";\n\n";
}

std::string c_text(const Unit& unit, const Constant& constant) {
  return comment(constant.doc, "///") + "static const " + declared(constant.type, constant.name) + " = " +
         Writer(unit).initial(constant.value[0]) + ";\n\n";
}

std::string c_text(const Unit& unit, const Function& function) { return Writer(unit).function(function); }

}  // namespace qvgen::emit::blocks
