// SPDX-License-Identifier: MIT
#include "derive/loops/named_angles.h"

#include "exact/named_constant.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::derive::loops {
namespace {

model::Expression symbol_of(const cln::cl_R& value) {
  const model::Expression size = model::Expression::symbol(exact::name_of_angle(cln::abs(value)));
  return cln::minusp(value) ? model::negate(size) : size;
}

model::Expression named(const model::Expression& angle) {
  const auto form = model::angle_form(angle);
  const bool is_number = form.has_value() || model::symbols(angle).empty();
  const bool is_exact = form && cln::zerop(form->radians) && cln::denominator(form->half_turns * 12) == 1;
  if (!is_number || is_exact) return angle;
  return symbol_of(model::evaluate(angle));
}

}  // namespace

std::vector<model::Turn> with_named_angles(std::vector<model::Turn> turns) {
  for (model::Turn& turn : turns) turn.angle = named(turn.angle);
  return turns;
}

model::Robot with_named_angles(model::Robot robot) {
  for (model::Joint& joint : robot.joints)
    for (model::Displacement* frame : {&joint.before, &joint.after})
      frame->turns = with_named_angles(frame->turns);
  return robot;
}

model::Expression with_named_number(const model::Expression& value) {
  if (!model::symbols(value).empty() || model::rational_value(model::evaluate(value))) return value;
  return symbol_of(model::evaluate(value));
}

model::Turn turn_by_offset(const model::Gear& gear) {
  const model::Vector3 z{model::Expression(), model::Expression(), model::Expression(cln::cl_RA(1))};
  return with_named_angles(std::vector<model::Turn>{{z, gear.offset}}).front();
}

inverse::Scope scope_of(model::Robot robot, const model::Loops& loops) {
  for (const model::Loop& loop : loops.closures)  // a scope knows the symbols of all frames
    for (const model::Turn& turn : with_named_angles(loop.turns)) robot.tool.turns.push_back(turn);
  for (const model::Gear& gear : loops.gears)
    if (robot.joints[gear.joint].type == model::JointType::revolute && model::symbols(gear.offset).empty())
      robot.tool.turns.push_back(turn_by_offset(gear));
  return inverse::Scope(robot);
}

}  // namespace qvgen::derive::loops
