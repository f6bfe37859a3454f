// SPDX-License-Identifier: MIT
// Newton's steps in C: what fills in the task and the joints' values, what takes these back, and between them
// the tracker of all branches or of the seed's.
#include "emit/c/printer.h"

namespace qvgen::emit::c {
namespace {

std::string set_triple(const std::string& place, const std::string& name) {
  return "set_triple(" + place + ", " + name + "_x, " + name + "_y, " + name + "_z);";
}

std::string entry(const std::string& array, std::size_t i) { return array + "[" + std::to_string(i) + "]"; }

void add_indented(ast::Lines& to, const ast::Lines& lines) {
  for (const std::string& each : lines) to.push_back("  " + each);
}

}  // namespace

ast::Lines Printer::task_of(const ast::Function& function) const {
  const ast::Polish& task = function.task;
  ast::Lines result = lines(function.body);
  const auto add = [&](const std::string& line) { result.push_back(line); };
  add("task->joints = " + std::to_string(task.axes.size()) + ";");
  add("task->points = " + std::to_string(task.start.size()) + ";");
  add("task->size_square = " + text(task.size_square) + ";");
  for (std::size_t i = 0; i < task.axes.size(); ++i) {
    add(entry("task->arm", i) + ".revolute = " + (task.revolute[i] ? "true;" : "false;"));
    add(set_triple(entry("task->arm", i) + ".axis", task.axes[i]));
    add(set_triple(entry("task->arm", i) + ".point", task.points[i]));
    add(entry("values->of", i) + " = " + text(task.from[i]) + ";");
    add(entry("seed->of", i) + " = " + text(task.seed[i]) + ";");
  }
  for (std::size_t i = 0; i < task.start.size(); ++i) {
    add(set_triple(entry("task->start", i), task.start[i]));
    add(set_triple(entry("task->goal", i), task.goal[i]));
  }
  return result;
}

ast::Lines Printer::polish(const ast::Function& function) const {
  const std::string step = function.name.substr(std::string("solve_").size());
  const std::string target = "const " + prefix_ + "Target* t", work = prefix_ + "Work* w";
  const std::string tracker = function.parameters[2].type.name;
  const std::string settle = tracker == "Visited" ? "settle_visit" : "settle_branch";
  ast::Lines result;
  for (const std::string& each : function.comment) result.push_back("/// " + each);
  result.push_back("static void " + prefix_ + "task_of_" + step + "(" + target + ", const " + work +
                   ", PointMatching* task, JointValues* values, JointValues* seed) {");
  add_indented(result, task_of(function));
  result.insert(result.end(), {"}", "",
                               "static void " + prefix_ + "take_values_of_" + step +
                                   "(const JointValues* values, " + work + ") {"});
  add_indented(result, lines(function.task.back));
  result.insert(result.end(), {"}", ""});
  const auto settled = [&](const std::string& name, const std::string& parameters, const std::string& by) {
    result.push_back("static bool " + prefix_ + name + "(" + target + ", " + parameters + ", " + work +
                     ") {");
    add_indented(result, {"PointMatching task;", "JointValues values, seed;",
                          prefix_ + "task_of_" + step + "(t, w, &task, &values, &seed);",
                          "if (!" + by +
                              ", &task, &t->boundary, t->preference->seeded ? &seed : NULL, &values, "
                              "&w->branch)) return false;",
                          prefix_ + "take_values_of_" + step + "(&values, w);", "return true;"});
    result.emplace_back("}");
  };
  settled("solve_" + step, "int label, " + tracker + "* tracker", settle + "(tracker, label");
  result.emplace_back();
  settled("solve_" + step + "_near_seed", "SeedTracker* tracker", "settle_near_seed(tracker");
  return result;
}

}  // namespace qvgen::emit::c
