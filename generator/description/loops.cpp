// SPDX-License-Identifier: MIT
#include "description/loops.h"

#include <algorithm>
#include <map>

#include "description/entries.h"
#include "description/followers.h"
#include "description/frames.h"
#include "description/names.h"
#include "description/tree/tree.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

const std::string base_name = "base";

/// Place of a name in a list; reported with `told` and a hint if it is not there.
std::optional<std::size_t> place_in(Context& context, const toml::node& node,
                                    const std::vector<std::string>& names, const std::string& told,
                                    const std::string& hint) {
  const auto name = node.value_exact<std::string>();
  if (!name) {
    report_type(context, node, "a name", hint + ", in quotes");
    return std::nullopt;
  }
  const auto found = std::find(names.begin(), names.end(), *name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string near = names.size() < tree::many_names ? nearest(*name, names) : "";
  context.error(begin_of(node.source()), "there is no " + told + " '" + *name + "'",
                near.empty() ? hint : "did you mean '" + near + "'?");
  return std::nullopt;
}

/// The variables of a robot's joints, by which its links are called too, and the base.
LoopNames names_of(const Context& context, const model::Robot& robot) {
  LoopNames names;
  for (const model::Joint& joint : robot.joints) names.joints.push_back(joint.variable);
  for (const auto& [name, last] : context.composed) {
    const auto end = names.joints.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    names.composed.emplace(name, std::vector(std::find(names.joints.begin(), end, name + "_x"), end));
  }
  names.links = names.joints;
  names.links.push_back(base_name);
  names.told = "joint with the variable";
  names.hint = "a link is called by the variable of the joint that moves it, or \"base\"";
  return names;
}

/// The variables of the parts of a composed joint, if the entry is its name; else nothing.
std::vector<std::string> parts_in(const toml::node& node, const LoopNames& names) {
  const auto found = names.composed.find(node.value_exact<std::string>().value_or(""));
  return found == names.composed.end() ? std::vector<std::string>{} : found->second;
}

/// Place of a link; the name of a composed joint means its last part.
std::optional<std::size_t> link_in(Context& context, const toml::node& node, const LoopNames& names) {
  const std::vector<std::string> parts = parts_in(node, names);
  if (parts.empty()) return place_in(context, node, names.links, names.told, names.hint);
  const auto found = std::find(names.links.begin(), names.links.end(), parts.back());
  return static_cast<std::size_t>(found - names.links.begin());
}

/// An array of that many entries, or nothing and a report.
const toml::array* array_of(const Table& table, const std::string& key, std::size_t size,
                            const std::string& wanted) {
  const toml::node* node = table.require(key, key + " = " + wanted);
  if (node == nullptr) return nullptr;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->size() != size) {
    table.context().error(table.place_of(key),
                          "'" + key + "' is no list of " + std::to_string(size) + " entries",
                          "write " + key + " = " + wanted);
    return nullptr;
  }
  return array;
}

void read_links(const Table& table, const LoopNames& names, model::Loop& loop) {
  Context& context = table.context();
  const toml::array* between = array_of(table, "between", 2, "[\"theta1\", \"theta2\"]");
  if (between == nullptr) return;
  bool known = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto link = link_in(context, *between->get(i), names);
    known = known && link.has_value();
    loop.links.at(i) = link.value_or(model::base_link);
  }
  if (known && loop.links[0] == loop.links[1])
    context.error(table.place_of("between"), "a loop within one link: both ends are on the same one",
                  "name two links that move against each other");
}

model::Vector3 read_point(Context& context, const toml::node& node) {
  model::Vector3 point;
  const toml::array* entries = node.as_array();
  if (entries == nullptr || entries->size() != 3) {
    context.error(begin_of(node.source()), "a point of 'at' is no list of three entries",
                  "write at = [[x, y, z], [x, y, z]], the point in each link's frame");
    return point;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto read = read_entry(context, *entries->get(i), {}, "an entry of 'at'");
    if (!read) continue;
    const Entry entry = in_metres(context, *read);
    check_length(context, entry, "at");
    point.at(i) = entry.value;
  }
  return point;
}

void read_points(const Table& table, model::Loop& loop) {
  const toml::array* at = array_of(table, "at", 2, "[[x, y, z], [x, y, z]]");
  for (std::size_t i = 0; at != nullptr && i < 2; ++i)
    loop.points.at(i) = read_point(table.context(), *at->get(i));
}

void read_type(const Table& table, model::Loop& loop) {
  using model::LoopType;
  static const std::map<std::string, LoopType> types{{"pin", LoopType::pin},
                                                     {"ball", LoopType::ball},
                                                     {"rod", LoopType::rod},
                                                     {"weld", LoopType::weld},
                                                     {"slide", LoopType::slide}};
  table.require("type", "type = \"pin\", \"ball\", \"rod\", \"weld\" or \"slide\"");
  const std::string type = table.text("type").value_or("pin");
  const auto found = types.find(type);
  if (found != types.end()) loop.type = found->second;
  if (found == types.end())
    table.context().error(table.place_of("type"), "unknown type of loop '" + type + "'",
                          "write pin, ball, rod, weld or slide");
}

/// A key that belongs to another type of loop.
void refuse_key(const Table& table, const std::string& key, const std::string& of) {
  if (table.has(key))
    table.context().error(table.key_place(key), "'" + key + "' belongs to " + of, "leave it out");
}

/// True if the length of a rod is the value of a joint, by its name.
bool reads_length_joint(const Table& table, const LoopNames& names, model::Loop& loop) {
  const toml::node* node = table.find("length");
  const auto name = node == nullptr ? std::nullopt : node->value_exact<std::string>();
  const auto found = name ? std::find(names.joints.begin(), names.joints.end(), *name) : names.joints.end();
  if (found == names.joints.end()) return false;
  loop.length_joint = static_cast<std::size_t>(found - names.joints.begin());
  return true;
}

void read_length(const Table& table, const LoopNames& names, model::Loop& loop) {
  if (loop.type != model::LoopType::rod) return refuse_key(table, "length", "a rod");
  if (reads_length_joint(table, names, loop)) return;
  table.require("length", "length = 0.4, between its two points");
  const Entry length = in_metres(table.context(), entry_or_zero(table, "length", {}));
  check_length(table.context(), length, "length");
  loop.length = length.value;
  if (!table.has("length") || !symbols(length.value).empty()) return;
  if (!cln::plusp(model::evaluate(length.value)))
    table.context().error(length.place, "the length of a rod is not above 0",
                          "a rod without length is a ball, which has one point in both links");
}

void read_loop_axis(const Table& table, model::Loop& loop) {
  const bool slides = loop.type == model::LoopType::slide;
  if (loop.type != model::LoopType::pin && !slides) return refuse_key(table, "axis", "a pin or a slide");
  if (slides)
    table.require("axis", "axis = \"+x\", along which the second link slides in the first one's frame");
  if (const toml::node* axis = table.find("axis")) loop.axis = read_axis(table.context(), *axis);
}

/// How the second link of a weld or a slide is turned as seen from the first.
void read_loop_turns(const Table& table, model::Loop& loop) {
  if (loop.type == model::LoopType::weld || loop.type == model::LoopType::slide)
    loop.turns = read_turns(table);
  else
    for (const char* key : {"rpy", "turns"}) refuse_key(table, key, "a weld or a slide");
}

}  // namespace

model::Loop read_loop(const Table& table, const LoopNames& names) {
  table.allow_only({"type", "between", "at", "axis", "length", "rpy", "turns"});
  model::Loop loop;
  read_type(table, loop);
  read_links(table, names, loop);
  read_points(table, loop);
  read_length(table, names, loop);
  read_loop_axis(table, loop);
  read_loop_turns(table, loop);
  return loop;
}

namespace {

/// Places of the joints that an entry names: all parts of a composed one.
std::vector<std::size_t> joints_in(Context& context, const toml::node& node, const LoopNames& names) {
  std::vector<std::size_t> joints;
  for (const std::string& part : parts_in(node, names)) {
    const auto found = std::find(names.joints.begin(), names.joints.end(), part);
    joints.push_back(static_cast<std::size_t>(found - names.joints.begin()));
  }
  if (!joints.empty()) return joints;
  const auto joint = place_in(context, node, names.joints, names.told, "name the variables of joints");
  return joint ? std::vector{*joint} : joints;
}

/// Indices of the joints that a list names, each once.
std::vector<std::size_t> read_joint_list(const Table& root, const std::string& key, const LoopNames& names) {
  const toml::node* node = root.find(key);
  if (node == nullptr) return {};
  Context& context = root.context();
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    report_type(context, *node, "'" + key + "'", "a list of variables of joints");
    return {};
  }
  std::vector<std::size_t> joints;
  for (const toml::node& element : *array) {
    for (const std::size_t joint : joints_in(context, element, names)) {
      if (std::find(joints.begin(), joints.end(), joint) != joints.end())
        context.error(begin_of(element.source()), "'" + key + "' names this joint twice", "name it once");
      joints.push_back(joint);
    }
  }
  return joints;
}

/// The length of a rod is no turn; a link behind the last joint is the base.
void check_joints(const Table& table, const model::Robot& robot, model::Loop& loop) {
  for (std::size_t& link : loop.links)
    if (link == robot.joints.size()) link = model::base_link;
  if (!loop.length_joint || robot.joints[*loop.length_joint].type == model::JointType::prismatic) return;
  table.context().error(table.place_of("length"),
                        "joint " + robot.joints[*loop.length_joint].variable + " turns: it is no length",
                        "name a prismatic joint, whose value is the length of the rod, or a number");
}

/// Requests of a chain have no meaning beside loops.
void refuse_beside_loops(const Table& root) {
  Context& context = root.context();
  for (const char* key : {"task", "tool_axis", "given", "ideal"})
    if (root.has(key))
      context.error(root.key_place(key),
                    "'" + std::string(key) + "' beside " +
                        (root.has("loop") ? "[[loop]]" : "a joint that follows by powers of another"),
                    "it belongs to a chain; name the platform's joints by outputs = [...]");
}

}  // namespace

std::vector<Table> loop_tables(const Table& root) {
  std::vector<Table> tables = root.tables("loop");
  if (tables.size() <= most_loops) return tables;
  root.context().error(tables[most_loops].place(), std::to_string(tables.size()) + " loops are too many",
                       "a robot has at most " + std::to_string(most_loops));
  return {};
}

void read_loops(const Table& root, model::Mechanism& mechanism) {
  Context& context = root.context();
  model::Loops& loops = mechanism.loops;
  if (!root.has("loop") && !follow_powers(context)) {
    for (const char* key : {"actuated", "outputs"})
      if (root.has(key))
        context.error(root.key_place(key), "'" + std::string(key) + "' without [[loop]]",
                      "all joints of a tree are driven; a loop makes some of them passive");
    return;
  }
  LoopNames names = names_of(context, mechanism.robot);
  for (const Table& table : loop_tables(root)) {
    loops.closures.push_back(read_loop(table, names));
    check_joints(table, mechanism.robot, loops.closures.back());
  }
  refuse_beside_loops(root);
  make_motors_joints(context, mechanism.robot);
  names.joints.clear();
  for (const model::Joint& joint : mechanism.robot.joints) names.joints.push_back(joint.variable);
  loops.gears = gears_of(context, names.joints, mechanism.robot);
  loops.actuated = read_joint_list(root, "actuated", names);
  if (loops.actuated.empty()) drive_leaders(mechanism);
  loops.outputs = read_joint_list(root, "outputs", names);
}

}  // namespace qvgen::description
