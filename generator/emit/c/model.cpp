// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "emit/c/parts.h"
#include "emit/c/printer.h"
#include "emit/render.h"
#include "emit/template_values.h"

namespace qvgen::emit::c {
namespace {

using nlohmann::json;

std::string number(double value) {
  if (std::isinf(value)) return value > 0 ? "HUGE_VAL" : "-HUGE_VAL";
  return printer().text(ast::real(fmt::format("{}", value)));
}

/// Writes the value of a constant; NAN if nobody has set it, so that results show it.
std::string value_of(const Constant& constant) { return constant.value ? number(*constant.value) : "NAN"; }

Part constants(const model::Robot& robot, const std::string& name, const std::string& text,
               const std::vector<Constant>& list) {
  json values{{"name", robot.name}, {"constants", name}, {"text", text}, {"has_parameters", !list.empty()}};
  values["lacks_defaults"] =
      std::any_of(list.begin(), list.end(), [](const Constant& each) { return !each.value; });
  values["parameters"] = json::array();
  for (const Constant& each : list)
    values["parameters"].push_back({{"type", "double"},
                                    {"parameter", each.name},
                                    {"default", value_of(each)},
                                    {"last", &each == &list.back()}});
  if (list.empty())  // C has no empty struct
    values["parameters"].push_back(
        {{"type", "char"}, {"parameter", "none"}, {"default", "0"}, {"last", true}});
  return {render("c/constants.h", values), render("c/constants.c", values)};
}

json values_of(const Joint& joint) {
  return {{"variable", joint.name},
          {"revolute", joint.revolute ? "1" : "0"},
          {"lower", joint.limits ? number(joint.limits->first) : "-HUGE_VAL"},
          {"upper", joint.limits ? number(joint.limits->second) : "HUGE_VAL"},
          {"velocity", number(joint.greatest_velocity)},
          {"effort", number(joint.greatest_effort)}};
}

}  // namespace

Part model(const model::Robot& robot, const std::vector<Joint>& joints,
           const std::vector<Constant>& geometry) {
  json values{{"name", robot.name}, {"title", robot.title}, {"dof", joints.size()}};
  values["source"] = robot.source.empty() ? json(false) : json(robot.source);
  values["joints"] = json::array();
  for (const Joint& joint : joints) {
    values["joints"].push_back(values_of(joint));
    values["joints"].back()["last"] = &joint == &joints.back();
  }
  Part part{render("c/model.h", values), render("c/model.c", values)};
  return part += constants(robot, "geometry", "Geometric constants, metres or radians.", geometry);
}

Part names(const model::Robot& robot, const std::string& of, const std::string& text,
           const std::vector<std::string>& list) {
  if (list.empty()) return {};  // C has no empty array
  json values{{"name", robot.name}, {"of", of}, {"text", text}, {"count", list.size()}};
  values["names"] = json::array();
  for (const std::string& each : list)
    values["names"].push_back({{"text", each}, {"last", &each == &list.back()}});
  return {render("c/names.h", values), render("c/names.c", values)};
}

Part inertia(const model::Robot& robot, const std::vector<Constant>& parameters) {
  return constants(robot, "inertia", "Inertial parameters, kg, m, kg m^2.", parameters);
}

}  // namespace qvgen::emit::c
