// SPDX-License-Identifier: MIT
#include "model/private_names.h"

#include <algorithm>
#include <cctype>

namespace qvgen::model {
namespace {

const std::string mark = "g.";

Expression marked(const Expression& e) {
  if (e.kind() == Expression::Kind::symbol) return Expression::symbol(mark + e.name());
  if (e.operands().empty()) return e;
  std::vector<Expression> operands;
  for (const Expression& operand : e.operands()) operands.push_back(marked(operand));
  if (e.kind() == Expression::Kind::power) return Expression::power(operands.front(), e.exponent());
  return Expression::make(e.kind(), std::move(operands));
}

Vector3 marked(const Vector3& v) { return {marked(v[0]), marked(v[1]), marked(v[2])}; }

Displacement marked(Displacement displacement) {
  for (Turn& turn : displacement.turns) turn = {marked(turn.axis), marked(turn.angle)};
  displacement.translation = marked(displacement.translation);
  return displacement;
}

bool is_letters_and_number(const std::string& name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto number = std::find_if_not(name.begin(), name.end(), is_letter);
  return number != name.begin() && number != name.end() && std::all_of(number, name.end(), is_digit);
}

}  // namespace

Robot with_private_names(const Robot& robot) {
  Robot result = robot;
  result.base = marked(robot.base);
  result.tool = marked(robot.tool);
  for (Parameter& parameter : result.geometry) parameter.name = mark + parameter.name;
  const bool keep = std::all_of(robot.joints.begin(), robot.joints.end(),
                                [](const Joint& joint) { return is_letters_and_number(joint.variable); });
  for (std::size_t i = 0; i < result.joints.size(); ++i) {
    Joint& joint = result.joints[i];
    joint.before = marked(joint.before);
    joint.axis = marked(joint.axis);
    joint.after = marked(joint.after);
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
