// SPDX-License-Identifier: MIT
#include "description/robot_table.h"

#include <map>
#include <string>
#include <vector>

#include "description/branches.h"
#include "description/chain.h"
#include "description/followers.h"
#include "description/frames.h"
#include "description/loops.h"
#include "description/named_frames.h"
#include "description/names.h"
#include "description/physics.h"
#include "description/plain_text.h"
#include "description/request.h"
#include "description/root_keys.h"
#include "description/size_limits.h"
#include "description/symbols.h"

namespace qvgen::description {
namespace {

/// Titles and sources become comments of the generated code.
void check_line(const Table& root, const std::string& key, const std::string& text) {
  const std::string problem = problem_of_text(text);
  if (!problem.empty())
    root.context().error(root.place_of(key), "the " + key + " " + problem, "write one line of plain text");
}

void read_name(const Table& root, model::Robot& robot) {
  Context& context = root.context();
  root.require("name", "name = \"...\", the namespace of the generated code");
  root.require("title", "title = \"...\", one line of text");
  robot.name = root.text("name").value_or("");
  robot.title = root.text("title").value_or("");
  robot.source = root.text("source").value_or("");
  check_line(root, "title", robot.title);
  check_line(root, "source", robot.source);
  if (!root.has("name") || !root.find("name")->is_string()) return;
  const NameProblem problem = check_robot_name(robot.name);
  if (!problem.message.empty()) context.error(root.place_of("name"), problem.message, problem.hint);
}

/// Reports what the rows of a Denavit-Hartenberg table lack.
void say_that_nothing_moves(const Table& root) {
  Context& context = root.context();
  if (!root.has("dh"))
    return context.error({}, "no joints", "add [[joint]] tables, or [[dh]] rows, or [[screw]] axes");
  const auto& constants = context.constants_in_place_of_variables;
  const bool has_name = !constants.empty();
  context.error(has_name ? constants.front().place : root.place_of("dh"),
                "no joints: no row of the table has a variable" +
                    (has_name ? ", so that '" + constants.front().name + "' is a constant here" : ""),
                "add variable = \"" + (has_name ? constants.front().name : "theta1") +
                    "\" to this row, and so on to every row that moves");
}

void check_count(const Table& root, const model::Robot& robot) {
  Context& context = root.context();
  const bool is_hidden = context.has_error && (root.has("joint") || root.has("dh") || root.has("screw"));
  if (robot.joints.empty()) {
    if (!is_hidden) say_that_nothing_moves(root);
  } else if (const std::size_t most = root.has("tip") ? max_joints_of_tree : max_joints;
             robot.joints.size() > most) {
    const std::string limit = std::to_string(most);
    context.error(context.joint_places[most], std::to_string(robot.joints.size()) + " joints are too many",
                  "a robot has at most " + limit + " joints");
  }
}

/// The one form that the file uses, and no key of another.
void read_chain(const Table& root, const FreeParameters& free, model::Robot& robot) {
  struct Form {
    std::string key;
    std::string companion;
    void (*read)(const Table&, const FreeParameters&, model::Robot&);
  };
  static const std::vector<Form> forms{
      {"joint", "", read_joints}, {"dh", "convention", read_dh_table}, {"screw", "home", read_screws}};
  std::string chosen;
  for (const Form& form : forms) {
    if (!root.has(form.key)) {
      if (!form.companion.empty() && root.has(form.companion)) {
        root.context().error(root.key_place(form.companion),
                             "'" + form.companion + "' without [[" + form.key + "]]",
                             "it belongs to [[" + form.key + "]] tables");
      }
    } else if (chosen.empty()) {
      chosen = form.key;
      form.read(root, free, robot);
    } else {
      root.context().error(root.key_place(form.key), "[[" + form.key + "]] beside [[" + chosen + "]]",
                           "describe the chain in one form");
    }
  }
}

std::vector<std::string> variables_of(const model::Robot& robot) {
  std::vector<std::string> names;
  for (const model::Joint& joint : robot.joints) names.push_back(joint.variable);
  return names;
}

/// `unit` of lengths and `angle_unit`, in which the numbers of the whole file are.
void read_units(const Table& root) {
  Context& context = root.context();
  context.takes_units = true;
  static const std::map<std::string, cln::cl_RA> lengths{
      {"m", 1}, {"cm", cln::cl_RA(1) / 100}, {"mm", cln::cl_RA(1) / 1000}, {"in", cln::cl_RA(254) / 10000}};
  if (const auto unit = root.text("unit")) {
    const auto found = lengths.find(*unit);
    if (found == lengths.end())
      context.error(root.place_of("unit"), "unknown unit '" + *unit + "'", "write m, cm, mm or in");
    else
      context.units.length = found->second;
  }
  if (const auto unit = root.text("angle_unit")) {
    context.units.degrees = *unit == "deg";
    if (*unit != "deg" && *unit != "rad")
      context.error(root.place_of("angle_unit"), "unknown unit '" + *unit + "'", "write rad or deg");
  }
}

}  // namespace

model::Mechanism read_robot(const Table& root) {
  Context& context = root.context();
  root.allow_only(root_keys());
  read_units(root);
  context.is_measured = root.has("ideal");
  model::Mechanism mechanism;
  model::Robot& robot = mechanism.robot;
  read_name(root, robot);
  robot.base = read_frame(root, "base");
  robot.tool = read_frame(root, "tool");
  const FreeParameters free = read_free_parameters(root);
  robot.floating_base = read_floating_base(root, free);
  read_chain(root, free, robot);
  check_count(root, robot);
  read_motors(root, free, robot);
  read_named_frames(root, robot);
  mechanism.tips = read_tips(root, robot);
  if (!root.has("loop") && !follow_powers(context)) tie_followers(context, variables_of(robot), robot);
  read_loops(root, mechanism);
  read_request(root, robot);
  resolve_symbols(root, robot);
  const bool accept_inertia = root.boolean("accept_unphysical_inertia").value_or(false);
  check_default_values(context, robot);
  if (!accept_inertia && !context.has_error) check_inertia(context, robot);
  if (!context.has_error) check_size(context, robot);
  return mechanism;
}

}  // namespace qvgen::description
