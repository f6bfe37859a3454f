// SPDX-License-Identifier: MIT
// Statements of a function. A for loop whose variable does not change inside becomes a range.
#include <algorithm>

#include "emit/rust/names.h"
#include "emit/rust/writer.h"

namespace qvgen::emit::rust {

using blocks::Expression;
using blocks::Shape;
using blocks::Statement;
using blocks::Statements;
using blocks::Type;
using Kind = Expression::Kind;

FunctionWriter::FunctionWriter(const Context& context, const blocks::Function& function)
    : context_(context),
      function_(function),
      robot_(context.unit.robot),
      returns_last_(blocks::returns_last(function)) {
  if (!function.is_defined) return;
  changed_ = blocks::changed_names(context.unit, context.shapes, function);
  const std::vector<Shape>& shapes = context.shapes.of(function.name);
  for (std::size_t i = 0; i < function.parameters.size(); ++i)
    if (function.parameters[i].type->kind == Type::Kind::pointer)
      parameters_[function.parameters[i].name] = shapes[i];
  if (!returns_last_) return;
  const blocks::Field& last = function.parameters.back();
  Expression own{Kind::name, last.name, {}, blocks::pointee(last)};
  parameters_.erase(last.name);
  aliases_[last.name] = {Kind::address, "", {own}, last.type};
}

void FunctionWriter::line(int depth, const std::string& text) {
  lines_.push_back(std::string(static_cast<std::size_t>(4 * depth), ' ') + text);
}

std::string FunctionWriter::head() {
  std::string list;
  const std::vector<Shape>& shapes = context_.shapes.of(function_.name);
  const std::size_t count = function_.parameters.size() - (returns_last_ ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const blocks::Field& each = function_.parameters[i];
    const bool is_changed = each.type->kind != Type::Kind::pointer && changed_.count(each.name) > 0;
    list += (list.empty() ? "" : ", ") + std::string(is_changed ? "mut " : "") + value_name(each.name) +
            ": " + parameter_text(each.type, shapes[i], context_);
  }
  const blocks::TypeRef result =
      returns_last_ ? blocks::pointee(function_.parameters.back()) : function_.result;
  const bool gives = result->kind != Type::Kind::nothing;
  return std::string(function_.is_public ? "pub " : "") + "fn " + function_name(context_.unit, function_) +
         "(" + list + ")" + (gives ? " -> " + type_text(result, context_) : "") + " {";
}

Lines FunctionWriter::lines() {
  line(0, head());
  if (returns_last_) {
    const blocks::Field& last = function_.parameters.back();
    line(1, "let mut " + value_name(last.name) + " = " + zero_text(blocks::pointee(last), robot_) + ";");
  }
  const bool is_given = !function_.body.empty() && function_.body.back().kind == Statement::Kind::give;
  write(is_given ? Statements(function_.body.begin(), function_.body.end() - 1) : function_.body, 1);
  if (is_given) give_at_end(function_.body.back());
  if (returns_last_ && !is_given) line(1, value_name(function_.parameters.back().name));
  line(0, "}");
  return std::move(lines_);
}

/// Prints the last statement of a function, its value.
void FunctionWriter::give_at_end(const Statement& s) {
  for (const std::string& each : s.comment) line(1, "// " + each);
  give(s, 1);
  std::string& last = lines_.back();
  last = "    " + last.substr(std::string("    return ").size());
  last.pop_back();
}

std::string FunctionWriter::constant_value(const Expression& value, const blocks::TypeRef& type) {
  return as(value, type);
}

std::string FunctionWriter::condition(const Expression& e) {
  return as(e, blocks::basic(Type::Kind::boolean));
}

Expression FunctionWriter::hoisted(const Expression& e, int depth) {
  Expression result = e;
  for (Expression& each : result.operands) each = hoisted(each, depth);
  if (e.kind != Kind::before && e.kind != Kind::after) return result;
  const std::string step = place(result.operands[0]) + (e.text == "++" ? " += 1;" : " -= 1;");
  if (e.kind == Kind::before) {
    line(depth, step);
    return result.operands[0];
  }
  const std::string name = "at" + std::to_string(names_++);
  line(depth, "let " + name + " = " + place(result.operands[0]) + ";");
  line(depth, step);
  return {Kind::name, name, {}, e.type, e.line};
}

void FunctionWriter::write(const Statements& statements, int depth) {
  for (const Statement& each : statements) write(each, depth);
}

void FunctionWriter::write(const Statement& s, int depth) {
  using Of = Statement::Kind;
  for (const std::string& each : s.comment) line(depth, "// " + each);
  switch (s.kind) {
    case Of::declare:
      return declare(s, depth);
    case Of::evaluate:
      return evaluate(s.values[0], depth);
    case Of::block:
      return write(s.body, depth);
    case Of::choose:
      return choose(s, depth, "");
    case Of::loop_for:
      return loop_for(s, depth);
    case Of::loop_while:
      line(depth, "while " + condition(s.values[0]) + " {");
      steps_.emplace_back();
      write(s.body, depth + 1);
      steps_.pop_back();
      return line(depth, "}");
    case Of::leave:
      return line(depth, "break;");
    case Of::next:
      if (!steps_.back().empty()) line(depth, steps_.back());
      return line(depth, "continue;");
    case Of::give:
      return give(s, depth);
    case Of::nothing:
      return;
  }
}

void FunctionWriter::declare(const Statement& s, int depth) {
  if (s.type->kind == Type::Kind::pointer) return declare_pointer(s, depth);
  const std::string mark = changed_.count(s.name) > 0 ? "let mut " : "let ";
  const bool is_natural = s.type->kind == Type::Kind::natural;
  const std::string type = is_natural ? ": u32" : "";
  const std::string name = mark + value_name(s.name) + type + " = ";
  if (s.values.empty()) return line(depth, name + zero_text(s.type, robot_) + ";");
  const Expression first = hoisted(s.values[0], depth);
  line(depth, name + as(first, s.type) + ";");
}

/// Another name of a place is written out; anything else is a reference.
void FunctionWriter::declare_pointer(const Statement& s, int depth) {
  if (s.values.empty()) throw blocks::NotInSubset(function_.name + ": a pointer without a place");
  Expression to = hoisted(s.values[0], depth);
  const bool is_place = to.kind == Kind::address || to.type->kind == Type::Kind::array ||
                        (to.kind == Kind::name && context_.unit.constant_of(to) == nullptr);
  if (!is_place) {
    const Shape shape{false, false, !s.type->constant, 0};
    line(depth, "let " + value_name(s.name) + " = " + reference(to, shape) + ";");
    return;
  }
  // An index that may change later is kept.
  const std::function<void(Expression&)> keep = [&](Expression& e) {
    if (e.kind == Kind::index) {
      Expression& at = e.operands[1];
      const bool is_fixed =
          at.kind == Kind::integer ||
          (at.kind == Kind::name && (counters_.count(at.text) > 0 || changed_.count(at.text) == 0));
      if (!is_fixed) {
        const std::string name = "at" + std::to_string(names_++);
        line(depth, "let " + name + " = " + value(at).text + ";");
        at = {Kind::name, name, {}, at.type, at.line};
      }
    }
    for (Expression& each : e.operands) keep(each);
  };
  keep(to);
  aliases_[s.name] = to;
}

void FunctionWriter::copy(const Expression& e, int depth) {
  const Expression &to = e.operands[0], &from = e.operands[1];
  const bool clears = e.text == "memset";
  const auto object = [&](const Expression& pointer) -> std::string {
    if (pointer.type->kind == Type::Kind::array) return place(pointer);
    return (is_reference(pointer) ? "*" : "") + pointed_place(pointer);
  };
  const blocks::Extent extent = blocks::extent_of(e.operands[2]);
  if (clears) {
    const blocks::TypeRef type = to.type->kind == Type::Kind::pointer ? to.type->of : to.type;
    return line(depth, object(to) + " = " + zero_text(type, robot_) + ";");
  }
  if (extent.whole) return line(depth, object(to) + " = " + object(from) + ";");
  const bool same = to.type->kind == Type::Kind::array && from.type->kind == Type::Kind::array &&
                    to.type->size == from.type->size && extent.count.text == std::to_string(to.type->size);
  if (same) return line(depth, place(to) + " = " + place(from) + ";");
  const Expression at{Kind::index, "", {to, extent.count}};
  const std::string part = "[.." + index(at) + "]";
  line(depth, place(to) + part + ".copy_from_slice(&" + place(from) + part + ");");
}

void FunctionWriter::call_for_result(const Expression& e, int depth) {
  const Expression& result = e.operands.back();
  const std::string to = result.type->kind == Type::Kind::array ? place(result)
                         : is_reference(result)                 ? "*" + pointed_place(result)
                                                                : pointed_place(result);
  line(depth, to + " = " + call(e) + ";");
}

void FunctionWriter::evaluate(Expression e, int depth) {
  if (e.kind == Kind::cast) e = e.operands[0];
  if (e.kind == Kind::name) return line(depth, "let _ = " + value_name(e.text) + ";");
  if (e.kind == Kind::before || e.kind == Kind::after)
    return line(depth, place(e.operands[0]) + (e.text == "++" ? " += 1;" : " -= 1;"));
  if (e.kind == Kind::assign) return assign(e, depth);
  if (e.kind != Kind::call) throw blocks::NotInSubset(function_.name + ": a statement without an effect");
  if (e.text == "memcpy" || e.text == "memset") return copy(e, depth);
  e = hoisted(e, depth);
  const blocks::Function* callee = context_.unit.function(e.text);
  if (callee != nullptr && blocks::returns_last(*callee)) return call_for_result(e, depth);
  line(depth, call(e) + ";");
  copy_kept(e, depth);
}

/// A struct that keeps a pointer to what a call has changed has a copy: it is made again.
void FunctionWriter::copy_kept(const Expression& e, int depth) {
  if (context_.unit.function(e.text) == nullptr) return;
  const std::vector<Shape>& shapes = context_.shapes.of(e.text);
  for (std::size_t i = 0; i < e.operands.size(); ++i) {
    if (!shapes[i].changed) continue;
    const auto kept = kept_.find(path(e.operands[i]).root);
    if (kept != kept_.end()) line(depth, kept->second + " = " + value_name(kept->first) + ";");
  }
}

void FunctionWriter::assign(const Expression& e, int depth) {
  const Expression* last = &e;
  std::vector<const Expression*> targets;
  for (; last->kind == Kind::assign && last->text == "="; last = &last->operands[1])
    targets.push_back(&last->operands[0]);
  if (targets.size() > 1) {
    for (const Expression* each : targets) {
      const Expression one{Kind::assign, "=", {*each, *last}, each->type, e.line};
      assign(one, depth);
    }
    return;
  }
  const Expression from = hoisted(e.operands[1], depth), to = hoisted(e.operands[0], depth);
  line(depth, value(to).text + " " + e.text + " " + as(from, to.type) + ";");
  if (to.type->kind == Type::Kind::pointer && from.kind == Kind::address) kept_[path(from).root] = place(to);
}

void FunctionWriter::choose(const Statement& s, int depth, const std::string& before) {
  const Expression holds = hoisted(s.values[0], depth);
  line(depth, before + "if " + condition(holds) + " {");
  write(s.body, depth + 1);
  if (s.otherwise.size() == 1 && s.otherwise[0].kind == Statement::Kind::choose)
    return choose(s.otherwise[0], depth, "} else ");
  if (!s.otherwise.empty()) {
    line(depth, "} else {");
    write(s.otherwise, depth + 1);
  }
  line(depth, "}");
}

void FunctionWriter::body(const Statement& loop, int depth) { write(loop.body, depth + 1); }

namespace {

bool names(const Expression& e, const std::string& name) { return e.kind == Kind::name && e.text == name; }

}  // namespace

/// Prints a loop over a range, if it is one: neither its variable nor its end changes inside.
bool FunctionWriter::counted(const Statement& s, int depth) {
  if (s.first.size() != 1 || s.first[0].values.empty()) return false;
  const std::string& variable = s.first[0].name;
  blocks::Function inside = function_;
  inside.body = s.body;
  const std::set<std::string> changed = blocks::changed_names(context_.unit, context_.shapes, inside);
  const auto is_fixed = [&](const Expression& e) {
    bool fixed = true;
    blocks::for_each(e, [&](const Expression& part) {
      if (part.kind == Kind::call || part.kind == Kind::before || part.kind == Kind::after) fixed = false;
      if (part.kind == Kind::name &&
          changed.count(blocks::root_of(alias(part) ? *alias(part) : part).text) > 0)
        fixed = false;
    });
    return fixed;
  };
  const Expression& until = s.values[0];
  if (changed.count(variable) > 0 || until.kind != Kind::binary) return false;
  const Expression& first = s.first[0].values[0];
  std::string range;
  const bool goes_down = s.values.size() == 1 && until.text == ">" && until.operands[0].kind == Kind::after &&
                         names(until.operands[0].operands[0], variable);
  if (goes_down) {
    const Expression& least = until.operands[1];
    range = "(" + as(least, first.type) + ".." + as(first, first.type) + ").rev()";
  } else {
    const bool goes_up = s.values.size() == 2 && until.text == "<" && names(until.operands[0], variable) &&
                         s.values[1].kind == Kind::before && s.values[1].text == "++";
    if (!goes_up || !is_fixed(until.operands[1])) return false;
    range = as(first, first.type) + ".." + within(until.operands[1], 5, first.type);
  }
  bool is_read = false;
  blocks::for_each(s.body, [&](const Expression& each) { is_read = is_read || names(each, variable); });
  line(depth, "for " + (is_read ? value_name(variable) : "_") + " in " + range + " {");
  counters_.insert(variable);
  steps_.emplace_back();
  body(s, depth);
  steps_.pop_back();
  counters_.erase(variable);
  line(depth, "}");
  return true;
}

void FunctionWriter::loop_for(const Statement& s, int depth) {
  if (counted(s, depth)) return;
  line(depth, "{");
  for (const Statement& each : s.first) {
    const std::set<std::string> before = changed_;
    write(each, depth + 1);
  }
  const Expression& until = s.values[0];
  const std::size_t here = lines_.size();
  const Expression plain = hoisted(until, depth + 2);
  std::vector<std::string> steps(lines_.begin() + static_cast<std::ptrdiff_t>(here), lines_.end());
  lines_.resize(here);
  if (until.kind == Kind::boolean) {
    line(depth + 1, "loop {");
  } else if (steps.empty()) {
    line(depth + 1, "while " + condition(plain) + " {");
  } else {
    line(depth + 1, "while {");
    lines_.insert(lines_.end(), steps.begin(), steps.end());
    line(depth + 2, condition(plain));
    line(depth + 1, "} {");
  }
  std::string step;
  if (s.values.size() == 2) {
    const std::size_t mark = lines_.size();
    evaluate(s.values[1], 0);
    step = lines_.back();
    lines_.resize(mark);
  }
  steps_.push_back(step);
  body(s, depth + 1);
  steps_.pop_back();
  if (!step.empty()) line(depth + 2, step);
  line(depth + 1, "}");
  line(depth, "}");
}

void FunctionWriter::give(const Statement& s, int depth) {
  if (!returns_last_) {
    if (s.values.empty()) return line(depth, "return;");
    return line(depth, "return " + as(hoisted(s.values[0], depth), function_.result) + ";");
  }
  if (!s.values.empty() && s.values[0].kind == Kind::call) evaluate(s.values[0], depth);
  line(depth, "return " + value_name(function_.parameters.back().name) + ";");
}

}  // namespace qvgen::emit::rust
