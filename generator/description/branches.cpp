// SPDX-License-Identifier: MIT
// Joints that branch, in TOML: each names the joint that carries it, and the limbs end in [[tip]] tables.
#include "description/branches.h"

#include "description/named_frames.h"
#include "description/names.h"

namespace qvgen::description {
namespace {

const std::string base_name = "base";

/// Refuses requests of a chain, which has one pose to reach.
void refuse_requests(const Table& root) {
  for (const char* key : {"tool", "task", "tool_axis", "given", "ideal"})
    if (root.has(key))
      root.context().error(root.key_place(key), "'" + std::string(key) + "' beside [[tip]]",
                           "it belongs to a chain; each [[tip]] has its own translation and turns");
}

/// A tip for each joint that carries no other, in a line to copy.
std::string tips_to_copy(const model::Robot& robot) {
  std::vector<bool> is_end(robot.joints.size(), true);
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (const std::size_t parent = model::parent_of(robot, i); parent != model::base_link)
      is_end[parent] = false;
  std::string text;
  for (std::size_t i = 0; i < is_end.size(); ++i) {
    if (!is_end[i]) continue;
    const std::string& variable = robot.joints[i].variable;
    text += (text.empty() ? "" : ", ") + ("{name = \"tip_" + variable) + "\", joint = \"" + variable + "\"}";
  }
  return "tip = [" + text + "]";
}

}  // namespace

void read_parent(const Table& table, model::Robot& robot) {
  if (!table.has("parent")) return;
  const std::string name = table.text("parent").value_or("");
  const std::size_t joint = robot.joints.size() - 1;
  std::vector<std::string> names;
  if (const auto whole = table.context().composed.find(name); whole != table.context().composed.end())
    return model::set_parent(robot, joint, whole->second);
  for (std::size_t i = 0; i < joint; ++i) {
    if (robot.joints[i].variable == name) return model::set_parent(robot, joint, i);
    names.push_back(robot.joints[i].variable);
  }
  if (name == base_name) return model::set_parent(robot, joint, model::base_link);
  names.push_back(base_name);
  const std::string near = nearest(name, names);
  table.context().error(table.place_of("parent"), "no joint before this one has the variable '" + name + "'",
                        near.empty() ? "name an earlier joint, or \"base\"" : "did you mean '" + near + "'?");
}

std::vector<model::Frame> read_tips(const Table& root, const model::Robot& robot) {
  Context& context = root.context();
  if (!root.has("tip")) {
    if (model::branches(robot) && !context.has_error)
      context.error({}, "the joints branch, and no [[tip]] says where limbs end",
                    "write those that matter before the first [[joint]]: " + tips_to_copy(robot));
    return {};
  }
  refuse_requests(root);
  return read_frame_tables(root, "tip", robot);
}

}  // namespace qvgen::description
