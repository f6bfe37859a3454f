// SPDX-License-Identifier: MIT
#include "emit/octave/gateway.h"

#include <set>

#include <fmt/format.h>

#include "emit/columns/call.h"
#include "emit/render.h"
#include "emit/template_values.h"

namespace qvgen::emit::octave {
namespace {

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

json function_values(const blocks::Unit& unit, const Signature& signature) {
  json values{{"name", signature.name},
              {"inputs", json::array()},
              {"outputs", json::array()},
              {"input_count", signature.inputs.size()},
              {"output_count", signature.outputs.size()},
              {"lines", lines_of(columns::lines_of_call(unit, signature))}};
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
