// SPDX-License-Identifier: MIT
// Statements of a function, which are C's but for declarations and copies.
#include "emit/javascript/names.h"
#include "emit/javascript/writer.h"

namespace qvgen::emit::javascript {

using blocks::Expression;
using blocks::Shape;
using blocks::Statement;
using blocks::Statements;
using blocks::Type;
using Kind = Expression::Kind;

FunctionWriter::FunctionWriter(const Context& context, const blocks::Function& function)
    : context_(context), function_(function), returns_last_(blocks::returns_last(function)) {
  if (!function.is_defined) return;
  changed_ = blocks::changed_names(context.unit, context.shapes, function);
  blocks::for_each(function.body, [&](const Expression& e) {
    const blocks::Function* callee = e.kind == Kind::call ? context_.unit.function(e.text) : nullptr;
    if (callee != nullptr) called_.insert(function_name(context_.unit, *callee));
  });
  for (const blocks::Field& each : function.parameters)
    if (each.type->kind == Type::Kind::structure && changed_.count(each.name) == 0)
      borrowed_.insert(each.name);
}

/// Name of a variable; one that a called function has, too, gets an underscore.
std::string FunctionWriter::local(const std::string& name) const {
  const std::string own = value_name(name);
  return called_.count(own) > 0 ? own + "_" : own;
}

void FunctionWriter::line(int depth, const std::string& text) {
  lines_.push_back(std::string(static_cast<std::size_t>(2 * depth), ' ') + text);
}

std::vector<std::string> FunctionWriter::parameters() const {
  std::vector<std::string> list;
  const std::vector<Shape>& shapes = context_.shapes.of(function_.name);
  const std::size_t count = function_.parameters.size() - (returns_last_ ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& name = function_.parameters[i].name;
    std::string usual;
    if (function_.is_public && name == "g") usual = " = defaultGeometry";
    if (function_.is_public && name == "inertia") usual = " = defaultInertia";
    if (function_.is_public && name == "tolerance") usual = " = defaultTolerance";
    if (function_.is_public && shapes[i].optional) usual = " = null";
    list.push_back(local(name) + usual);
  }
  return list;
}

Lines FunctionWriter::lines() {
  std::string list;
  for (const std::string& each : parameters()) list += (list.empty() ? "" : ", ") + each;
  line(0, std::string(function_.is_public ? "export " : "") + "function " +
              function_name(context_.unit, function_) + "(" + list + ") {");
  for (const blocks::Field& each : function_.parameters)
    if (each.type->kind == Type::Kind::structure && changed_.count(each.name) > 0)
      line(1, local(each.name) + " = copy" + type_name(context_.unit, each.type->name) + "(" +
                  local(each.name) + ");");
  if (returns_last_) {
    const blocks::Field& last = function_.parameters.back();
    line(1, "const " + local(last.name) + " = " + zero_text(context_.unit, blocks::pointee(last)) + ";");
  }
  write(function_.body, 1);
  const bool is_given = !function_.body.empty() && function_.body.back().kind == Statement::Kind::give;
  if (returns_last_ && !is_given) line(1, "return " + local(function_.parameters.back().name) + ";");
  line(0, "}");
  return std::move(lines_);
}

std::string FunctionWriter::constant_value(const Expression& value, const blocks::TypeRef& type) {
  return as(value, type);
}

void FunctionWriter::write(const Statements& statements, int depth) {
  for (const Statement& each : statements) write(each, depth);
}

void FunctionWriter::write(const Statement& s, int depth) {
  using Of = Statement::Kind;
  for (const std::string& each : s.comment) line(depth, "// " + each);
  switch (s.kind) {
    case Of::declare: {
      const std::string text = declared(s);
      if (!text.empty()) line(depth, text + ";");
      return;
    }
    case Of::evaluate:
      return evaluate(s.values[0], depth);
    case Of::block:
      line(depth, "{");
      write(s.body, depth + 1);
      return line(depth, "}");
    case Of::choose:
      return choose(s, depth, "");
    case Of::loop_for:
      return loop_for(s, depth);
    case Of::loop_while:
      line(depth, "while (" + as(s.values[0], blocks::basic(Type::Kind::boolean)) + ") {");
      write(s.body, depth + 1);
      return line(depth, "}");
    case Of::leave:
      return line(depth, "break;");
    case Of::next:
      return line(depth, "continue;");
    case Of::give:
      return give(s, depth);
    case Of::nothing:
      return;
  }
}

std::string FunctionWriter::declared(const Statement& s) {
  if (s.type->kind == Type::Kind::pointer) {
    if (s.values.empty()) throw blocks::NotInSubset(function_.name + ": a pointer without a place");
    if (blocks::is_scalar_pointer(s.type) && s.values[0].kind == Kind::address) {
      aliases_[s.name] = s.values[0];
      return "";
    }
    return "const " + local(s.name) + " = " + argument(s.values[0], s.type, Shape{});
  }
  const bool is_object = s.type->kind == Type::Kind::structure || s.type->kind == Type::Kind::array;
  const std::string mark = is_object || changed_.count(s.name) == 0 ? "const " : "let ";
  const std::string first = s.values.empty() ? zero_text(context_.unit, s.type) : as(s.values[0], s.type);
  return mark + local(s.name) + " = " + first;
}

std::string FunctionWriter::copied(const Expression& e) {
  const Expression &to = e.operands[0], &from = e.operands[1];
  if (e.text == "memset") {
    const blocks::TypeRef type = to.type->kind == Type::Kind::pointer ? to.type->of : to.type;
    if (type->kind == Type::Kind::structure)
      return "set" + type_name(context_.unit, type->name) + "(" + place(to) + ", " +
             zero_text(context_.unit, type) + ")";
    return "copyTo(" + place(to) + ", " + zero_text(context_.unit, type) + ", " + std::to_string(type->size) +
           ")";
  }
  const blocks::Extent extent = blocks::extent_of(e.operands[2]);
  if (extent.whole)
    return "set" + type_name(context_.unit, to.type->of->name) + "(" + place(to) + ", " + place(from) + ")";
  return "copyTo(" + place(to) + ", " + place(from) + ", " + value(extent.count).text + ")";
}

std::string FunctionWriter::assigned(const Expression& e) {
  const Expression &to = e.operands[0], &from = e.operands[1];
  if (from.kind == Kind::assign) {
    const std::string first = assigned(from);
    return first + "; " + place(to) + " = " + as(from.operands[0], to.type);
  }
  if (to.type->kind == Type::Kind::structure)
    return "set" + type_name(context_.unit, to.type->name) + "(" + place(to) + ", " +
           (from.kind == Kind::list ? list(from) : place(from)) + ")";
  if (e.text == "/=" && to.type->kind != Type::Kind::real)
    return place(to) + " = Math.trunc(" + place(to) + " / " + as(from, to.type) + ")";
  return place(to) + " " + e.text + " " + as(from, to.type);
}

/// A statement's text without its semicolon; empty if it does nothing here.
std::string FunctionWriter::effect(const Expression& whole) {
  const Expression& e = whole.kind == Kind::cast ? whole.operands[0] : whole;
  if (e.kind == Kind::name) return "";
  if (e.kind == Kind::assign) return assigned(e);
  if (e.kind != Kind::call) return value(e).text;
  if (e.text == "memcpy" || e.text == "memset") return copied(e);
  const blocks::Function* callee = context_.unit.function(e.text);
  if (callee == nullptr || !blocks::returns_last(*callee)) return call(e);
  const blocks::TypeRef type = blocks::pointee(callee->parameters.back());
  const std::string to = place(e.operands.back());
  if (type->kind == Type::Kind::structure)
    return "set" + type_name(context_.unit, type->name) + "(" + to + ", " + call(e) + ")";
  return "copyTo(" + to + ", " + call(e) + ", " + std::to_string(type->size) + ")";
}

void FunctionWriter::evaluate(Expression e, int depth) {
  const std::string text = effect(e);
  if (!text.empty()) line(depth, text + ";");
}

void FunctionWriter::choose(const Statement& s, int depth, const std::string& before) {
  line(depth, before + "if (" + as(s.values[0], blocks::basic(Type::Kind::boolean)) + ") {");
  const auto inside = [&](const Statements& statements) {
    for (const Statement& each : statements)
      if (each.kind == Statement::Kind::block)
        write(each.body, depth + 1);
      else
        write(each, depth + 1);
  };
  inside(s.body);
  if (s.otherwise.size() == 1 && s.otherwise[0].kind == Statement::Kind::choose)
    return choose(s.otherwise[0], depth, "} else ");
  if (!s.otherwise.empty()) {
    line(depth, "} else {");
    inside(s.otherwise);
  }
  line(depth, "}");
}

void FunctionWriter::loop_for(const Statement& s, int depth) {
  std::string first, step;
  for (const Statement& each : s.first) {
    std::string text = declared(each);
    if (!first.empty()) text.erase(0, text.find(' ') + 1);
    first += (first.empty() ? "" : ", ") + text;
  }
  // The variable of a loop changes, whoever steps it.
  if (first.rfind("const ", 0) == 0) first.replace(0, 5, "let");
  if (s.values.size() == 2) step = effect(s.values[1]);
  line(depth,
       "for (" + first + "; " + as(s.values[0], blocks::basic(Type::Kind::boolean)) + "; " + step + ") {");
  for (const Statement& each : s.body)
    if (each.kind == Statement::Kind::block)
      write(each.body, depth + 1);
    else
      write(each, depth + 1);
  line(depth, "}");
}

void FunctionWriter::give(const Statement& s, int depth) {
  if (returns_last_) {
    if (!s.values.empty() && s.values[0].kind == Kind::call) evaluate(s.values[0], depth);
    return line(depth, "return " + local(function_.parameters.back().name) + ";");
  }
  if (s.values.empty()) return line(depth, "return;");
  const Expression& e = s.values[0];
  const bool is_own =
      e.kind == Kind::name && borrowed_.count(e.text) == 0 && context_.unit.constant_of(e) == nullptr;
  line(depth, "return " + (is_own ? name(e) : as(e, function_.result)) + ";");
}

}  // namespace qvgen::emit::javascript
