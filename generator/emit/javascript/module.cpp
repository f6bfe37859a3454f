// SPDX-License-Identifier: MIT
// The files of a package: one ES module of all that a robot's C has, and what TypeScript is to know of it.
#include "emit/javascript/module.h"

#include <set>

#include "emit/columns/signature.h"
#include "emit/javascript/batch.h"
#include "emit/javascript/declarations.h"
#include "emit/javascript/names.h"
#include "emit/javascript/writer.h"
#include "emit/render.h"
#include "emit/template_values.h"

namespace qvgen::emit::javascript {
namespace {

using blocks::Type;
using blocks::TypeRef;

class ModuleWriter {
 public:
  explicit ModuleWriter(const blocks::Unit& unit)
      : unit_(unit), shapes_(unit), context_{unit, shapes_}, used_(blocks::used_names(unit)) {}

  std::string module() {
    lines_.clear();
    for (const std::string& each : unit_.structure_order) add(unit_.structures.at(each));
    for (const blocks::Constant& each : unit_.constants)
      if (each.is_public || used_.count(each.name) > 0) add(each);
    for (const blocks::Function& each : unit_.functions) {
      if (!each.is_defined) continue;
      add("");
      add(documented(each.doc, "", unit_.robot, blocks::returns_last(each)));
      add(FunctionWriter(context_, each).lines());
    }
    return joined();
  }

  std::string declarations() {
    lines_.clear();
    for (const std::string& each : unit_.structure_order)
      if (unit_.structures.at(each).is_public) declare(unit_.structures.at(each));
    for (const blocks::Constant& each : unit_.constants)
      if (each.is_public && !each.value.empty()) {
        add(documented(each.doc, "", unit_.robot));
        add("export const " + constant_name(unit_, each) + ": " + result_text(unit_, each.type) + ";");
      }
    for (const blocks::Function& each : unit_.functions)
      if (each.is_public && each.is_defined) declare(each);
    return joined();
  }

 private:
  void add(const Lines& more) { lines_.insert(lines_.end(), more.begin(), more.end()); }
  void add(const std::string& line) { lines_.push_back(line); }
  std::string joined() const {
    std::string text;
    for (const std::string& line : lines_) text += line + "\n";
    return text;
  }

  /// A new object of a struct, one put into another, and a copy.
  void add(const blocks::Structure& structure) {
    const std::string type = type_name(unit_, structure.name);
    std::string zero, copies, puts;
    for (const blocks::Field& each : structure.fields) {
      if (each.type->kind == Type::Kind::text) continue;
      const std::string name = field_name(structure, each.name), comma = zero.empty() ? " " : ", ";
      zero += comma + name + ": " + zero_text(unit_, each.type);
      copies += comma + name + ": " + copy_text(each.type, "from." + name);
      puts += "  " + put_text(each.type, "to." + name, "from." + name) + ";\n";
    }
    add("");
    add("function zero" + type + "() {\n  return {" + zero + " };\n}");
    add("function copy" + type + "(from) {\n  return {" + copies + " };\n}");
    add("function set" + type + "(to, from) {\n" + puts + "}");
  }

  std::string copy_text(const TypeRef& type, const std::string& from) const {
    if (type->kind == Type::Kind::structure) return "copy" + type_name(unit_, type->name) + "(" + from + ")";
    return type->kind == Type::Kind::array ? "copyOf(" + from + ")" : from;
  }

  std::string put_text(const TypeRef& type, const std::string& to, const std::string& from) const {
    if (type->kind == Type::Kind::structure)
      return "set" + type_name(unit_, type->name) + "(" + to + ", " + from + ")";
    if (type->kind == Type::Kind::array)
      return "copyTo(" + to + ", " + from + ", " + std::to_string(type->size) + ")";
    return to + " = " + from;
  }

  void add(const blocks::Constant& constant) {
    if (constant.value.empty()) return;
    const blocks::Function none{};
    FunctionWriter writer(context_, none);
    if (!constant.doc.empty()) add("");
    add(documented(constant.doc, "", unit_.robot));
    add(std::string(constant.is_public ? "export " : "") + "const " + constant_name(unit_, constant) + " = " +
        writer.constant_value(constant.value[0], constant.type) + ";");
  }

  void declare(const blocks::Structure& structure) {
    add("");
    add(documented(structure.doc, "", unit_.robot));
    add("export interface " + type_name(unit_, structure.name) + " {");
    for (const blocks::Field& each : structure.fields) {
      if (each.type->kind == Type::Kind::text) continue;
      add(documented(each.doc, "  ", unit_.robot));
      add("  " + field_name(structure, each.name) + ": " + result_text(unit_, each.type) + ";");
    }
    add("}");
  }

  void declare(const blocks::Function& function) {
    add("");
    add(documented(function.doc, "", unit_.robot, blocks::returns_last(function)));
    const bool gives_last = blocks::returns_last(function);
    const TypeRef result = gives_last ? blocks::pointee(function.parameters.back()) : function.result;
    add("export function " + function_name(unit_, function) + "(" + parameters_text(context_, function) +
        "): " + result_text(unit_, result) + ";");
  }

  const blocks::Unit& unit_;
  blocks::Shapes shapes_;
  Context context_;
  std::set<std::string> used_;
  Lines lines_;
};

}  // namespace

Files package(const blocks::Unit& unit, const std::vector<blocks::File>& c,
              const std::vector<std::string>& missing) {
  ModuleWriter writer(unit);
  const std::string name = "qvgen_" + unit.robot;
  const nlohmann::json values{
      {"name", unit.robot}, {"has_missing", !missing.empty()}, {"missing", lines_of(missing)}};
  const bool solves = blocks::has_module(unit, "inverse");
  const auto filled = [&](const std::string& file, const std::string& body) {
    nlohmann::json all = values;
    all["body"] = body;
    all["dof"] = unit.constant(unit.robot + "_dof")->value[0].text;
    all["has_inverse"] = blocks::solves_poses(unit);
    all["metrics"] = solves && !body.empty() ? render("javascript/metrics" + file.substr(file.find('.')),
                                                      {{"has_motors", blocks::joints_with_motors(unit) > 0}})
                                             : "";
    return render("javascript/" + file, all);
  };
  Files files{{name + ".mjs", filled("module.mjs", writer.module())},
              {name + ".d.mts", filled("module.d.mts", writer.declarations())},
              {"README.md", filled("readme.md", "")},
              {"package.json", filled("package.json", "")}};
  for (auto& each : batch_files(unit, c)) files.push_back(std::move(each));
  return files;
}

}  // namespace qvgen::emit::javascript
