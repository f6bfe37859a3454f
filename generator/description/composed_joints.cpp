// SPDX-License-Identifier: MIT
#include "description/composed_joints.h"

#include <algorithm>
#include <map>

#include "description/branches.h"
#include "description/frames.h"
#include "model/arithmetic.h"

namespace qvgen::description {
namespace {

struct Part {
  model::JointType type;
  std::size_t axis;
};
using Parts = std::vector<Part>;

/// The parts of a type, in order; none of other types.
Parts parts_of(const std::string& type) {
  constexpr auto turn = model::JointType::revolute, slide = model::JointType::prismatic;
  if (type == "universal") return {{turn, 0}, {turn, 1}};
  if (type == "spherical") return {{turn, 0}, {turn, 1}, {turn, 2}};
  if (type == "planar") return {{slide, 0}, {slide, 1}, {turn, 2}};
  return {};
}

std::string type_of(const Table& joint) {
  const toml::node* type = joint.find("type");
  return type == nullptr ? "" : type->value_exact<std::string>().value_or("");
}

/// Keys whose values are lists with an entry for each part.
const std::vector<std::string>& keys_of_parts() {
  static const std::vector<std::string> keys{"limits",        "velocity_limit",   "effort_limit",
                                             "rotor_inertia", "viscous_friction", "coulomb_friction"};
  return keys;
}

void check_keys(const Table& joint) {
  std::vector<std::string> keys{"type",   "variable", "mass", "centre_of_mass", "inertia",
                                "origin", "link",     "rpy",  "turns",          "parent"};
  keys.insert(keys.end(), keys_of_parts().begin(), keys_of_parts().end());
  if (joint.has("axis")) {
    joint.context().error(joint.key_place("axis"), "'axis' of a " + type_of(joint) + " joint",
                          "its axes are those of its own frame, which 'rpy' or 'turns' rotates");
    keys.emplace_back("axis");
  }
  joint.allow_only(keys);
  joint.require("variable", "a name, e.g. variable = \"hip\"");
}

/// The lists of a joint, those that are right. "free" holds for every part.
using Lists = std::map<std::string, const toml::array*>;

bool is_list(const Table& joint, const std::string& key, std::size_t parts) {
  const toml::array* list = joint.find(key)->as_array();
  const auto is_pair = [](const toml::node& entry) { return entry.is_array(); };
  return list != nullptr && list->size() == parts &&
         (key != "limits" || std::all_of(list->begin(), list->end(), is_pair));
}

std::string example_of(const std::string& key, std::size_t parts) {
  const std::string entry = key == "limits" ? "[lower, upper]" : "1";
  std::string text = entry;
  for (std::size_t k = 1; k < parts; ++k) text += ", " + entry;
  return key + " = [" + text + "]" + (key == "limits" ? ", with [] for none" : "");
}

Lists lists_of(const Table& joint, std::size_t parts) {
  Lists lists;
  for (const std::string& key : keys_of_parts()) {
    if (!joint.has(key) || joint.find(key)->value_exact<std::string>() == "free") continue;
    lists[key] = is_list(joint, key, parts) ? joint.find(key)->as_array() : nullptr;
    if (lists[key] == nullptr)
      joint.context().error(joint.place_of(key),
                            "'" + key + "' of a " + type_of(joint) + " joint has an entry for each of its " +
                                std::to_string(parts) + " parts",
                            "write " + example_of(key, parts));
  }
  return lists;
}

/// The joint's table as that of one part: entries of its own, the frame before the first part, the link and
/// its inertia behind the last.
Table table_of(const Table& joint, const Lists& lists, std::size_t part, std::size_t parts) {
  std::map<std::string, const toml::node*> values;
  for (const auto& [key, list] : lists) {
    const toml::node* value = list == nullptr ? nullptr : list->get(part);
    const bool is_empty = value != nullptr && value->is_array() && value->as_array()->empty();
    values[key] = is_empty ? nullptr : value;
  }
  if (part > 0)
    for (const char* key : {"origin", "rpy", "turns"}) values[key] = nullptr;
  if (part + 1 < parts)
    for (const char* key : {"link", "mass", "centre_of_mass", "inertia"}) values[key] = nullptr;
  for (const char* key : {"follows", "ratio", "offset"}) values[key] = nullptr;
  return joint.with(std::move(values));
}

model::Joint joint_of(const Table& table, const Part& part, const FreeParameters& free) {
  model::Joint joint;
  joint.type = part.type;
  joint.axis = model::unit_vector(part.axis, 1);
  joint.before = {read_turns(table), vector_or_zero(table, "origin", {})};
  joint.after.translation = vector_or_zero(table, "link", {});
  read_link(table, free, joint);
  return joint;
}

}  // namespace

const std::vector<std::string>& composed_type_names() {
  static const std::vector<std::string> names{"universal", "spherical", "planar"};
  return names;
}

bool is_composed(const Table& joint) { return !parts_of(type_of(joint)).empty(); }

void read_composed(const Table& joint, const FreeParameters& free, model::Robot& robot) {
  const Parts parts = parts_of(type_of(joint));
  Context& context = joint.context();
  check_keys(joint);
  const Lists lists = lists_of(joint, parts.size());
  const std::string name = joint.text("variable").value_or("");
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const bool is_last = k + 1 == parts.size();
    context.joint_places.push_back(joint.place());
    robot.joints.push_back(
        joint_of(table_of(joint, lists, k, parts.size()), parts[k], {free.inertia && is_last, free.drives}));
    robot.joints.back().variable = name + "_" + "xyz"[parts[k].axis];
    if (!name.empty()) add_variable(context, robot.joints.back().variable, joint.place_of("variable"));
    if (k == 0) read_parent(joint, robot);
  }
  context.composed.emplace(name, robot.joints.size() - 1);
}

}  // namespace qvgen::description
