// SPDX-License-Identifier: MIT
#include "emit/inverse/places.h"

#include "derive/inverse/names.h"

namespace qvgen::emit {

namespace names = derive::inverse::names;

using ast::Element;
using ast::Expression;
using ast::Reach;
using derive::inverse::LoweredPlan;
using derive::inverse::Plan;
using Kind = Expression::Kind;

namespace {

/// How long the pair is that a joint's angle is taken of: 1 but of a direction that is left as long as it is.
Expression length_of(const LoweredPlan& plan, const derive::inverse::JointValue& value,
                     const Expression& work) {
  for (const derive::inverse::Step& step : plan.plan.steps)
    if (step.keeps_length() && value.cosine == names::cosine(step.unknown))
      return length_place(work, step.unknown);
  return ast::usual(ast::real("1"));
}

Expression place_of(const Plan& plan, int joint) {
  return ast::whole(plan.places[static_cast<std::size_t>(joint)]);
}

}  // namespace

Expression target(const std::string& name) { return ast::name(name, {"Target"}, Reach::reference); }

Expression work(const std::string& name, Element number) {
  return ast::name(name, {"Work", number}, Reach::reference);
}

Expression geometry(const Expression& target, const std::string& field) {
  return ast::member(ast::member(target, "geometry"), field);
}

Expression branch(const Expression& work) {
  return ast::member(work, "branch", {"Branch", work.type.number});
}

Expression mark(const Expression& work, const std::string& name) {
  return ast::member(branch(work), name, {"bool", work.type.number});
}

Expression preferred(const LoweredPlan& plan, const Expression& target, const std::string& list, int joint) {
  const Expression all = ast::member(target, "preference", {"Preference"}, Reach::pointer);
  return ast::entry(ast::member(all, list), place_of(plan.plan, joint));
}

Expression joint_place(const Plan& plan, int joint, const std::string& row) {
  return ast::entry(ast::name(row), place_of(plan, joint));
}

Expression length_place(const Expression& work, const std::string& unknown) {
  return ast::member(work, names::length(unknown), {"real"});
}

Expression joint_value(const LoweredPlan& plan, int joint, const Expression& work) {
  const auto& value = plan.plan.joints[static_cast<std::size_t>(joint)];
  const Expression cosine = ast::member(work, value.cosine, {"real"});
  if (!value.revolute) return cosine;
  return ast::call(Kind::runtime, "output_angle",
                   {cosine, ast::member(work, value.sine), length_of(plan, value, work)});
}

ast::Statements joint_values(const LoweredPlan& plan, const derive::inverse::Step& step,
                             const Expression& work) {
  ast::Statements result;
  for (const int joint : step.joints())
    result.push_back(ast::assign(joint_place(plan.plan, joint), joint_value(plan, joint, work)));
  return result;
}

Expression step_call(const LoweredPlan& plan, std::size_t step, const Expression& target,
                     const Expression& sign, const Expression& work) {
  return ast::call(Kind::own, "solve_" + step_name(plan, step), {target, sign, work});
}

ast::Statement quartic_roots(const LoweredPlan& plan, std::size_t step) {
  const derive::inverse::Step& of = plan.plan.steps[step];
  const std::string type = of.is<derive::inverse::kind::SlideTurn>()  ? "SlideTurns"
                           : of.is<derive::inverse::kind::TwoTurns>() ? "TurnPairs"
                                                                      : "CircleRoots";
  ast::Statement result = ast::deduced(
      {type}, "roots", ast::call(Kind::own, "roots_" + step_name(plan, step), {target(), work()}));
  result.constant = true;
  return result;
}

Expression take_root(const LoweredPlan& plan, std::size_t step, const std::string& root,
                     const Expression& work) {
  const Expression roots = ast::member(ast::name("roots"), "root");
  return ast::call(Kind::own, "take_" + step_name(plan, step),
                   {target(), ast::entry(roots, ast::name(root, {"int"})), work});
}

}  // namespace qvgen::emit
