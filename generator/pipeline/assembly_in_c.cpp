// SPDX-License-Identifier: MIT
#include "pipeline/assembly_in_c.h"

#include <algorithm>

#include "emit/c/inverse/source.h"
#include "emit/render.h"
#include "pipeline/assembly_values.h"
#include "pipeline/limbs.h"

namespace qvgen::pipeline {
namespace {

using derive::loops::AssemblyPlan;
using nlohmann::json;

void add_kinds(const model::Robot& robot, json& values) {
  std::vector<std::string> kinds;
  for (const model::Joint& joint : robot.joints)
    kinds.emplace_back(joint.type == model::JointType::revolute ? "true" : "false");
  values["kinds"] = commas(kinds);
}

/// Adds the ways in C. One without a plan is that of a platform on six rods.
void add_variants_in_c(const std::vector<PlannedVariant>& plans, json& values) {
  for (json& way : values["variants"]) {
    const auto plan = std::find_if(plans.begin(), plans.end(), [&](const PlannedVariant& each) {
      return each.assembly.found && each.variant.function == way["function"];
    });
    if (plan == plans.end())
      way["p"] = way["function"].get<std::string>() + "_";
    else
      way = variant_in_c(plan->variant, plan->assembly, way);
  }
}

std::string capacity_in_c(const AssemblyPlan& assembly) {
  return capacity_of(assembly, "", "_solutions_capacity");
}

std::string capacity_of(const std::vector<PlannedVariant>& plans, const std::string& function) {
  for (const PlannedVariant& each : plans)
    if (each.variant.function == function) return capacity_in_c(each.assembly);
  return "1";
}

/// Adds the most rows of any way, an expression of constants: limbs and chains have as many solutions as
/// their headers say.
void add_capacity(const std::vector<PlannedVariant>& plans, json& values) {
  int capacity = 1;
  std::vector<std::string> others;
  for (const PlannedVariant& each : plans) {
    if (!each.assembly.found) continue;
    if (each.assembly.chains.empty())
      capacity = std::max(capacity, each.assembly.plan.capacity);
    else
      others.push_back(capacity_in_c(each.assembly));
  }
  for (const json& way : values["variants"])
    if (way["rods"] == true) capacity = std::max(capacity, way["capacity"].get<int>());
  for (json& tip : values["tips"]) {
    if (tip["inverse"] == false) continue;
    const std::string ways = capacity_of(plans, tip["inverse"]["function"]);
    tip["inverse"]["most"] = ways;
    others.push_back(fmt::format("{}_{}_solutions_capacity * {}", values["name"].get<std::string>(),
                                 tip["tip"].get<std::string>(), ways));
    values["has_inverse"] = true;
  }
  std::string most = std::to_string(capacity);
  for (const std::string& other : others) most = fmt::format("({0} > {1} ? {0} : {1})", other, most);
  values["most_capacity"] = most;
}

/// Adds to each tip the joints of its limb, each with the joint of the robot that gives its value.
void add_joints_of_tips(const model::Mechanism& mechanism, json& tips) {
  const std::vector<model::Robot> limbs = limbs_of(mechanism);
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    json joints = joints_of_limb(mechanism.robot, limbs[i]);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      joints[k]["place"] = k;
      joints[k]["share"] = joints[k]["ratio"] == "1" ? "" : joints[k]["ratio"].get<std::string>() + " * ";
    }
    tips[i]["joint_count"] = joints.size();
    tips[i]["joints"] = std::move(joints);
  }
}

}  // namespace

emit::c::Part loops_in_c(const model::Mechanism& mechanism, const std::vector<PlannedVariant>& plans,
                         const AssemblyPlan& first, const json& cpp) {
  json values = cpp;
  add_variants_in_c(plans, values);
  add_kinds(mechanism.robot, values);
  add_joints_of_tips(mechanism, values["tips"]);
  add_constraints_in_c(first, values);
  values["in_c"] = true;
  values["has_inverse"] = false;
  values["has_parameters"] = !mechanism.robot.geometry.empty();
  values["has_inertias"] = !mechanism.robot.inertia_parameters.empty();
  values["system_size"] =
      std::max(values["passive_count"].get<std::size_t>(), values["moved_size"].get<std::size_t>());
  if (!values["has_limbs"]) values["tips"] = json::array();
  add_capacity(plans, values);
  return {emit::render("c/assembly.h", values), emit::c::loops(values)};
}

}  // namespace qvgen::pipeline
