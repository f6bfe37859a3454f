// SPDX-License-Identifier: MIT
#include "emit/octave/package.h"

#include <fmt/format.h>

#include "emit/blocks/documentation.h"
#include "emit/octave/gateway.h"
#include "emit/octave/straight.h"
#include "emit/render.h"
#include "emit/template_values.h"

namespace qvgen::emit::octave {
namespace {

using Lines = std::vector<std::string>;
using nlohmann::json;

std::string names_of(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The call as the comment shows it, and as the file declares it.
struct Call {
  std::string results, arguments;
};
Call call_of(const Signature& signature) {
  Lines results, arguments;
  for (const Output& each : signature.outputs) results.push_back(value_name(each.name));
  for (const Input& each : signature.inputs) arguments.push_back(value_name(each.name));
  const bool has_one = results.size() == 1;
  return {has_one ? results[0] : "[" + names_of(results) + "]", names_of(arguments)};
}

std::string shape_text(const Output& output, int capacity) {
  std::vector<int> sizes = output.sizes;
  if (output.is_in_rows) sizes.push_back(capacity);
  if (sizes.empty()) sizes.push_back(1);
  return fmt::format("{} x n", fmt::join(sizes, " x "));
}

std::string input_text(const Input& input) {
  const std::string lacks = !input.may_lack           ? ""
                            : input.usual.empty()     ? ", or []"
                            : input.name == "gravity" ? ", 9.80665 if it is left out"
                                                      : ", the description's if it is left out";
  if (input.kind == Input::Kind::structure) return input.name + ": structure of constants" + lacks;
  return fmt::format("{}: {} x n{}", input.name, input.size, lacks);
}

/// Lines of the comment: what the function does, and shapes.
Lines documented(const blocks::Unit& unit, const Signature& signature) {
  Lines lines = blocks::documentation(signature.function->doc, {unit.robot, "[]", 100, true});
  lines.emplace_back();
  for (const Input& each : signature.inputs) lines.push_back(input_text(each));
  for (const Output& each : signature.outputs)
    lines.push_back(each.name + ": " + shape_text(each, signature.row_capacity) +
                    (each.is_in_rows ? ", NaN behind the last row" : ""));
  for (std::string& each : lines) each.insert(0, each.empty() ? "%" : "% ");
  return lines;
}

/// Arguments that are left out get the constants of the description.
Lines usual_values(const blocks::Unit& unit, const Signature& signature) {
  Lines lines;
  for (std::size_t i = 0; i < signature.inputs.size(); ++i) {
    const Input& each = signature.inputs[i];
    if (each.usual.empty()) continue;
    const std::string name = value_name(each.name);
    const std::string value = each.name == "gravity"
                                  ? "9.80665"
                                  : fmt::format("getfield(qvgen_{}.model(), '{}')", unit.robot,
                                                blocks::without_robot(each.usual, unit.robot));
    lines.push_back(fmt::format("if nargin < {} || isempty({}), {} = {}; end", i + 1, name, name, value));
  }
  return lines;
}

std::string columns_line(const std::string& robot, const Signature& signature) {
  std::string list;
  for (const Input& each : signature.inputs)
    if (each.kind != Input::Kind::structure)
      list += fmt::format(", '{}', {}, {}", each.name, value_name(each.name), each.size);
  return fmt::format("n_columns = qvgen_{}.column_count('{}'{});", robot, signature.name, list);
}

std::string function_file(const blocks::Unit& unit, const Signature& signature) {
  const Call call = call_of(signature);
  json values{{"name", unit.robot},
              {"function", signature.name},
              {"results", call.results},
              {"arguments", call.arguments},
              {"doc", lines_of(documented(unit, signature))}};
  const auto body = straight_body(unit, signature);
  if (!body) return render("octave/compiled.m", values);
  Lines lines = usual_values(unit, signature);
  lines.push_back(columns_line(unit.robot, signature));
  lines.insert(lines.end(), body->begin(), body->end());
  values["body"] = lines_of(lines);
  return render("octave/function.m", values);
}

/// A structure's default values, with the names of its fields.
std::string structure_text(const blocks::Unit& unit, const blocks::Constant& constant) {
  const blocks::Structure& structure = unit.structures.at(constant.type->name);
  if (blocks::has_no_constants(structure)) return "struct()";
  const blocks::Expressions& values = constant.value.at(0).operands;
  std::string list;
  for (std::size_t i = 0; i < structure.fields.size(); ++i)
    list += fmt::format("{}'{}', {}", i == 0 ? "" : ", ", structure.fields[i].name,
                        i < values.size() ? constant_text(unit, values[i]) : "0");
  return "struct(" + list + ")";
}

std::string model_file(const blocks::Unit& unit) {
  Lines lines;
  for (const blocks::Constant& each : unit.constants) {
    if (!each.is_public || each.value.empty()) continue;
    for (const std::string& line : blocks::documentation(each.doc, {unit.robot, "[]", 100, false}))
      lines.push_back("% " + line);
    const bool is_structure = each.type->kind == blocks::Type::Kind::structure;
    lines.push_back(
        fmt::format("m.{} = {};", blocks::without_robot(each.name, unit.robot),
                    is_structure ? structure_text(unit, each) : constant_text(unit, each.value[0])));
  }
  return render("octave/model.m", {{"name", unit.robot}, {"body", lines_of(lines)}});
}

}  // namespace

std::vector<std::pair<std::string, std::string>> package(const blocks::Unit& unit,
                                                         const std::vector<blocks::File>& files,
                                                         const Lines& missing) {
  const blocks::Shapes shapes(unit);
  std::vector<Signature> signatures;
  std::vector<std::pair<std::string, std::string>> result;
  json contents = json::array();
  for (const blocks::Function& each : unit.functions) {
    const auto signature = columns::signature_of(unit, shapes, each);
    if (!signature) continue;
    signatures.push_back(*signature);
    result.emplace_back(signature->name + ".m", function_file(unit, *signature));
    contents.push_back({{"line", signature->name + "(" + call_of(*signature).arguments + ")"}});
  }
  Lines headers;
  for (const blocks::File& each : files) {
    if (each.is_header) headers.push_back(each.name);
    result.emplace_back("source/" + each.name, each.text);
  }
  result.emplace_back("source/fast.c", gateway(unit, signatures, headers));
  result.emplace_back("model.m", model_file(unit));
  const json values{{"name", unit.robot},
                    {"functions", contents},
                    {"has_missing", !missing.empty()},
                    {"missing", lines_of(missing)}};
  for (const char* each : {"Contents.m", "build.m", "column_count.m", "fast.m"})
    result.emplace_back(each, render(std::string("octave/") + each, values));
  return result;
}

}  // namespace qvgen::emit::octave
