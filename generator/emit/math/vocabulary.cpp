// SPDX-License-Identifier: MIT
#include "emit/math/vocabulary.h"

#include <algorithm>
#include <array>

#include "derive/inverse/names.h"
#include "model/private_names.h"

namespace qvgen::emit {

namespace names = derive::inverse::names;

using derive::inverse::Step;

namespace {

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
    : variables_(std::move(variables)), latex_(notation.typeset), notation_(notation) {
  for (const std::string& variable : variables_)
    for (const Step& step : plan.steps)
      for (const auto& output : step.after.outputs())
        if (output.name == names::plane(variable, "x")) planes_.push_back(variable);
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

/// The angle φ or the length r that the step solves; for a half angle the very angle. Nothing for another
/// name.
std::string Vocabulary::solved(const std::string& name, const Step& step) const {
  if (name == names::result) return "r";
  if (name == names::result_1) return symbol("r", "1");
  if (name == names::result_2) return symbol("r", "2");
  if (name != names::cosine_result && name != names::sine_result) return {};
  const bool half = step.is<derive::inverse::kind::Half>();
  return function(name == names::cosine_result ? "cos" : "sin", half ? step.unknown : "phi", half);
}

/// The quaternion's components are w, a, b, c.
std::string Vocabulary::part_of_pose(const std::string& name) const {
  if (const auto component = names::behind(std::string(names::pose_quaternion) + "_", name))
    return *component == "x" ? "a" : *component == "y" ? "b" : *component == "z" ? "c" : *component;
  const auto component = names::behind(std::string(names::pose_position) + "_", name);
  return component ? symbol("p", *component) : "";
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
  if (const std::string found = solved(name, step); !found.empty()) return found;
  if (const std::string pose = part_of_pose(name); !pose.empty()) return pose;
  if (names::behind(names::orientation_without(""), name)) return without_joints(name);
  for (const bool is_cosine : {true, false}) {
    const auto angle = names::behind(is_cosine ? names::cosine("") : names::sine(""), name);
    if (!angle) continue;
    const auto halved = names::behind(names::half(""), *angle);
    return function(is_cosine ? "cos" : "sin", halved.value_or(*angle), halved.has_value());
  }
  for (std::size_t i = 0; i < planes_.size(); ++i)
    for (const char* coordinate : {"x", "y"})
      if (name == names::plane(planes_[i], coordinate)) return symbol(i == 0 ? "N" : "M", coordinate);
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
