// SPDX-License-Identifier: MIT
#include "derive/inverse/spherical_arm.h"

#include <algorithm>
#include <optional>

#include "derive/inverse/attempt.h"
#include "derive/inverse/lower.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

/// The point of three axes, or why they do not make a spherical joint.
struct Centre {
  std::optional<Vector> point;
  std::string reason;
};

Centre centre_of(const std::vector<Screw>& screws, std::size_t k, const Scope& scope) {
  const std::string axes = "the axes of joints " + std::to_string(k + 1) + ", " + std::to_string(k + 2) +
                           " and " + std::to_string(k + 3);
  const auto point = meeting_point(screws[k], screws[k + 1], scope);
  if (!point || !scope.is_zero(cross(screws[k + 2].axis, *point - screws[k + 2].point)))
    return {std::nullopt, axes + " do not meet in one point"};
  if (scope.is_zero(cross(screws[k + 1].axis, screws[k + 2].axis)))
    return {std::nullopt, axes + " do not make a spherical joint: two of them are one"};
  return {point, ""};
}

/// The point of a screw's axis that is next to another.
Vector foot(const Screw& screw, const Vector& point, const Scope& scope) {
  return scope.clean(screw.point + scope.clean(dot(point - screw.point, screw.axis)) * screw.axis);
}

SphericalArm none(const std::string& reason) {
  SphericalArm arm;
  arm.reason = reason;
  return arm;
}

}  // namespace

bool has_seven_turns(const model::Robot& robot) {
  return robot.joints.size() == 7 &&
         std::all_of(robot.joints.begin(), robot.joints.end(),
                     [](const model::Joint& joint) { return joint.type == model::JointType::revolute; });
}

SphericalArm spherical_arm(const model::Robot& robot) {
  if (!has_seven_turns(robot)) return none("only arms with seven turns have one");
  Scope scope(robot);
  symbolic::Program program;
  const Chain chain = chain_of(robot, scope, program);
  const auto& screws = chain.screws;
  const Centre shoulder = centre_of(screws, 0, scope), wrist = centre_of(screws, 4, scope);
  for (const Centre& centre : {shoulder, wrist})
    if (!centre.point) return none(centre.reason);
  const Vector elbow = foot(screws[3], *shoulder.point, scope);
  const Vector upper = scope.clean(elbow - *shoulder.point);
  const Vector forearm = scope.clean(*wrist.point - elbow);
  if (scope.is_zero(upper)) return none("the axis of joint 4 goes through the shoulder");
  if (scope.is_zero(cross(forearm, screws[3].axis)))
    return none("the axis of joint 4 goes through the wrist");

  std::vector<std::string> kept;
  const auto output = [&](const std::string& name, const GiNaC::ex& value) {
    program.output(name, value);
    kept.push_back(name);
  };
  const auto output_vector = [&](const std::string& name, const Vector& v) {
    output(name + "_x", v.x);
    output(name + "_y", v.y);
    output(name + "_z", v.z);
  };
  for (std::size_t i = 0; i < screws.size(); ++i)
    output_vector("axis" + std::to_string(i + 1), screws[i].axis);
  output_vector("base", symbolic::to_symbolic(robot.base).p);
  output_vector("shoulder", *shoulder.point);
  output_vector("elbow", elbow);
  output_vector("wrist", *wrist.point);
  output("turn_w", chain.home.q.w);
  output_vector("turn", {chain.home.q.x, chain.home.q.y, chain.home.q.z});
  output_vector("place", chain.home.p);

  SphericalArm arm;
  arm.found = true;
  arm.planar = scope.is_zero(dot(forearm, screws[3].axis));
  arm.values = lowered(program, kept);
  return arm;
}

}  // namespace qvgen::derive::inverse
