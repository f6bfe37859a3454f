// SPDX-License-Identifier: MIT
#include "pipeline/assembly_in_c.h"

#include <algorithm>

#include "emit/ast/literal.h"
#include "emit/c/inverse/source.h"
#include "emit/c/printer.h"
#include "model/evaluate.h"
#include "pipeline/assembly_values.h"

namespace qvgen::pipeline {
namespace {

using derive::loops::AssemblyPlan;
using nlohmann::json;

/// True if C has all blocks of a plan's steps.
bool has_blocks(const AssemblyPlan& assembly) {
  const auto& steps = assembly.plan.steps;
  return std::none_of(steps.begin(), steps.end(),
                      [](const auto& step) { return step.template is<derive::inverse::kind::TwoTurns>(); });
}

std::string default_of(const model::Parameter& parameter, const model::Robot& robot) {
  if (!parameter.default_value) return "NAN";
  return fmt::format(
      "{}", model::to_double(model::evaluate(*parameter.default_value, model::default_bindings(robot))));
}

void add_geometry(const model::Robot& robot, json& values) {
  std::vector<std::string> defaults;
  values["parameters"] = json::array();
  for (const model::Parameter& parameter : robot.geometry) {
    values["parameters"].push_back({{"field", parameter.name}});
    defaults.push_back(default_of(parameter, robot));
  }
  values["has_parameters"] = !defaults.empty();
  values["defaults"] = defaults.empty() ? "0" : commas(defaults);
}

void add_kinds(const model::Robot& robot, json& values) {
  std::vector<std::string> kinds;
  for (const model::Joint& joint : robot.joints)
    kinds.emplace_back(joint.type == model::JointType::revolute ? "true" : "false");
  values["kinds"] = commas(kinds);
}

}  // namespace

std::string assemblies_in_c(const model::Mechanism& mechanism, const std::vector<PlannedVariant>& plans,
                            const AssemblyPlan& first, const json& cpp) {
  json values = cpp;
  values["variants"] = json::array();
  int capacity = 1;
  std::size_t next = 0;
  for (const PlannedVariant& each : plans) {
    if (!each.assembly.found) continue;
    if (!has_blocks(each.assembly)) return "";
    values["variants"].push_back(variant_in_c(each.variant, each.assembly, cpp["variants"][next++]));
    capacity = std::max(capacity, each.assembly.plan.capacity);
  }
  values["most_capacity"] = capacity;
  add_geometry(mechanism.robot, values);
  add_kinds(mechanism.robot, values);
  add_gaps_in_c(first, values);
  return emit::c::assemblies(values);
}

}  // namespace qvgen::pipeline
