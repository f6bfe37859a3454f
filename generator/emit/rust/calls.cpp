// SPDX-License-Identifier: MIT
// Calls. Rust lets no reference lead to what another one may change: arguments that would are copied before
// the call, and of two results in one object the second is copied back behind it.
#include "emit/rust/names.h"
#include "emit/rust/writer.h"

namespace qvgen::emit::rust {

using blocks::Expression;
using blocks::Shape;
using blocks::Type;
using blocks::TypeRef;
using Kind = Expression::Kind;

std::string function_name(const blocks::Unit& unit, const blocks::Function& function) {
  const bool is_taken = !function.is_public && blocks::has_public_twin(unit, function.name);
  return value_name(function.name, unit.robot) + (is_taken ? "_inside" : "");
}

FunctionWriter::Path FunctionWriter::path(const Expression& e) {
  if (const Expression* other = alias(e)) return path(*other);
  switch (e.kind) {
    case Kind::address:
    case Kind::dereference:
    case Kind::cast:
    case Kind::binary:
      return path(e.operands[0]);
    case Kind::member: {
      Path result = path(e.operands[0]);
      result.steps.push_back("." + e.text);
      return result;
    }
    case Kind::index: {
      Path result = path(e.operands[0]);
      result.steps.push_back("[" + index(e) + "]");
      return result;
    }
    case Kind::name:
      return {context_.unit.constant_of(e) != nullptr ? "" : e.text, {}};
    default:
      return {};
  }
}

/// Different fields do not overlap; different indices may be the same number.
bool FunctionWriter::overlap(const Path& a, const Path& b) const {
  if (a.root.empty() || a.root != b.root) return false;
  for (std::size_t i = 0; i < std::min(a.steps.size(), b.steps.size()); ++i)
    if (a.steps[i] != b.steps[i] && a.steps[i][0] == '.') return false;
  return true;
}

/// A reference to what a pointer leads to.
std::string FunctionWriter::reference(const Expression& e, const Shape& shape) {
  if (const Expression* other = alias(e)) return reference(*other, shape);
  const std::string mark = shape.changed ? "&mut " : "&";
  // One object where an array is wanted is an array of one.
  if (e.kind == Kind::address && shape.many)
    return std::string("core::slice::") + (shape.changed ? "from_mut(" : "from_ref(") + mark +
           place(e.operands[0]) + ")";
  if (e.kind == Kind::address) return mark + place(e.operands[0]);
  if (e.kind == Kind::conditional)
    return "if " + condition(e.operands[0]) + " { " + reference(e.operands[1], shape) + " } else { " +
           reference(e.operands[2], shape) + " }";
  if (e.kind == Kind::binary)
    return mark + place(e.operands[0]) + "[" + index({Kind::index, "", {e, e.operands[1]}}) + "..]";
  if (e.kind == Kind::name && e.type->kind == Type::Kind::pointer && context_.unit.constant_of(e) == nullptr)
    return is_optional(e) ? value_name(e.text) + ".unwrap()" : value_name(e.text);
  if (e.kind == Kind::member && e.type->kind == Type::Kind::pointer) return mark + place(e);
  return mark + place(e);
}

std::string FunctionWriter::argument(const Expression& e, const TypeRef& wanted, const Shape& shape) {
  if (wanted->kind != Type::Kind::pointer) return as(e, wanted);
  if (!shape.optional) return reference(e, shape);
  if (e.kind == Kind::null) return "None";
  if (is_optional(e)) return value_name(e.text);
  if (e.kind == Kind::conditional)
    return "if " + condition(e.operands[0]) + " { " + argument(e.operands[1], wanted, shape) + " } else { " +
           argument(e.operands[2], wanted, shape) + " }";
  return "Some(" + reference(e, shape) + ")";
}

/// A copy of what a constant pointer leads to.
std::string FunctionWriter::copied(const Expression& e) {
  if (const Expression* other = alias(e)) return copied(*other);
  if (e.kind == Kind::address) return place(e.operands[0]);
  if (e.type->kind == Type::Kind::array || e.kind == Kind::member) return place(e);
  const auto own = parameters_.find(e.text);
  const bool has_size =
      e.kind == Kind::name && own != parameters_.end() && (!own->second.many || own->second.size > 0);
  if (!has_size)
    throw blocks::NotInSubset(function_.name + ": an argument of " + e.text +
                              " overlaps what the call changes, and has no size: say it in the parameter, " +
                              e.text + "[3]");
  return "*" + place(e);
}

std::string FunctionWriter::library_call(const Expression& e) {
  std::string list;
  for (const Expression& each : e.operands)
    list += (list.empty() ? "" : ", ") + as(each, blocks::basic(Type::Kind::real));
  return value_name(e.text) + "(" + list + ")";
}

/// Sorts the arguments that a call changes: those that overlap an earlier one are copied back behind the
/// call.
FunctionWriter::Changes FunctionWriter::changes_of(const Expression& e, std::size_t count) {
  const std::vector<Shape>& shapes = context_.shapes.of(e.text);
  Changes result;
  result.copies_back.resize(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    if (!shapes[i].changed) continue;
    const Path own = path(e.operands[i]);
    for (const Path& other : result.paths) {
      if (!overlap(own, other)) continue;
      if (own.steps.size() != other.steps.size())
        throw blocks::NotInSubset(function_.name + ": " + e.text +
                                  " gets an object to change and a part of it: give it the parts");
      result.copies_back[i] = true;
    }
    if (!result.copies_back[i]) result.paths.push_back(own);
  }
  return result;
}

bool FunctionWriter::reads(const Expression& argument, const std::vector<Path>& changed) {
  bool found = false;
  blocks::for_each(argument, [&](const Expression& part) {
    if (part.kind != Kind::name) return;
    const Path own = path(part);
    found = found ||
            std::any_of(changed.begin(), changed.end(), [&](const Path& each) { return overlap(own, each); });
  });
  return found;
}

/// Text of an argument, with what is done in front of the call and behind it.
std::string FunctionWriter::prepared(const Expression& each, const TypeRef& wanted, const Shape& shape,
                                     const Changes& changes, bool copies_back, CallText& text) {
  const bool is_pointer = wanted->kind == Type::Kind::pointer;
  const Path own = path(each);
  const bool overlaps = std::any_of(changes.paths.begin(), changes.paths.end(),
                                    [&](const Path& other) { return overlap(own, other); });
  const bool copies_pointer = is_pointer && !shape.changed && overlaps;
  const bool copies_value = !is_pointer && reads(each, changes.paths);
  if (!copies_back && !copies_pointer && !copies_value) return argument(each, wanted, shape);
  const std::string copy = "copy" + std::to_string(names_++);
  if (copies_back) {
    text.before += "let mut " + copy + " = " + copied(each) + "; ";
    text.behind += copied(each) + " = " + copy + "; ";
    return "&mut " + copy;
  }
  if (copies_pointer) {
    text.before += "let " + copy + " = " + copied(each) + "; ";
    return shape.optional ? "Some(&" + copy + ")" : "&" + copy;
  }
  text.before +=
      "let " + copy + ": " + type_text(wanted, context_) + " = " + argument(each, wanted, shape) + "; ";
  return copy;
}

std::string FunctionWriter::call(const Expression& e) {
  const blocks::Function* callee = context_.unit.function(e.text);
  if (callee == nullptr) return library_call(e);
  const std::vector<Shape>& shapes = context_.shapes.of(e.text);
  const std::size_t count = e.operands.size() - (blocks::returns_last(*callee) ? 1 : 0);
  const Changes changes = changes_of(e, count);
  CallText text;
  std::string list;
  for (std::size_t i = 0; i < count; ++i)
    list += (i == 0 ? "" : ", ") + prepared(e.operands[i], callee->parameters[i].type, shapes[i], changes,
                                            changes.copies_back[i], text);
  const bool is_elsewhere = callee->module != function_.module;
  const std::string result = (is_elsewhere ? context_.scalar.root + "::" : "") +
                             function_name(context_.unit, *callee) + "(" + list + ")";
  if (!text.behind.empty() && callee->result->kind == Type::Kind::nothing)
    return "{ " + text.before + result + "; " + text.behind + "}";
  if (!text.behind.empty())
    return "{ " + text.before + "let result = " + result + "; " + text.behind + "result }";
  return text.before.empty() ? result : "{ " + text.before + result + " }";
}

}  // namespace qvgen::emit::rust
