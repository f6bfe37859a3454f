// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_in_c.h"

#include "emit/c/printer.h"
#include "model/followers.h"
#include "pipeline/products/inverse_motors.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

/// The arm that is solved has functions of its own, whose names begin with that.
void hide_functions(const std::string& prefix, json& values) {
  values["entry"] = "static int " + prefix;
  values["call"] = prefix;
}

/// Names of a variant's public functions, and what its caller gives.
void add_names(bool has_outer, json& variant) {
  const bool is_locked = variant["locked"];
  const std::string value = is_locked ? variant["given_name"].get<std::string>() : "";
  variant["c_function"] = variant[has_outer ? "outer_function" : "function"];
  variant["c_near_function"] = variant[has_outer ? "outer_near_function" : "near_function"];
  variant["c_given"] = has_outer   ? variant["outer_parameters"]
                       : is_locked ? json("double " + value + ", ")
                                   : json("");
  if (has_outer)
    variant["given_meaning"] = "; " + variant["outer_meaning"].get<std::string>() + ", rad or m, are given";
  variant["separate_rows"] = has_outer || variant["virtual_joints"].get<bool>();
}

}  // namespace

void add_public_functions_in_c(const model::Robot& described, const std::optional<OuterJoints>& outer,
                               json& values) {
  const bool has_motors = model::has_followers(described);
  values["entry"] = "int " + described.name + "_";
  values["call"] = described.name + "_";
  if (has_motors) hide_functions("joints_", values);
  if (outer) hide_functions("inner_", values);
  values["start_representatives"] = has_motors ? "start_motor_representatives" : "start_representatives";
  values["next_representative"] = has_motors ? "next_motor_representative" : "next_representative";
  values["motors"] = has_motors ? relation_in_c(described) : json(false);
  add_outer_joints(described, outer, emit::c::printer(), values);
  if (values["arm"].is_object()) values["arm"]["arm_joints"] = "dof";
  const bool holds = outer && !outer->held.empty();
  values["geometry_type"] = holds ? "InnerGeometry" : described.name + "_geometry";
  if (outer) values["outer"]["arm"]["arm_joints"] = "whole_dof";
  if (holds)
    for (json& variant : values["variants"]) variant["inner_geometry"] = "&own";
  const bool has_joint_over = has_motors && values["motors"]["has_joint_over"].get<bool>();
  values["has_joint_over"] = has_joint_over;
  values["rows_type"] = has_joint_over ? "Solutions" : described.name + "_solutions";
  for (json& variant : values["variants"]) add_names(outer.has_value(), variant);
}

}  // namespace qvgen::pipeline
