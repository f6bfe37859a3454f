// SPDX-License-Identifier: MIT
#include "emit/kernels/kernels.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "emit/blocks/analysis.h"
#include "emit/kernels/device_text.h"
#include "emit/kernels/inverse.h"
#include "emit/render.h"

namespace qvgen::emit::kernels {
namespace {

using blocks::Type;
using blocks::TypeRef;
using nlohmann::json;

/// Sizes of an array that a parameter leads to: {6, 7} for double x[6][7], none for a structure.
std::vector<int> sizes_of(const TypeRef& pointer) {
  std::vector<int> sizes;
  if (pointer->size > 0) sizes.push_back(pointer->size);
  for (TypeRef type = pointer->of; type->kind == Type::Kind::array; type = type->of)
    sizes.push_back(type->size);
  return sizes;
}

bool is_array(const blocks::Field& each) {
  return each.type->kind == Type::Kind::pointer && !sizes_of(each.type).empty();
}
bool is_structure(const blocks::Field& each) {
  return each.type->kind == Type::Kind::pointer && each.type->of->kind == Type::Kind::structure;
}

/// True for a structure without constants, or of no description.
bool is_empty(const blocks::Unit& unit, const blocks::Field& each) {
  const auto found = unit.structures.find(each.type->of->name);
  return found == unit.structures.end() || blocks::has_no_constants(found->second);
}

std::string brackets(const std::vector<int>& sizes) {
  std::string text;
  for (const int size : sizes) text += fmt::format("[{}]", size);
  return text;
}

json argument(const blocks::Unit& unit, const blocks::Field& each) {
  json values{{"name", each.name},
              {"is_row", false},
              {"is_number", false},
              {"is_struct", false},
              {"is_empty", false}};
  if (is_array(each)) {
    const auto sizes = sizes_of(each.type);
    values["is_row"] = true;
    values["size"] = std::accumulate(sizes.begin(), sizes.end(), 1, std::multiplies<>());
  } else if (is_structure(each)) {
    values[is_empty(unit, each) ? "is_empty" : "is_struct"] = true;
    values["type"] = each.type->of->name;
  } else {
    values["is_number"] = true;
  }
  values["handed_on"] = (is_structure(each) ? "&" : "") + each.name + (is_array(each) ? "_" : "");
  return values;
}

/// Values of a kernel; nothing for a function that has no rows.
json kernel(const blocks::Unit& unit, const blocks::Function& function) {
  const bool gives_last = blocks::returns_last(function);
  json values{{"function", function.name}, {"arguments", json::array()}};
  bool has_rows = false;
  const std::size_t count = function.parameters.size() - (gives_last ? 1 : 0);
  std::string call;
  for (std::size_t i = 0; i < count; ++i) {
    values["arguments"].push_back(argument(unit, function.parameters[i]));
    has_rows = has_rows || values["arguments"].back()["is_row"];
    call += (i == 0 ? "" : ", ") + values["arguments"].back()["handed_on"].get<std::string>();
  }
  if (!has_rows) return {};
  values["lines"] = json::array();
  const auto add = [&](const std::string& line) { values["lines"].push_back({{"line", line}}); };
  for (const json& each : values["arguments"]) {
    const std::string name = each["name"];
    if (each["is_row"]) {
      add(fmt::format("double {}_[{}];", name, each["size"].get<int>()));
      add(fmt::format("for (int i = 0; i < {0}; ++i) {1}_[i] = {1}[i * n + k];", each["size"].get<int>(),
                      name));
    }
    if (each["is_empty"]) add(fmt::format("const {} {} = {{ 0 }};", each["type"].get<std::string>(), name));
  }
  if (!gives_last) {
    add(fmt::format("result[k] = {}({});", function.name, call));
    return values;
  }
  const blocks::Field& last = function.parameters.back();
  const std::string reference = is_array(last) ? "result_" : "&result_";
  add(is_array(last) ? "double result_" + brackets(sizes_of(last.type)) + ";"
                     : last.type->of->name + " result_;");
  add(fmt::format("{}({}, {});", function.name, call, reference));
  add("for (int i = 0; i < (int)(sizeof result_ / sizeof(double)); ++i)");
  add(fmt::format("  result[i * n + k] = ((const double*){})[i];", reference));
  return values;
}

bool is_kernel(const blocks::Function& function) {
  const bool gives_number = function.result->kind == Type::Kind::real && !blocks::returns_last(function);
  return function.is_public && function.is_defined && function.module.empty() &&
         (gives_number || blocks::returns_last(function));
}

}  // namespace

std::string file(const Target& target, const blocks::Unit& unit, const Sources& c,
                 const std::vector<std::string>& missing) {
  json values{{"name", unit.robot}, {"kernels", json::array()}, {"has_missing", !missing.empty()}};
  values["real"] = target.in_float ? "float" : "double";
  values["missing"] = json::array();
  for (const std::string& line : missing) values["missing"].push_back({{"line", line}});
  values["text"] = device_text(unit.robot, c.header) + device_text(unit.robot, c.source);
  values["inverse"] = inverse_text(unit, c.inverse_header, c.inverse_source);
  for (const blocks::Function& function : unit.functions)
    if (is_kernel(function))
      if (const json each = kernel(unit, function); !each.is_null()) values["kernels"].push_back(each);
  const bool has_inverse = !values["inverse"].get<std::string>().empty();
  values["head"] = render(target.device == Device::opencl ? "kernels/opencl.head" : "kernels/cuda.head",
                          {{"has_inverse", has_inverse}, {"in_float", target.in_float}});
  return render("kernels/file", values);
}

}  // namespace qvgen::emit::kernels
