// SPDX-License-Identifier: MIT
#include "evaluation.h"

#include <cmath>
#include <filesystem>

#include <cln/rational.h>
#include <gtest/gtest.h>

#include "description/reader.h"

namespace qvgen::test {

using model::Expression;
using Kind = Expression::Kind;

double value(const Expression& e, const Values& values) {
  const auto operand = [&](std::size_t i) { return value(e.operands().at(i), values); };
  double result = 0;
  switch (e.kind()) {
    case Kind::number:
      return cln::double_approx(e.number());
    case Kind::pi:
      return M_PI;
    case Kind::symbol:
      return values.at(e.name());
    case Kind::negate:
      return -operand(0);
    case Kind::sum:
      for (std::size_t i = 0; i < e.operands().size(); ++i) result += operand(i);
      return result;
    case Kind::product:
      result = 1;
      for (std::size_t i = 0; i < e.operands().size(); ++i) result *= operand(i);
      return result;
    case Kind::quotient:
      return operand(0) / operand(1);
    case Kind::power:
      return std::pow(operand(0), static_cast<double>(e.exponent()));
    case Kind::root:
      return std::sqrt(operand(0));
    case Kind::sine:
      return std::sin(operand(0));
    case Kind::cosine:
      return std::cos(operand(0));
  }
  return NAN;
}

Values default_values(const model::Robot& robot) {
  Values values;
  for (const auto* parameters : {&robot.geometry, &robot.inertia_parameters}) {
    for (const auto& parameter : *parameters) {
      if (parameter.default_value) values[parameter.name] = value(*parameter.default_value, {});
    }
  }
  return values;
}

namespace {

Eigen::Vector3d vector(const model::Vector3& v, const Values& values) {
  return {value(v[0], values), value(v[1], values), value(v[2], values)};
}

Eigen::Isometry3d motion(const model::Joint& joint, double q, const Values& values) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d axis = vector(joint.axis, values);
  if (joint.type == model::JointType::revolute) {
    result.rotate(Eigen::AngleAxisd(q, axis));
  } else {
    result.translate(q * axis);
  }
  return result;
}

}  // namespace

Eigen::Isometry3d displacement(const model::Displacement& displacement, const Values& values) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translate(vector(displacement.translation, values));
  for (const auto& turn : displacement.turns) {
    result.rotate(Eigen::AngleAxisd(value(turn.angle, values), vector(turn.axis, values)));
  }
  return result;
}

std::vector<Eigen::Isometry3d> link_frames(const model::Robot& robot, const std::vector<double>& q,
                                           const Values& values) {
  std::vector<Eigen::Isometry3d> frames;
  Eigen::Isometry3d frame = displacement(robot.base, values);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const model::Joint& joint = robot.joints[i];
    frame = frame * displacement(joint.before, values) * motion(joint, q.at(i), values) *
            displacement(joint.after, values);
    frames.push_back(frame);
  }
  return frames;
}

Eigen::Isometry3d tool_pose(const model::Robot& robot, const std::vector<double>& q, const Values& values) {
  return link_frames(robot, q, values).back() * displacement(robot.tool, values);
}

model::Robot robot_named(const std::string& name) {
  const auto path = std::filesystem::path(QVGEN_SOURCE_DIR) / "generator" / "robots" / (name + ".toml");
  const description::ReadResult result = description::read_file(path, {.strict = true});
  for (const auto& diagnostic : result.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  return result.robot.value_or(model::Robot{});
}

}  // namespace qvgen::test
