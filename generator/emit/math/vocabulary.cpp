// SPDX-License-Identifier: MIT
#include "emit/math/vocabulary.h"

#include <algorithm>
#include <array>

#include "model/private_names.h"

namespace qvgen::emit {

using derive::inverse::Step;

namespace {

bool begins(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }
std::string after(const std::string& text, const std::string& start) { return text.substr(start.size()); }

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts{""};
  for (const char letter : name)
    if (letter == '_')
      parts.emplace_back();
    else
      parts.back() += letter;
  return parts;
}

}  // namespace

Vocabulary::Vocabulary(const derive::inverse::Plan& plan, std::vector<std::string> variables,
                       Notation notation)
    : variables_(std::move(variables)), latex_(notation == Notation::latex), notation_(notation) {
  for (const std::string& variable : variables_)
    for (const Step& step : plan.steps)
      for (const auto& output : step.after.outputs())
        if (output.name == "plane_" + variable + "_x") planes_.push_back(variable);
}

std::string Vocabulary::variable(const std::string& name) const { return formula(name, notation_); }

std::string Vocabulary::symbol(const std::string& letters, const std::string& index) const {
  if (index.empty()) return latex_ && letters.size() > 1 ? "\\mathrm{" + letters + "}" : letters;
  if (!latex_) return letters + "_" + index;
  return (letters.size() > 1 ? "\\mathrm{" + letters + "}" : letters) + "_{" + index + "}";
}

std::string Vocabulary::function(const std::string& name, const std::string& of, bool half) const {
  if (of == "phi") return latex_ ? "\\" + name + " \\varphi" : name + "(phi)";
  // Parallel neighbours come as the sum of their angles.
  std::vector<std::string> terms = parts_of(of);
  const auto is_joint = [&](const std::string& term) {
    return std::find(variables_.begin(), variables_.end(), term) != variables_.end();
  };
  if (!std::all_of(terms.begin(), terms.end(), is_joint)) terms = {of};
  std::string sum;
  for (const std::string& term : terms)
    sum += (sum.empty() ? "" : "+") + (latex_ && half ? "\\bar{" + variable(term) + "}" : variable(term));
  const bool single = terms.size() == 1;
  if (latex_) return "\\" + name + (single ? " " + sum : "(" + sum + ")");
  return name + "(" + (half && !single ? "(" + sum + ")" : sum) + (half ? "/2)" : ")");
}

/// cos_result and the like: the angle φ or the length r that the step solves; for a half angle the very
/// angle.
std::string Vocabulary::solved(const std::string& name, const Step& step) const {
  if (name == "result") return "r";
  if (begins(name, "result_")) return symbol("r", after(name, "result_"));
  const bool half = step.is<derive::inverse::kind::Half>();
  return function(name.substr(0, 3), half ? step.unknown : "phi", half);
}

std::string Vocabulary::part_of_pose(const std::string& name) const {
  static const std::array<std::array<const char*, 2>, 7> parts{{{"pose_q_w", "w"},
                                                                {"pose_q_x", "a"},
                                                                {"pose_q_y", "b"},
                                                                {"pose_q_z", "c"},
                                                                {"pose_p_x", "x"},
                                                                {"pose_p_y", "y"},
                                                                {"pose_p_z", "z"}}};
  for (const auto& [own, theirs] : parts)
    if (name == own) return begins(name, "pose_p") ? symbol("p", theirs) : theirs;
  return {};
}

/// after_theta1_theta2_x: a component of the orientation with the joints up to theta2 taken off, N_32.
std::string Vocabulary::without_joints(const std::string& name) const {
  const std::vector<std::string> parts = parts_of(name);
  const auto place = std::find(variables_.begin(), variables_.end(), parts[parts.size() - 2]);
  const std::size_t component = std::string("wxyz").find(parts.back());
  if (place == variables_.end() || component == std::string::npos) return other(name);
  return symbol("N", std::to_string(place - variables_.begin() + 2) + std::to_string(component + 1));
}

std::string Vocabulary::other(const std::string& name) const {
  std::vector<std::string> parts = parts_of(name);
  std::string index;
  for (std::size_t i = 1; i < parts.size(); ++i)
    index += (i == 1 ? "" : latex_ ? "," : "_") + variable(parts[i]);
  const std::vector<std::string>& known = variables_;
  if (parts.size() == 1 || std::find(known.begin(), known.end(), name) != known.end()) return variable(name);
  return symbol(parts[0], index);
}

std::string Vocabulary::operator()(const std::string& name, const Step& step) const {
  if (model::is_marked(name)) return other(model::described_name(name));
  if (name == "cos_result" || name == "sin_result" || begins(name, "result")) return solved(name, step);
  if (const std::string pose = part_of_pose(name); !pose.empty()) return pose;
  if (begins(name, "after_")) return without_joints(name);
  for (const char* trigonometric : {"cos", "sin"}) {
    const std::string start = std::string(trigonometric) + "_";
    if (!begins(name, start)) continue;
    const bool half = begins(name, start + "half_");
    return function(trigonometric, after(name, start + (half ? "half_" : "")), half);
  }
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if (begins(name, "plane_" + planes_[i] + "_"))
      return symbol(i == 0 ? "N" : "M", name.substr(name.size() - 1));
  return other(name);
}

std::string Vocabulary::sentence(std::string text) const {
  if (!latex_) return text;
  for (const std::string& name : variables_) {
    const std::string typeset = "$" + variable(name) + "$";
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + typeset.size()))
      text.replace(at, name.size(), typeset);
  }
  std::string escaped;
  bool formula = false;
  for (const char letter : text) {
    formula = formula != (letter == '$');
    escaped += (letter == '_' && !formula ? "\\" : "") + std::string(1, letter);
  }
  return escaped;
}

}  // namespace qvgen::emit
