// SPDX-License-Identifier: MIT
#include "model/merged_joints.h"

#include <algorithm>

#include "model/arithmetic.h"
#include "model/followers.h"

namespace qvgen::model {
namespace {

bool is_nothing(const Displacement& displacement) {
  return displacement.turns.empty() && is_literal_zero(displacement.translation);
}

bool same(const Vector3& a, const Vector3& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](const Expression& x, const Expression& y) { return model::same(x, y); });
}

/// 1 if two joints move about or along one line in one sense, -1 in opposite ones, else 0.
int sense_on_one_line(const Joint& a, const Joint& b) {
  if (a.type != b.type || !is_nothing(a.after) || !is_nothing(b.before)) return 0;
  if (same(a.axis, b.axis)) return 1;
  const Vector3 opposite{negate(b.axis[0]), negate(b.axis[1]), negate(b.axis[2])};
  return same(a.axis, opposite) ? -1 : 0;
}

Follows leads_of(const Joint& joint) {
  return joint.follows.empty() ? Follows{{joint.variable, 1}} : joint.follows;
}

/// The sum of the first joint's leads and of the second's with a sign.
Follows sum(const Follows& a, const Follows& b, int sign) {
  Follows result = a;
  for (const Lead& lead : b) {
    const cln::cl_RA ratio = lead.ratio * sign;
    const auto known = std::find_if(result.begin(), result.end(),
                                    [&](const Lead& each) { return each.variable == lead.variable; });
    if (known == result.end())
      result.push_back({lead.variable, ratio});
    else
      known->ratio = known->ratio + ratio;
  }
  result.erase(
      std::remove_if(result.begin(), result.end(), [](const Lead& lead) { return cln::zerop(lead.ratio); }),
      result.end());
  return result;
}

/// Returns the motor that a joint which leads others becomes where it is merged.
Motor as_motor(const Joint& joint) {
  Motor motor;
  motor.type = joint.type;
  motor.variable = joint.variable;
  motor.limits = joint.limits;
  return motor;
}

/// Merges joints i and i + 1.
void merge(Robot& robot, std::size_t i, int sense) {
  const auto place = robot.joints.begin() + static_cast<std::ptrdiff_t>(i);
  const Joint second = *(place + 1);
  Joint& first = *place;
  for (const Joint* joint : {static_cast<const Joint*>(&first), &second})
    if (joint->follows.empty()) robot.motors.push_back(as_motor(*joint));
  first.follows = sum(leads_of(first), leads_of(second), sense);
  first.variable += "_" + second.variable;
  first.after = second.after;
  first.limits.reset();
  robot.joints.erase(place + 1);
  if (!robot.joints[i].follows.empty()) return;
  const Displacement fixed = compose(robot.joints[i].before, robot.joints[i].after);
  Displacement& next = i + 1 < robot.joints.size() ? robot.joints[i + 1].before : robot.tool;
  next = compose(fixed, next);
  robot.joints.erase(robot.joints.begin() + static_cast<std::ptrdiff_t>(i));
}

/// True if a joint that follows has limits that are no motor's.
bool has_own_limits(const Joint& joint) { return !joint.follows.empty() && joint.limits.has_value(); }

bool is_to_be_merged(const Joint& a, const Joint& b) {
  const bool follows = !a.follows.empty() || !b.follows.empty();
  return follows && !has_own_limits(a) && !has_own_limits(b) && sense_on_one_line(a, b) != 0;
}

}  // namespace

Robot with_merged_joints(const Robot& robot) {
  if (!has_followers(robot) || !robot.inverse.given.empty()) return robot;
  Robot result = robot;
  result.frames.clear();
  for (Joint& joint : result.joints) joint.drive = {};
  for (std::size_t i = 0; i + 1 < result.joints.size();) {
    const Joint &a = result.joints[i], &b = result.joints[i + 1];
    if (!is_to_be_merged(a, b)) {
      ++i;
      continue;
    }
    merge(result, i, sense_on_one_line(a, b));
    if (i > 0) --i;
  }
  const bool is_merged = result.joints.size() < robot.joints.size();
  return is_merged && variables(result) == variables(robot) ? result : robot;
}

}  // namespace qvgen::model
