// SPDX-License-Identifier: MIT
#include "model/replace.h"

#include <algorithm>

#include <cln/cln.h>

namespace qvgen::model {
namespace {

using Replacement = std::function<Expression(const std::string&)>;

Expression replaced(const Expression& e, const Replacement& by) {
  if (e.kind() == Expression::Kind::symbol) return by(e.name());
  if (e.operands().empty()) return e;
  std::vector<Expression> operands;
  for (const Expression& operand : e.operands()) operands.push_back(replaced(operand, by));
  if (e.kind() == Expression::Kind::power) return Expression::power(operands.front(), e.exponent());
  return Expression::make(e.kind(), std::move(operands));
}

Vector3 replaced(const Vector3& v, const Replacement& by) {
  return {replaced(v[0], by), replaced(v[1], by), replaced(v[2], by)};
}

Displacement replaced(Displacement displacement, const Replacement& by) {
  for (Turn& turn : displacement.turns) turn = {replaced(turn.axis, by), replaced(turn.angle, by)};
  displacement.translation = replaced(displacement.translation, by);
  return displacement;
}

}  // namespace

Robot replace_symbols(const Robot& robot, const Replacement& by) {
  Robot result = robot;
  result.base = replaced(robot.base, by);
  result.tool = replaced(robot.tool, by);
  for (Joint& joint : result.joints) {
    joint.before = replaced(joint.before, by);
    joint.axis = replaced(joint.axis, by);
    joint.after = replaced(joint.after, by);
  }
  return result;
}

Bindings sample_geometry(const Robot& robot) {
  Bindings values = default_bindings(robot);
  constexpr double golden_ratio = 0.6180339887498949;
  double share = golden_ratio;
  for (const Parameter& parameter : robot.geometry) {
    share += share < 1 - golden_ratio ? golden_ratio : golden_ratio - 1;
    if (values.count(parameter.name) == 0) values[parameter.name] = cln::rational(cln::cl_float(1 + share));
  }
  return values;
}

Robot with_geometry(const Robot& robot, const Bindings& values) {
  const auto is_parameter = [&](const std::string& name) {
    return std::any_of(robot.geometry.begin(), robot.geometry.end(),
                       [&](const Parameter& parameter) { return parameter.name == name; });
  };
  Robot result = replace_symbols(robot, [&](const std::string& name) {
    if (!is_parameter(name)) return Expression::symbol(name);
    return Expression(cln::rational(cln::cl_float(to_double(values.at(name)))));
  });
  result.geometry.clear();
  return result;
}

}  // namespace qvgen::model
