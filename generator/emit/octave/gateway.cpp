// SPDX-License-Identifier: MIT
#include "emit/octave/gateway.h"

#include <set>

#include <fmt/format.h>

#include "emit/render.h"
#include "emit/template_values.h"

namespace qvgen::emit::octave {
namespace {

using blocks::Type;
using nlohmann::json;

/// Name of the list of a structure's fields.
std::string fields_name(const std::string& structure) { return structure + "_fields"; }

json input_values(const Input& input) {
  const bool is_structure = input.kind == Input::Kind::structure;
  const std::string usual = input.usual.empty() ? "NULL"
                            : is_structure      ? "(const double*)&" + input.usual
                                                : "&" + input.usual;
  return {{"name", input.name},
          {"size", input.size},
          {"fields", is_structure ? fields_name(input.structure) : "NULL"},
          {"usual", usual},
          {"may_lack", input.may_lack ? 1 : 0}};
}

json output_values(const Output& output, int capacity) {
  std::vector<int> sizes = output.sizes;
  if (output.is_in_rows) sizes.push_back(capacity);
  if (sizes.empty()) sizes.push_back(1);
  return {{"is_in_rows", output.is_in_rows ? 1 : 0},
          {"rank", sizes.size()},
          {"sizes", fmt::format("{}", fmt::join(sizes, ", "))}};
}

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

json lines_of_call(const blocks::Unit& unit, const Signature& signature) {
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
  return lines_of(lines);
}

json function_values(const blocks::Unit& unit, const Signature& signature) {
  json values{{"name", signature.name},
              {"inputs", json::array()},
              {"outputs", json::array()},
              {"input_count", signature.inputs.size()},
              {"output_count", signature.outputs.size()},
              {"lines", lines_of_call(unit, signature)}};
  for (const Input& each : signature.inputs) values["inputs"].push_back(input_values(each));
  for (const Output& each : signature.outputs)
    values["outputs"].push_back(output_values(each, signature.row_capacity));
  return values;
}

/// Names of the fields of structures that are handed over, once each.
json structures(const blocks::Unit& unit, const std::vector<Signature>& signatures) {
  json list = json::array();
  std::set<std::string> known;
  for (const Signature& signature : signatures)
    for (const Input& each : signature.inputs) {
      if (each.kind != Input::Kind::structure || !known.insert(each.structure).second) continue;
      std::string names;
      for (const blocks::Field& field : unit.structures.at(each.structure).fields)
        names += (names.empty() ? "\"" : ", \"") + field.name + "\"";
      list.push_back({{"fields_name", fields_name(each.structure)}, {"fields", names}});
    }
  return list;
}

}  // namespace

std::string gateway(const blocks::Unit& unit, const std::vector<Signature>& signatures,
                    const std::vector<std::string>& headers) {
  json values{{"name", unit.robot},
              {"headers", json::array()},
              {"structures", structures(unit, signatures)},
              {"functions", json::array()}};
  for (const std::string& each : headers) values["headers"].push_back({{"header", each}});
  for (const Signature& each : signatures) values["functions"].push_back(function_values(unit, each));
  return render("octave/fast.c", values);
}

}  // namespace qvgen::emit::octave
