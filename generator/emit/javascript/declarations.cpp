// SPDX-License-Identifier: MIT
#include "emit/javascript/declarations.h"

#include "emit/blocks/documentation.h"
#include "emit/javascript/names.h"

namespace qvgen::emit::javascript {

using blocks::Type;
using blocks::TypeRef;

Lines documented(const Lines& doc, const std::string& indent, const std::string& robot, bool returns_last) {
  if (doc.empty()) return {};
  Lines result{indent + "/**"};
  for (std::string each : blocks::documentation(doc, {robot, "null", 110, returns_last})) {
    for (std::size_t at = each.find("*/"); at != std::string::npos; at = each.find("*/"))
      each.insert(at + 1, " ");
    result.push_back(indent + " *" + (each.empty() ? "" : " ") + each);
  }
  result.push_back(indent + " */");
  return result;
}

std::string result_text(const blocks::Unit& unit, const TypeRef& type) {
  switch (type->kind) {
    case Type::Kind::structure:
      return type_name(unit, type->name);
    case Type::Kind::array:
      if (type->of->kind == Type::Kind::real) return "Float64Array";
      if (type->of->kind == Type::Kind::integer) return "Int32Array";
      return result_text(unit, type->of) + "[]";
    case Type::Kind::pointer:
      return type->of->kind == Type::Kind::text ? "string" : result_text(unit, type->of);
    case Type::Kind::boolean:
      return "boolean";
    case Type::Kind::nothing:
      return "void";
    default:
      return "number";
  }
}

namespace {

std::string parameter_text(const blocks::Unit& unit, const TypeRef& type, const blocks::Shape& shape) {
  if (type->kind != Type::Kind::pointer) return result_text(unit, type);
  std::string text =
      shape.many && blocks::is_number(type->of) ? "ArrayLike<number>" : result_text(unit, type->of);
  if (shape.many && !blocks::is_number(type->of)) text = "ArrayLike<" + text + ">";
  return shape.optional ? text + " | null" : text;
}

}  // namespace

std::string parameters_text(const Context& context, const blocks::Function& function) {
  const std::vector<std::string> usual = FunctionWriter(context, function).parameters();
  std::string list;
  // A parameter may be left out if all behind it may.
  std::size_t first_optional = usual.size();
  while (first_optional > 0 && usual[first_optional - 1].find(" = ") != std::string::npos) --first_optional;
  for (std::size_t i = 0; i < usual.size(); ++i) {
    const blocks::Field& each = function.parameters[i];
    std::string type = parameter_text(context.unit, each.type, context.shapes.of(function.name)[i]);
    if (i < first_optional && usual[i].find(" = ") != std::string::npos) type += " | undefined";
    list += (i == 0 ? "" : ", ") + camel(each.name) + (i >= first_optional ? "?: " : ": ") + type;
  }
  return list;
}

}  // namespace qvgen::emit::javascript
