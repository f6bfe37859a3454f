// SPDX-License-Identifier: MIT
#include "description/loops.h"

#include <algorithm>

#include "description/entries.h"
#include "description/frames.h"
#include "description/names.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

constexpr std::size_t most_loops = 32;
const std::string base_name = "base";

/// The index of a joint by its variable; reported if there is none.
std::optional<std::size_t> joint_of(Context& context, const toml::node& node, const model::Robot& robot,
                                    bool takes_base) {
  const auto name = node.value_exact<std::string>();
  if (!name) {
    report_type(context, node, "the name of a link", "the variable of the joint that moves it, in quotes");
    return std::nullopt;
  }
  if (takes_base && *name == base_name) return model::base_link;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (robot.joints[i].variable == *name) return i;
    names.push_back(robot.joints[i].variable);
  }
  if (takes_base) names.push_back(base_name);
  const std::string near = nearest(*name, names);
  context.error(begin_of(node.source()), "there is no joint with the variable '" + *name + "'",
                !near.empty() ? "did you mean '" + near + "'?"
                : takes_base  ? "a link is called by the variable of the joint that moves it, or \"base\""
                              : "name the variables of joints");
  return std::nullopt;
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

void read_links(const Table& table, const model::Robot& robot, model::Loop& loop) {
  Context& context = table.context();
  const toml::array* between = array_of(table, "between", 2, "[\"theta1\", \"theta2\"]");
  if (between == nullptr) return;
  bool known = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto link = joint_of(context, *between->get(i), robot, true);
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
  table.require("type", "type = \"pin\", \"ball\" or \"rod\"");
  const std::string type = table.text("type").value_or("pin");
  if (type == "pin") loop.type = model::LoopType::pin;
  if (type == "ball") loop.type = model::LoopType::ball;
  if (type == "rod") loop.type = model::LoopType::rod;
  if (type != "pin" && type != "ball" && type != "rod")
    table.context().error(table.place_of("type"), "unknown type of loop '" + type + "'",
                          "write pin, ball or rod; a weld is a link of the tree, a slide a prismatic joint");
}

/// A key that belongs to another type of loop.
void refuse_key(const Table& table, const std::string& key, const std::string& of) {
  if (table.has(key))
    table.context().error(table.key_place(key), "'" + key + "' belongs to " + of, "leave it out");
}

/// True if the length of a rod is the value of a slide, by its variable; one of another joint is reported.
bool reads_length_joint(const Table& table, const model::Robot& robot, model::Loop& loop) {
  const toml::node* node = table.find("length");
  const auto name = node == nullptr ? std::nullopt : node->value_exact<std::string>();
  for (std::size_t i = 0; name && i < robot.joints.size(); ++i) {
    if (robot.joints[i].variable != *name) continue;
    loop.length_joint = i;
    if (robot.joints[i].type != model::JointType::prismatic)
      table.context().error(table.place_of("length"), "joint " + *name + " turns: it is no length",
                            "name a prismatic joint, whose value is the length of the rod, or a number");
    return true;
  }
  return false;
}

void read_length(const Table& table, const model::Robot& robot, model::Loop& loop) {
  if (loop.type != model::LoopType::rod) return refuse_key(table, "length", "a rod");
  if (reads_length_joint(table, robot, loop)) return;
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
  if (loop.type != model::LoopType::pin) return refuse_key(table, "axis", "a pin");
  if (const toml::node* axis = table.find("axis")) loop.axis = read_axis(table.context(), *axis);
}

model::Loop read_loop(const Table& table, const model::Robot& robot) {
  table.allow_only({"type", "between", "at", "axis", "length"});
  model::Loop loop;
  read_type(table, loop);
  read_links(table, robot, loop);
  read_points(table, loop);
  read_length(table, robot, loop);
  read_loop_axis(table, loop);
  return loop;
}

/// Indices of the joints that a list names, each once.
std::vector<std::size_t> read_joint_list(const Table& root, const std::string& key,
                                         const model::Robot& robot) {
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
    const auto joint = joint_of(context, element, robot, false);
    if (!joint) continue;
    if (std::find(joints.begin(), joints.end(), *joint) != joints.end())
      context.error(begin_of(element.source()), "'" + key + "' names this joint twice", "name it once");
    joints.push_back(*joint);
  }
  return joints;
}

/// Requests of a chain and joints that follow others have no meaning yet beside loops.
void refuse_beside_loops(const Table& root) {
  Context& context = root.context();
  for (const char* key : {"task", "tool_axis", "given", "ideal"})
    if (root.has(key))
      context.error(root.key_place(key), "'" + std::string(key) + "' beside [[loop]]",
                    "it belongs to a chain; name the platform's joints by outputs = [...]");
  for (const Follower& follower : context.followers)
    context.error(follower.place, "a joint that follows another beside [[loop]]",
                  "give it a value of its own, or leave the loops out");
}

}  // namespace

void read_loops(const Table& root, model::Mechanism& mechanism) {
  Context& context = root.context();
  const model::Robot& robot = mechanism.robot;
  model::Loops& loops = mechanism.loops;
  if (!root.has("loop")) {
    for (const char* key : {"actuated", "outputs"})
      if (root.has(key))
        context.error(root.key_place(key), "'" + std::string(key) + "' without [[loop]]",
                      "all joints of a tree are driven; a loop makes some of them passive");
    return;
  }
  const std::vector<Table> tables = root.tables("loop");
  if (tables.size() > most_loops) {
    context.error(tables[most_loops].place(), std::to_string(tables.size()) + " loops are too many",
                  "a robot has at most " + std::to_string(most_loops));
    return;
  }
  for (const Table& table : tables) loops.closures.push_back(read_loop(table, robot));
  refuse_beside_loops(root);
  root.require("actuated", "actuated = [\"theta1\"], the variables of the joints that are driven");
  loops.actuated = read_joint_list(root, "actuated", robot);
  loops.outputs = read_joint_list(root, "outputs", robot);
}

}  // namespace qvgen::description
