// SPDX-License-Identifier: MIT
#include "description/chain.h"
#include "description/frames.h"
#include "model/arithmetic.h"

namespace qvgen::description {
namespace {

/// `at` is the point where the previous link frame stands, in the base frame at zero; it moves on to this
/// axis.
model::Joint read_screw(const Table& table, const FreeParameters& free, model::Vector3& at) {
  table.allow_only(joint_keys({"axis", "point"}));
  table.require("type", "type = \"revolute\" or \"prismatic\"");
  table.require("variable", "a name, e.g. variable = \"theta1\"");
  model::Joint joint;
  joint.type = read_joint_type(table).value_or(model::JointType::revolute);
  joint.variable = read_variable(table);
  if (const toml::node* axis = table.require("axis", "a direction, e.g. axis = \"+z\"")) {
    joint.axis = read_axis(table.context(), *axis).value_or(model::Vector3{});
  }
  if (joint.type == model::JointType::revolute)
    table.require("point", "a point on the axis, point = [x, y, z]");
  if (table.has("point")) {
    const model::Vector3 point = vector_or_zero(table, "point", {});
    joint.before.translation = model::subtract(point, at);
    at = point;
  }
  read_link(table, free, joint);
  return joint;
}

}  // namespace

// exp(S1 t1) ... exp(Sn tn) home: with every frame parallel to the base at zero, the frame of an axis differs
// from the one before by the vector between their points, and the tool frame from the last by home.
void read_screws(const Table& root, const FreeParameters& free, model::Robot& robot) {
  model::Vector3 at;
  for (const Table& table : root.tables("screw")) {
    table.context().joint_places.push_back(table.place());
    robot.joints.push_back(read_screw(table, free, at));
  }
  model::Displacement home = read_frame(root, "home");
  home.translation = model::subtract(home.translation, at);
  robot.tool = model::compose(home, robot.tool);
}

}  // namespace qvgen::description
