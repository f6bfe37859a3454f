// SPDX-License-Identifier: MIT
#include "description/branches.h"
#include "description/chain.h"
#include "description/composed_joints.h"
#include "description/frames.h"

namespace qvgen::description {
namespace {

model::Joint read_joint(const Table& table, const FreeParameters& free) {
  table.allow_only(joint_keys({"axis", "origin", "link", "rpy", "turns", "parent"}));
  table.require("type", "type = \"revolute\" or \"prismatic\"");
  table.require("variable", "a name, e.g. variable = \"theta1\"");
  model::Joint joint;
  joint.type = read_joint_type(table, composed_type_names()).value_or(model::JointType::revolute);
  joint.variable = read_variable(table);
  if (const toml::node* axis = table.require("axis", "a direction, e.g. axis = \"+z\"")) {
    joint.axis = read_axis(table.context(), *axis).value_or(model::Vector3{});
  }
  joint.before = {read_turns(table), vector_or_zero(table, "origin", {})};
  joint.after.translation = vector_or_zero(table, "link", {});
  read_link(table, free, joint);
  return joint;
}

}  // namespace

void read_joints(const Table& root, const FreeParameters& free, model::Robot& robot) {
  for (const Table& table : root.tables("joint")) {
    if (is_composed(table)) {
      read_composed(table, free, robot);
      continue;
    }
    table.context().joint_places.push_back(table.place());
    robot.joints.push_back(read_joint(table, free));
    read_parent(table, robot);
  }
}

}  // namespace qvgen::description
