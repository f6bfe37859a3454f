// SPDX-License-Identifier: MIT
#include "emit/columns/call.h"

#include <fmt/format.h>

namespace qvgen::emit::columns {
namespace {

using blocks::Type;

/// The arguments in the order of C.
std::string arguments(const blocks::Unit& unit, const Signature& signature) {
  const blocks::Function& function = *signature.function;
  const bool gives_last = blocks::returns_last(function);
  std::vector<std::string> texts;
  for (const blocks::Field& each : function.parameters) {
    const bool is_structure =
        each.type->kind == Type::Kind::pointer && each.type->of->kind == Type::Kind::structure;
    // A structure without constants, which the code does not read.
    texts.push_back(is_structure ? "&" + unit.robot + "_default_" +
                                       blocks::without_robot(each.type->of->name, unit.robot)
                                 : "");
  }
  for (std::size_t i = 0; i < signature.inputs.size(); ++i) {
    const Input& input = signature.inputs[i];
    std::string& text = texts[input.place];
    text = fmt::format("in[{}]", i);
    if (input.kind == Input::Kind::number) text = "*" + text;
    if (input.kind == Input::Kind::structure) text = fmt::format("(const {}*){}", input.structure, text);
  }
  if (gives_last) {
    const blocks::Field& last = function.parameters.back();
    const bool is_array = last.type->size > 0 || last.type->of->kind == Type::Kind::array;
    texts.back() = (is_array ? "" : "&") + last.name;
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// Declares the result of C.
std::string declared(const blocks::Field& last) {
  blocks::TypeRef type = blocks::pointee(last);
  std::string sizes;
  for (; type->kind == Type::Kind::array; type = type->of) sizes += fmt::format("[{}]", type->size);
  return (type->kind == Type::Kind::structure ? type->name : "double") + " " + last.name + sizes + ";";
}

/// Puts an output into its array.
std::string put(const Output& output, std::size_t place) {
  int count = 1;
  for (const int size : output.sizes) count *= size;
  const std::string to = output.is_in_rows && count > 1 ? fmt::format("out[{}] + k * {}", place, count)
                         : output.is_in_rows            ? fmt::format("out[{}] + k", place)
                                                        : fmt::format("out[{}]", place);
  if (output.sizes.empty()) return fmt::format("*({}) = {};", to, output.place);
  if (output.is_whole) return fmt::format("put_whole({}, (const int*){}, {});", to, output.place, count);
  std::vector<int> sizes = output.sizes;
  sizes.resize(3, 1);
  return fmt::format("put({}, (const double*){}, {});", to, output.place, fmt::join(sizes, ", "));
}

}  // namespace

std::vector<std::string> lines_of_call(const blocks::Unit& unit, const Signature& signature) {
  std::vector<std::string> lines;
  const blocks::Function& function = *signature.function;
  const std::string call = fmt::format("{}({});", function.name, arguments(unit, signature));
  if (blocks::returns_last(function)) {
    lines.push_back(declared(function.parameters.back()));
    lines.push_back((function.result->kind == Type::Kind::nothing ? "" : "(void)") + call);
  } else {
    lines.push_back("const double result = " + call);
  }
  std::vector<std::string> in_rows;
  for (std::size_t i = 0; i < signature.outputs.size(); ++i)
    (signature.outputs[i].is_in_rows ? in_rows : lines).push_back(put(signature.outputs[i], i));
  if (!in_rows.empty()) lines.push_back(fmt::format("for (int k = 0; k < {}; ++k) {{", signature.row_count));
  for (const std::string& each : in_rows) lines.push_back("  " + each);
  if (!in_rows.empty()) lines.emplace_back("}");
  return lines;
}

}  // namespace qvgen::emit::columns
