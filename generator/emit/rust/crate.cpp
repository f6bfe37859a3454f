// SPDX-License-Identifier: MIT
// The files of a crate: types, constants and functions of each module in the order of the C.
#include "emit/rust/crate.h"

#include <algorithm>

#include "emit/blocks/documentation.h"
#include "emit/render.h"
#include "emit/rust/names.h"
#include "emit/rust/writer.h"

namespace qvgen::emit::rust {
namespace {

using blocks::Type;
using nlohmann::json;

/// Lines of documentation; brackets are no links.
Lines documented(const Lines& doc, const std::string& indent, const std::string& robot,
                 bool returns_last = false) {
  Lines result;
  for (std::string each : blocks::documentation(doc, {robot, "`None`", 110, returns_last})) {
    for (std::size_t at = each.find('['); at != std::string::npos; at = each.find('[', at + 2))
      each.insert(at, "\\");
    result.push_back(indent + "///" + (each.empty() ? "" : " ") + each);
  }
  return result;
}

class CrateWriter {
 public:
  explicit CrateWriter(const blocks::Unit& unit)
      : unit_(unit), shapes_(unit), context_{unit, shapes_}, used_(blocks::used_names(unit)) {}

  std::string module(const std::string& name) {
    lines_.clear();
    imports(name);
    for (const std::string& each : unit_.structure_order)
      if (const auto& structure = unit_.structures.at(each); structure.module == name) add(structure);
    for (const blocks::Constant& each : unit_.constants)
      if (each.module == name && (each.is_public || used_.count(each.name) > 0)) add(each);
    for (const blocks::Function& each : unit_.functions)
      if (each.module == name && each.is_defined) add(each);
    std::string text;
    for (const std::string& line : lines_) text += line + "\n";
    return text;
  }

 private:
  void add(const Lines& more) { lines_.insert(lines_.end(), more.begin(), more.end()); }
  void add(const std::string& line) { lines_.push_back(line); }

  /// Names of the crate's root that a module reads.
  void imports(const std::string& module) {
    if (module.empty()) return;
    Lines names;
    const auto all = text_of_uses(module);
    for (const std::string& each : unit_.structure_order)
      if (unit_.structures.at(each).module.empty() && all.types.count(each) > 0)
        names.push_back(type_name(each, unit_.robot));
    for (const blocks::Constant& each : unit_.constants)
      if (each.module.empty() && all.names.count(each.name) > 0)
        names.push_back(constant_name(each.name, unit_.robot));
    std::sort(names.begin(), names.end());
    std::string list;
    for (const std::string& each : names) list += (list.empty() ? "" : ", ") + each;
    if (!list.empty()) add("use crate::{" + list + "};");
  }

  struct Uses {
    std::set<std::string> types, names;
  };
  Uses text_of_uses(const std::string& module) const {
    Uses uses;
    const std::function<void(const blocks::TypeRef&)> use = [&](const blocks::TypeRef& type) {
      if (type->kind == Type::Kind::structure) uses.types.insert(type->name);
      if (type->of) use(type->of);
    };
    for (const auto& [name, structure] : unit_.structures)
      if (structure.module == module)
        for (const blocks::Field& field : structure.fields) use(field.type);
    for (const blocks::Function& function : unit_.functions) {
      if (function.module != module) continue;
      for (const blocks::Field& each : function.parameters) use(each.type);
      use(function.result);
      blocks::for_each_statement(function.body, [&](const blocks::Statement& each) {
        if (each.type) use(each.type);
      });
      blocks::for_each(function.body, [&](const blocks::Expression& each) {
        if (each.kind == blocks::Expression::Kind::name) uses.names.insert(each.text);
      });
    }
    return uses;
  }

  void add(const blocks::Structure& structure) {
    const std::string mark = structure.is_public ? "pub " : "", type = type_name(structure.name, unit_.robot);
    add("");
    add(documented(structure.doc, "", unit_.robot));
    add("#[derive(Clone, Copy, Debug, PartialEq)]");
    add(mark + "struct " + type + " {");
    std::string zero;
    for (const blocks::Field& each : structure.fields) {
      if (each.type->kind == Type::Kind::text) continue;
      add(documented(each.doc, "    ", unit_.robot));
      add("    " + mark + value_name(each.name) + ": " + type_text(each.type, unit_.robot) + ",");
      zero += (zero.empty() ? " " : ", ") + value_name(each.name) + ": " + zero_text(each.type, unit_.robot);
    }
    add("}");
    add("");
    add("impl " + type + " {");
    add("    /// All numbers zero.");
    add("    pub const ZERO: " + type + " = " + type + " {" + zero + " };");
    add("}");
  }

  void add(const blocks::Constant& constant) {
    if (constant.value.empty()) return;
    const std::string mark = constant.is_public ? "pub " : "";
    const blocks::Function none{};
    FunctionWriter writer(context_, none);
    if (!constant.doc.empty()) add("");
    add(documented(constant.doc, "", unit_.robot));
    const bool is_array = constant.type->kind == Type::Kind::array;
    add(mark + (is_array ? "static " : "const ") + constant_name(constant.name, unit_.robot) + ": " +
        type_text(constant.type, unit_.robot) + " = " +
        writer.constant_value(constant.value[0], constant.type) + ";");
  }

  void add(const blocks::Function& function) {
    add("");
    add(documented(function.doc, "", unit_.robot, blocks::returns_last(function)));
    add(FunctionWriter(context_, function).lines());
  }

  const blocks::Unit& unit_;
  blocks::Shapes shapes_;
  Context context_;
  std::set<std::string> used_;
  Lines lines_;
};

json lines_of_text(const std::vector<std::string>& lines) {
  json result = json::array();
  for (const std::string& line : lines) result.push_back({{"line", line}});
  return result;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> crate(const blocks::Unit& unit,
                                                       const std::vector<std::string>& missing) {
  CrateWriter writer(unit);
  json modules = json::array();
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string& each : unit.modules) {
    if (each.empty()) continue;
    json names = json::array();
    for (const auto& [name, structure] : unit.structures)
      if (structure.module == each && structure.is_public) names.push_back(type_name(name, unit.robot));
    for (const auto& constant : unit.constants)
      if (constant.module == each && constant.is_public)
        names.push_back(constant_name(constant.name, unit.robot));
    for (const auto& function : unit.functions)
      if (function.module == each && function.is_public && function.is_defined)
        names.push_back(value_name(function.name, unit.robot));
    std::string list;
    for (const json& name : names) list += (list.empty() ? "" : ", ") + name.get<std::string>();
    modules.push_back({{"module", each}, {"names", list}});
    files.push_back({"src/" + each + ".rs",
                     render("rust/module.rs", {{"name", unit.robot}, {"body", writer.module(each)}})});
  }
  const bool solves = blocks::has_module(unit, "inverse");
  const json values{{"name", unit.robot},
                    {"has_inverse", blocks::solves_poses(unit)},
                    {"has_metrics", solves},
                    {"body", writer.module("")},
                    {"modules", modules},
                    {"has_missing", !missing.empty()},
                    {"missing", lines_of_text(missing)}};
  files.push_back({"src/lib.rs", render("rust/lib.rs", values)});
  files.push_back({"src/math.rs", render("rust/math.rs", {{"name", unit.robot}})});
  if (solves) files.push_back({"src/metrics.rs", render("rust/metrics.rs", {{"name", unit.robot}})});
  files.push_back({"README.md", render("rust/readme.md", values)});
  files.push_back({"Cargo.toml", render("rust/cargo.toml", {{"name", unit.robot}})});
  return files;
}

}  // namespace qvgen::emit::rust
