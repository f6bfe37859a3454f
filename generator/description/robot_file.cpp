// SPDX-License-Identifier: MIT
#include "description/robot_file.h"

#include <algorithm>

#include "description/loops.h"
#include "description/names.h"
#include "description/physics.h"
#include "description/plain_text.h"
#include "description/size_limits.h"
#include "description/xml/file_text.h"
#include "description/xml/reader.h"

namespace qvgen::description {
namespace {

using tree::Closure;
using tree::Node;

/// The URDF's <robot>; nothing where it cannot be read, which is reported.
std::optional<xml::Element> element_of(const Table& root) {
  Context& context = root.context();
  const std::string name = root.text("robot").value_or("");
  const Place place = root.place_of("robot");
  const auto path = std::filesystem::path(context.source.file()).parent_path() / name;
  const xml::FileText file = xml::read_text_of(path, max_file_size);
  if (name.empty() || file.is_too_large || !file.problem.empty()) {
    const std::string problem = file.is_too_large ? "too large" : file.problem;
    context.error(place, "cannot read " + path.string() + ": " + problem,
                  "name a URDF by its path from the folder of this file");
    return std::nullopt;
  }
  context.files.push_back(path.string());
  auto element = xml::parse(context, file.text, static_cast<int>(context.files.size()));
  if (element && element->name == "robot") return element;
  if (element)
    context.error(element->place, "<" + element->name + "> is no URDF",
                  "a URDF begins with <robot>; an MJCF has its loops in <equality>");
  return std::nullopt;
}

LoopNames names_of(const std::vector<Node>& nodes) {
  LoopNames names;
  names.told = "link";
  names.hint = "name links of the URDF";
  for (const Node& node : nodes) {
    names.links.push_back(node.name);
    if (node.moves) names.joints.push_back(node.joint);
  }
  return names;
}

Closure closure_of(const Table& table, const LoopNames& names) {
  const model::Loop loop = read_loop(table, names);
  Closure closure{loop.type, loop.links, {}, loop.axis, loop.length, {}, table.place()};
  closure.frames = {{{loop.turns, loop.points[0]}, {{}, loop.points[1]}}};
  if (loop.length_joint) closure.length_joint = names.joints[*loop.length_joint];
  return closure;
}

/// Names of joints in a list of the file.
tree::JointNames joints_of(const Table& root, const std::string& key) {
  tree::JointNames joints;
  if (!root.has(key)) return joints;
  joints.place = root.place_of(key);
  const toml::array* array = root.find(key)->as_array();
  if (array == nullptr) report_type(root.context(), *root.find(key), "'" + key + "'", "a list of joints");
  for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
    joints.names.push_back(array->get(i)->value_or(std::string()));
  return joints;
}

tree::Loops loops_of(const Table& root) {
  tree::Loops loops;
  loops.any =
      root.require("loop", "[[loop]] tables; a robot without loops needs no file beside its URDF") != nullptr;
  loops.read = [&root](const std::vector<Node>& nodes) {
    const LoopNames names = names_of(nodes);
    std::vector<Closure> closures;
    for (const Table& table : loop_tables(root)) closures.push_back(closure_of(table, names));
    for (const SymbolUse& use : root.context().uses)
      root.context().error(use.place, "the name '" + use.name + "' beside a URDF, which has no symbols",
                           "write a number");
    return closures;
  };
  loops.leave_out = [&root] {
    root.context().error(root.place_of("loop"), "loops of a chain",
                         "loops belong to whole robots: leave --tip out");
  };
  loops.actuated = joints_of(root, "actuated");
  loops.outputs = joints_of(root, "outputs");
  return loops;
}

/// The name in this file, or that of the URDF.
void name_robot(const Table& root, const xml::Element& element, model::Robot& robot) {
  Context& context = root.context();
  const xml::Attribute* own = element.attribute("name");
  robot.name = root.text("name").value_or(tree::robot_identifier(own == nullptr ? "robot" : own->value));
  if (const NameProblem problem = check_robot_name(robot.name); !problem.message.empty())
    context.error(root.place_of("name"), problem.message, problem.hint);
  robot.title = root.text("title").value_or(robot.title);
  robot.source = root.text("source").value_or(
      std::filesystem::path(root.text("robot").value_or("")).filename().string());
  for (const std::string* text : {&robot.title, &robot.source})
    if (const std::string problem = problem_of_text(*text); !problem.empty())
      context.error(root.place_of("robot"), "the robot's title or source " + problem, "use plain text");
}

}  // namespace

model::Mechanism read_robot_file(const Table& root) {
  Context& context = root.context();
  root.allow_only({"robot", "name", "title", "source", "loop", "actuated", "outputs"});
  const auto element = element_of(root);
  if (!element) return {};
  model::Mechanism mechanism = xml::read_urdf(context, *element, loops_of(root));
  name_robot(root, *element, mechanism.robot);
  if (!context.has_error) check_inertia(context, mechanism.robot);
  if (!context.has_error) check_size(context, mechanism.robot);
  return mechanism;
}

}  // namespace qvgen::description
