// SPDX-License-Identifier: MIT
#include "model/private_names.h"

#include <algorithm>
#include <cctype>

#include "model/replace.h"

namespace qvgen::model {
namespace {

const std::string mark = "g.";

bool is_letters_and_number(const std::string& name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto number = std::find_if_not(name.begin(), name.end(), is_letter);
  return number != name.begin() && number != name.end() && std::all_of(number, name.end(), is_digit);
}

}  // namespace

Robot with_private_names(const Robot& robot) {
  Robot result =
      replace_symbols(robot, [](const std::string& name) { return Expression::symbol(mark + name); });
  for (Parameter& parameter : result.geometry) parameter.name = mark + parameter.name;
  const bool keep = std::all_of(robot.joints.begin(), robot.joints.end(),
                                [](const Joint& joint) { return is_letters_and_number(joint.variable); });
  for (std::size_t i = 0; i < result.joints.size(); ++i) {
    Joint& joint = result.joints[i];
    if (keep) continue;
    joint.variable = "joint" + std::to_string(i + 1);
    std::replace(result.inverse.given.begin(), result.inverse.given.end(), robot.joints[i].variable,
                 joint.variable);
  }
  return result;
}

bool is_marked(const std::string& name) { return name.rfind(mark, 0) == 0; }

std::string described_name(const std::string& name) {
  return is_marked(name) ? name.substr(mark.size()) : name;
}

std::string without_marks(std::string text) {
  for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
    text.erase(at, mark.size());
  return text;
}

}  // namespace qvgen::model
