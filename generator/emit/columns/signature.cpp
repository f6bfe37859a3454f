// SPDX-License-Identifier: MIT
#include "emit/columns/signature.h"

#include <algorithm>

#include "emit/blocks/types.h"

namespace qvgen::emit::columns {
namespace {

using blocks::Type;
using blocks::TypeRef;

/// Thrown for what cannot be handed over; a function with it is left to other languages.
struct NotCallable {};

class SignatureReader {
 public:
  SignatureReader(const blocks::Unit& unit, const blocks::Shapes& shapes, const blocks::Function& function)
      : unit_(unit), shapes_(shapes.of(function.name)), function_(function) {
    result_.function = &function;
    result_.name = blocks::without_robot(function.name, unit.robot);
  }

  Signature read() {
    const bool gives_last = blocks::returns_last(function_);
    const std::size_t count = function_.parameters.size() - (gives_last ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) add_input(i);
    order_inputs();
    if (gives_last)
      add_result(function_.parameters.back());
    else if (function_.result->kind == Type::Kind::real)
      result_.outputs.push_back({"result", "result", {}, false, false});
    else
      throw NotCallable{};
    name_apart();
    return std::move(result_);
  }

 private:
  void add_input(std::size_t i) {
    const blocks::Field& each = function_.parameters[i];
    Input input;
    input.name = each.name;
    input.place = i;
    if (each.type->kind == Type::Kind::real) {
      input.kind = Input::Kind::number;
      input.usual = usual_number(each.name);
    } else if (each.type->kind != Type::Kind::pointer || shapes_[i].changed) {
      throw NotCallable{};
    } else if (each.type->of->kind == Type::Kind::structure) {
      if (!describe_structure(each, input)) return;
    } else if (each.type->of->kind == Type::Kind::real && shapes_[i].size > 0) {
      input.size = shapes_[i].size;
    } else {
      throw NotCallable{};
    }
    input.may_lack = shapes_[i].optional || !input.usual.empty();
    result_.inputs.push_back(input);
  }

  /// Constant that a number has by default, in C; gravity is that of the other languages.
  std::string usual_number(const std::string& name) const {
    if (name == "gravity") return "standard_gravity";
    return name == "tolerance" ? constant("default_tolerance") : "";
  }

  std::string constant(const std::string& name) const {
    const std::string own = unit_.robot + "_" + name;
    return unit_.constant(own) != nullptr ? own : "";
  }

  /// False for a structure without constants.
  bool describe_structure(const blocks::Field& each, Input& input) const {
    const blocks::Structure& structure = unit_.structures.at(each.type->of->name);
    if (blocks::has_no_constants(structure)) return false;
    const bool has_numbers =
        std::all_of(structure.fields.begin(), structure.fields.end(),
                    [](const auto& field) { return field.type->kind == Type::Kind::real; });
    if (!has_numbers) throw NotCallable{};
    input.kind = Input::Kind::structure;
    input.structure = structure.name;
    input.size = static_cast<int>(structure.fields.size());
    input.usual = constant("default_" + blocks::without_robot(structure.name, unit_.robot));
    return true;
  }

  /// Numbers with a default and structures go to the end, behind what has to be given.
  void order_inputs() {
    const auto rank = [](const Input& each) {
      return each.kind == Input::Kind::structure ? 2 : each.usual.empty() ? 0 : 1;
    };
    std::stable_sort(result_.inputs.begin(), result_.inputs.end(),
                     [&](const Input& a, const Input& b) { return rank(a) < rank(b); });
  }

  void add_result(const blocks::Field& last) {
    const TypeRef type = blocks::pointee(last);
    if (type->kind == Type::Kind::structure)
      add_fields(unit_.structures.at(type->name), last.name, false);
    else
      add_leaf(last.name, last.name, type, false);
    const auto rank = [](const Output& each) { return each.is_in_rows ? (each.is_whole ? 2 : 0) : 1; };
    std::stable_sort(result_.outputs.begin(), result_.outputs.end(),
                     [&](const Output& a, const Output& b) { return rank(a) < rank(b); });
  }

  void add_fields(const blocks::Structure& structure, const std::string& place, bool is_in_rows) {
    for (const blocks::Field& each : structure.fields) {
      const std::string own = place + "." + each.name;
      const bool is_rows =
          each.type->kind == Type::Kind::array && each.type->of->kind == Type::Kind::structure;
      if (is_rows) {
        if (is_in_rows || result_.row_capacity > 0) throw NotCallable{};
        result_.row_capacity = each.type->size;
        result_.row_count = place + ".count";
        add_fields(unit_.structures.at(each.type->of->name), own + "[k]", true);
      } else if (each.type->kind == Type::Kind::structure) {
        add_fields(unit_.structures.at(each.type->name), own, is_in_rows);
      } else {
        add_leaf(each.name, own, each.type, is_in_rows);
      }
    }
  }

  void add_leaf(const std::string& name, const std::string& place, const TypeRef& whole, bool is_in_rows) {
    Output output{name, place, {}, false, is_in_rows};
    TypeRef type = whole;
    for (; type->kind == Type::Kind::array; type = type->of) output.sizes.push_back(type->size);
    if (!blocks::is_number(type)) throw NotCallable{};
    output.is_whole = type->kind != Type::Kind::real;
    result_.outputs.push_back(output);
  }

  /// A result that has the name of an argument gets an underscore.
  void name_apart() {
    for (Output& output : result_.outputs)
      for (const Input& input : result_.inputs)
        if (input.name == output.name) output.name += "_";
  }

  const blocks::Unit& unit_;
  const std::vector<blocks::Shape>& shapes_;
  const blocks::Function& function_;
  Signature result_;
};

}  // namespace

std::optional<Signature> signature_of(const blocks::Unit& unit, const blocks::Shapes& shapes,
                                      const blocks::Function& function) {
  if (!function.is_public || !function.is_defined) return std::nullopt;
  try {
    return SignatureReader(unit, shapes, function).read();
  } catch (const NotCallable&) {
    return std::nullopt;
  }
}

}  // namespace qvgen::emit::columns
