// SPDX-License-Identifier: MIT
#include "emit/javascript/batch.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "emit/builtin_templates.h"
#include "emit/columns/call.h"
#include "emit/javascript/declarations.h"
#include "emit/javascript/names.h"
#include "emit/render.h"
#include "emit/template_values.h"

namespace qvgen::emit::javascript {
namespace {

using blocks::Type;
using columns::Input;
using columns::Output;
using columns::Signature;
using nlohmann::json;

std::string joined(const Lines& texts, const char* between = ", ") {
  return fmt::format("{}", fmt::join(texts, between));
}

/// Name of a result as the single function's has it: "effort.used_up" gives usedUp.
std::string result_name(const Output& output) {
  return camel(output.place.substr(output.place.rfind('.') + 1));
}

/// Numbers of a result for one configuration.
int size_of(const Output& output, const Signature& signature) {
  const int one = std::accumulate(output.sizes.begin(), output.sizes.end(), 1, std::multiplies<>());
  return output.is_in_rows ? one * signature.row_capacity : one;
}

/// The argument as the module of batches hands it over.
std::string input_text(const blocks::Unit& unit, const Input& input, const std::string& name) {
  if (input.kind == Input::Kind::number) return fmt::format("number({})", name);
  if (input.kind == Input::Kind::row)
    return fmt::format("rows(\"{}\", {}, {})", camel(input.name), name, input.size);
  const blocks::Structure& structure = unit.structures.at(input.structure);
  Lines fields;
  for (const blocks::Field& each : structure.fields)
    fields.push_back(name + "." + field_name(structure, each.name));
  return fmt::format("fields({} === null ? null : [{}])", name, joined(fields));
}

std::string output_text(const Output& output, const Signature& signature) {
  return fmt::format("{{ name: \"{}\", size: {}, isWhole: {}, isInRows: {} }}", result_name(output),
                     size_of(output, signature), output.is_whole, output.is_in_rows);
}

/// Lines on the shapes of arguments and results.
Lines shapes_doc(const Signature& signature) {
  Lines inputs, outputs;
  for (const Input& each : signature.inputs)
    if (each.kind == Input::Kind::row) inputs.push_back(fmt::format("{} {}", camel(each.name), each.size));
  for (const Output& each : signature.outputs) {
    const std::string own = fmt::format("{} {}", result_name(each), size_of(each, signature));
    outputs.push_back(each.is_in_rows ? own + fmt::format(" (of {} rows)", signature.row_capacity) : own);
  }
  return {"", "Numbers of a configuration, which stand one behind the other: " + joined(inputs) +
                  ". Of the result: " + joined(outputs) + "."};
}

class BatchWriter {
 public:
  explicit BatchWriter(const blocks::Unit& unit) : unit_(unit), shapes_(unit), context_{unit, shapes_} {
    for (const blocks::Function& each : unit.functions)
      if (auto signature = columns::signature_of(unit, shapes_, each))
        signatures_.push_back(in_order_of_c(*signature));
  }

  json functions_in_c() const {
    json list = json::array();
    for (const Signature& each : signatures_)
      list.push_back({{"name", each.name},
                      {"input_count", each.inputs.size()},
                      {"output_count", each.outputs.size()},
                      {"lines", lines_of(columns::lines_of_call(unit_, each))}});
    return list;
  }

  std::string functions() const {
    Lines lines;
    for (std::size_t i = 0; i < signatures_.size(); ++i) add_function(i, lines);
    return joined(lines, "\n") + "\n";
  }

  std::string declarations() const {
    Lines lines;
    for (const Signature& each : signatures_) {
      add_doc(each, lines);
      lines.push_back(fmt::format("export function {}({}): {};", function_name(unit_, *each.function),
                                  parameters_text(context_, *each.function), result_type(each)));
    }
    return joined(lines, "\n") + "\n";
  }

  /// Constants that arguments have by default.
  std::string imports() const {
    std::set<std::string> names;
    for (const Signature& each : signatures_)
      for (const std::string& text : FunctionWriter(context_, *each.function).parameters())
        if (const auto at = text.find(" = default"); at != std::string::npos)
          names.insert(text.substr(at + 3));
    return joined({names.begin(), names.end()});
  }

  std::string types() const {
    std::set<std::string> names;
    for (const Signature& each : signatures_)
      for (const blocks::Field& field : each.function->parameters)
        if (field.type->kind == Type::Kind::pointer && field.type->of->kind == Type::Kind::structure &&
            field.type->constant)
          names.insert(type_name(unit_, field.type->of->name));
    return joined({names.begin(), names.end()});
  }

 private:
  static Signature in_order_of_c(Signature signature) {
    std::stable_sort(signature.inputs.begin(), signature.inputs.end(),
                     [](const Input& a, const Input& b) { return a.place < b.place; });
    return signature;
  }

  void add_doc(const Signature& signature, Lines& lines) const {
    Lines doc = signature.function->doc;
    for (const std::string& each : shapes_doc(signature)) doc.push_back(each);
    lines.emplace_back();
    for (const std::string& each : documented(doc, "", unit_.robot, true)) lines.push_back(each);
  }

  void add_function(std::size_t place, Lines& lines) const {
    const Signature& signature = signatures_[place];
    Lines inputs, outputs;
    const Lines parameters = FunctionWriter(context_, *signature.function).parameters();
    for (const Input& each : signature.inputs) {
      const std::string& own = parameters[each.place];
      inputs.push_back(input_text(unit_, each, own.substr(0, own.find(" = "))));
    }
    for (const Output& each : signature.outputs) outputs.push_back(output_text(each, signature));
    add_doc(signature, lines);
    lines.push_back(fmt::format("export function {}({}) {{", function_name(unit_, *signature.function),
                                joined(parameters)));
    lines.push_back(fmt::format("  return run({}, [{}], [", place, joined(inputs)));
    lines.push_back("    " + joined(outputs, ",\n    "));
    lines.emplace_back("  ]);");
    lines.emplace_back("}");
  }

  static std::string result_type(const Signature& signature) {
    const auto type = [](const Output& each) { return each.is_whole ? "Int32Array" : "Float64Array"; };
    if (signature.outputs.size() == 1) return type(signature.outputs[0]);
    Lines fields;
    for (const Output& each : signature.outputs) fields.push_back(result_name(each) + ": " + type(each));
    return "{ " + joined(fields, "; ") + " }";
  }

  const blocks::Unit& unit_;
  blocks::Shapes shapes_;
  Context context_;
  std::vector<Signature> signatures_;
};

}  // namespace

Files batch_files(const blocks::Unit& unit, const std::vector<blocks::File>& c) {
  const BatchWriter writer(unit);
  const std::string name = "qvgen_" + unit.robot;
  json values{{"name", unit.robot},          {"functions", writer.functions_in_c()},
              {"imports", writer.imports()}, {"types", writer.types()},
              {"body", writer.functions()},  {"declarations", writer.declarations()},
              {"headers", json::array()}};
  Files files;
  for (const blocks::File& each : c) {
    if (each.is_header) values["headers"].push_back({{"header", each.name}});
    files.push_back({"source/" + each.name, each.text});
  }
  for (const char* each : {"math.h", "string.h"})
    files.push_back({std::string("source/") + each, builtin_templates().at(std::string("wasm/") + each)});
  files.push_back({"source/batch.c", render("javascript/batch.c", values)});
  files.push_back({"build.mjs", render("javascript/build.mjs", values)});
  files.push_back({name + "_batch.mjs", render("javascript/batch.mjs", values)});
  files.push_back({name + "_batch.d.mts", render("javascript/batch.d.mts", values)});
  return files;
}

}  // namespace qvgen::emit::javascript
