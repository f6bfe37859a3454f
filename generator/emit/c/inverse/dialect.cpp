// SPDX-License-Identifier: MIT
#include "emit/c/inverse/dialect.h"

#include "emit/c/function.h"

namespace qvgen::emit::c {
namespace {

std::string call(const std::string& name, const Dialect::Arguments& arguments) {
  std::string text;
  for (const std::string& each : arguments)
    if (!each.empty()) text += (text.empty() ? "" : ", ") + each;
  return name + "(" + text + ")";
}

std::string triple(const std::string& name) { return name + "_x, " + name + "_y, " + name + "_z"; }

}  // namespace

Spelling C::spelling() const { return c::spelling(); }

std::string C::rotor(const std::string& cosine, const std::string& sine) const {
  return call("rotor", {cosine, sine});
}

std::string C::product(const std::string& a, const std::string& b) const { return call("product", {a, b}); }

std::string C::scaled(const std::string& factor, const std::string& rotor) const {
  return call("scaled", {factor, rotor});
}

std::string C::inverse(const std::string& rotor) const { return call("inverse", {rotor}); }

std::string C::braces(const std::string& type, const Arguments& members) const {
  std::string text;
  for (const std::string& each : members) text += (text.empty() ? "" : ", ") + each;
  return "(" + type + "){" + text + "}";
}

std::string C::block(const std::string& name, const Arguments& arguments) const {
  return call(name, arguments);
}

std::string C::direction_block(const std::string& name, bool opposites, const Arguments& arguments) const {
  Arguments all = arguments;
  all.insert(all.begin(), opposites ? "true" : "false");
  return call(name, all);
}

std::string C::output_angle(const std::string& cosine, const std::string& sine,
                            const std::string& length) const {
  return call("output_angle", {cosine, sine, length.empty() ? "1.0" : length});
}

std::string C::turn_apart(const std::string& cosine, const std::string& sine, const std::string& seed) const {
  return call("turn_apart", {cosine, sine, seed});
}

std::string C::slide_apart(const std::string& value, const std::string& seed) const {
  return call("slide_apart", {value, seed});
}

std::string C::wrist_apart(const std::string& angles, const Arguments& seed) const {
  return call("wrist_apart", {angles, seed[0], seed[1], seed[2]});
}

std::string C::takes_other(const std::string& other, const std::string& other_apart,
                           const std::string& branch, const std::string& apart) const {
  return call("takes_other", {"forks", other, other_apart, branch, apart});
}

Dialect::Lines C::new_work(const std::string& name, bool all_zero) const {
  const std::string own = "own_" + name;
  Lines lines{prefix_ + "Work " + own + ";"};
  if (all_zero) lines.push_back("memset(&" + own + ", 0, sizeof " + own + ");");
  lines.push_back(own + ".branch = new_branch;");
  lines.push_back(prefix_ + "Work* const " + name + " = &" + own + ";");
  return lines;
}

Dialect::Lines C::copied_work(const std::string& name, const std::string& from) const {
  const std::string own = "own_" + name;
  return {prefix_ + "Work " + own + " = *" + from + ";",
          prefix_ + "Work* const " + name + " = &" + own + ";"};
}

std::string C::assign_work(const std::string& name, const std::string& from) const {
  return "*" + name + " = *" + from + ";";
}

std::string C::new_row(int /*size*/) const { return "double q[row_size];"; }

std::string C::save_branch(const std::string& name, const std::string& work) const {
  return "const Branch " + name + " = " + work + "->branch;";
}

std::string C::resume_branch(const std::string& work, const std::string& name) const {
  return call("resume", {"&" + work + "->branch", "&" + name}) + ";";
}

std::string C::constant(const std::string& type, const std::string& name, const std::string& value) const {
  return "const " + variable(type, name, value);
}

std::string C::variable(const std::string& type, const std::string& name, const std::string& value) const {
  return type + " " + name + " = " + value + ";";
}

std::string C::entry(const std::string& array, const std::string& index) const {
  return array + "[" + index + "]";
}

std::string C::append(const std::string& label, const std::string& work) const {
  return call("append", {"found", "q", label, work + "->branch.continuum"}) + ";";
}

std::string C::append_nearest(const std::string& work) const {
  return call("take_row", {"found", "q", "forks->label", work + "->branch.continuum"}) + ";";
}

std::string C::is_settled(const std::string& label, bool visits) const {
  return call(visits ? "visit_is_settled" : "is_settled", {"tracker", label});
}

std::string C::close(const std::string& label) const {
  return call("close_branch", {"tracker", label}) + ";";
}

std::string C::reopen(const std::string& label, const std::string& work, bool visits) const {
  return call(visits ? "reopen_visit" : "reopen_branch", {"tracker", label, work + "->branch.continuum"}) +
         ";";
}

/// Writes the bodies of two functions: one fills in the task and the values; the other, behind an empty line,
/// takes these back.
Dialect::Lines C::polish_lines(const PolishTask& task) const {
  Lines lines{"task->joints = " + std::to_string(task.axes.size()) + ";",
              "task->points = " + std::to_string(task.start.size()) + ";",
              "task->size_square = " + task.size_square + ";"};
  for (std::size_t i = 0; i < task.axes.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    lines.push_back("task->arm" + at + ".revolute = " + (task.revolute[i] ? "true;" : "false;"));
    lines.push_back(call("set_triple", {"task->arm" + at + ".axis", triple(task.axes[i])}) + ";");
    lines.push_back(call("set_triple", {"task->arm" + at + ".point", triple(task.points[i])}) + ";");
    lines.push_back(joint_value(i) + " = " + task.from[i] + ";");
    lines.push_back("seed->of" + at + " = " + task.seed[i] + ";");
  }
  for (std::size_t i = 0; i < task.start.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    lines.push_back(call("set_triple", {"task->start" + at, triple(task.start[i])}) + ";");
    lines.push_back(call("set_triple", {"task->goal" + at, triple(task.goal[i])}) + ";");
  }
  lines.emplace_back();
  lines.insert(lines.end(), task.back.begin(), task.back.end());
  return lines;
}

std::string C::polishes(const std::string& step, const std::string& target, const std::string& label,
                        const std::string& work, bool of_seed) const {
  const std::string name = "solve_" + step + (of_seed ? "_near_seed" : "");
  return call(function(name), {target, of_seed ? "" : label, "tracker", work});
}

std::string C::take_nearer(const std::string& other, const std::string& other_apart, const std::string& work,
                           const std::string& apart) const {
  return "if (" + takes_other("&" + other + "->branch", other_apart, "&" + work + "->branch", apart) + ") *" +
         work + " = *" + other + ";";
}

Dialect::Lines C::nearest_root(const std::string& number, const std::string& take, const std::string& apart,
                               int branches) const {
  const std::string k = "k" + number, each = "each" + number, nearest = "nearest" + number,
                    least = "least" + number, index = "index" + number;
  Lines lines = copied_work(nearest, "w");
  const auto add = [&](const Lines& more) { lines.insert(lines.end(), more.begin(), more.end()); };
  add({nearest + "->branch.exists = false;", "double " + least + " = 0;", "int " + index + " = 0;",
       "for (int " + k + " = 0; " + k + " < roots.count; ++" + k + ") {"});
  for (const std::string& line : copied_work(each, "w")) lines.push_back("  " + line);
  add({"  " + take, "  const double apart = " + apart + ";",
       "  if (!" + each + "->branch.exists || (" + nearest + "->branch.exists && !(apart < " + least +
           "))) continue;",
       "  *" + nearest + " = *" + each + ";", "  " + least + " = apart;", "  " + index + " = " + k + ";", "}",
       "forks->label = " + std::to_string(branches) + " * forks->label + " + index + ";",
       "*w = *" + nearest + ";"});
  return lines;
}

}  // namespace qvgen::emit::c
