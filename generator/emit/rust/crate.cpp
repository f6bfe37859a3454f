// SPDX-License-Identifier: MIT
// The files of a crate: types, constants and functions of each module in the order of the C.
#include "emit/rust/crate.h"

#include <algorithm>

#include <fmt/format.h>

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
  CrateWriter(const blocks::Unit& unit, const Scalar& scalar)
      : unit_(unit), shapes_(unit), context_{unit, shapes_, scalar}, used_(blocks::used_names(unit)) {}

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

  /// Names of the root that a module reads.
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
    if (!list.empty()) add("use " + context_.scalar.root + "::{" + list + "};");
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
      add("    " + mark + value_name(each.name) + ": " + type_text(each.type, context_) + ",");
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
        type_text(constant.type, context_) + " = " + writer.constant_value(constant.value[0], constant.type) +
        ";");
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

/// Public names of a module, as its root gives them away.
std::string names_of(const blocks::Unit& unit, const std::string& module) {
  Lines names;
  for (const auto& [name, structure] : unit.structures)
    if (structure.module == module && structure.is_public) names.push_back(type_name(name, unit.robot));
  for (const auto& constant : unit.constants)
    if (constant.module == module && constant.is_public)
      names.push_back(constant_name(constant.name, unit.robot));
  for (const auto& function : unit.functions)
    if (function.module == module && function.is_public && function.is_defined)
      names.push_back(value_name(function.name, unit.robot));
  return fmt::format("{}", fmt::join(names, ", "));
}

json values_of(const blocks::Unit& unit, const std::vector<std::string>& missing) {
  return {{"name", unit.robot},
          {"has_inverse", blocks::solves_poses(unit)},
          {"has_metrics", blocks::has_module(unit, "inverse")},
          {"has_motors", blocks::joints_with_motors(unit) > 0},
          {"joint_count", blocks::joints_with_motors(unit)},
          {"has_missing", !missing.empty()},
          {"missing", lines_of_text(missing)}};
}

/// The type, names of its functions in libm, its sign and the least number behind which all are whole.
json values_of(const Scalar& scalar) {
  const bool is_single = scalar.type == "f32";
  return {{"real", scalar.type},
          {"root", scalar.root},
          {"f", is_single ? "f" : ""},
          {"sign", is_single ? "u32 = 1 << 31" : "u64 = 1 << 63"},
          {"whole", is_single ? "8388608.0" : "4503599627370496.0"}};
}

using Files = std::vector<std::pair<std::string, std::string>>;

/// Sources of the functions in one precision: what its root holds, and in `files` its modules.
json add_sources(const blocks::Unit& unit, const Scalar& scalar, const std::string& folder, json values,
                 Files& files) {
  CrateWriter writer(unit, scalar);
  values.update(values_of(scalar));
  values["modules"] = json::array();
  const auto add = [&](const std::string& name, const std::string& shape) {
    files.push_back({folder + name + ".rs", render("rust/" + shape, values)});
  };
  for (const std::string& each : unit.modules) {
    if (each.empty()) continue;
    values["modules"].push_back({{"module", each}, {"names", names_of(unit, each)}});
    values["body"] = writer.module(each);
    add(each, "module.rs");
  }
  add("math", "math.rs");
  if (blocks::has_module(unit, "inverse")) add("metrics", "metrics.rs");
  values["body"] = writer.module("");
  return values;
}

}  // namespace

Files crate(const blocks::Unit& unit, const std::optional<blocks::Unit>& in_single,
            const std::vector<std::string>& missing) {
  Files files;
  json values = values_of(unit, missing);
  values["has_single"] = in_single.has_value();
  const json root = add_sources(unit, {}, "src/", values, files);
  files.push_back({"src/lib.rs", render("rust/lib.rs", root)});
  if (in_single) {
    const json single = add_sources(*in_single, {"f32", "crate::f32", false}, "src/f32/", values, files);
    files.push_back({"src/f32.rs", render("rust/f32.rs", single)});
  }
  files.push_back({"README.md", render("rust/readme.md", values)});
  files.push_back({"Cargo.toml", render("rust/cargo.toml", values)});
  return files;
}

}  // namespace qvgen::emit::rust
