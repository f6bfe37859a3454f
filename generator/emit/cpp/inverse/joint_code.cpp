// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/joint_code.h"

#include "derive/inverse/names.h"
#include "emit/cpp/inverse/step_code.h"

namespace qvgen::emit {

namespace names = derive::inverse::names;

using derive::inverse::LoweredPlan;
namespace {

/// How long the pair is that a joint's angle is taken of, unless it is 1.
std::string length_argument(const LoweredPlan& plan, const derive::inverse::JointValue& value,
                            const std::string& work, const Dialect& d) {
  for (const derive::inverse::Step& step : plan.plan.steps)
    if (step.keeps_length() && value.cosine == names::cosine(step.unknown))
      return d.member(work, names::length(step.unknown));
  return {};
}

}  // namespace

std::string joint_place(const derive::inverse::Plan& plan, int joint) {
  return "q[" + std::to_string(plan.places[static_cast<std::size_t>(joint)]) + "]";
}

std::vector<std::string> joint_lines(const LoweredPlan& plan, const derive::inverse::Step& step,
                                     const std::string& work, const Dialect& d) {
  std::vector<std::string> lines;
  const auto add = [&](int joint) {
    const auto& value = plan.plan.joints[static_cast<std::size_t>(joint)];
    const std::string cosine = d.member(work, value.cosine);
    const std::string angle = value.revolute ? d.output_angle(cosine, d.member(work, value.sine),
                                                              length_argument(plan, value, work, d))
                                             : cosine;
    lines.push_back(joint_place(plan.plan, joint) + " = " + angle + ";");
  };
  for (const int joint : step.joints()) add(joint);
  return lines;
}

std::string quartic_roots(const LoweredPlan& plan, std::size_t index, const Dialect& d) {
  const bool slides = plan.plan.steps[index].is<derive::inverse::kind::SlideTurn>();
  return d.constant(slides ? "SlideTurns" : "CircleRoots", "roots",
                    d.function("roots_" + step_name(plan, index)) + "(t, w)");
}

std::string take_root(const LoweredPlan& plan, std::size_t index, const std::string& root,
                      const std::string& work, const Dialect& d) {
  return d.function("take_" + step_name(plan, index)) + "(t, " + d.entry("roots.root", root) + ", " + work +
         ");";
}

std::string step_call(const LoweredPlan& plan, std::size_t index, const std::string& sign,
                      const std::string& work, const std::string& target, const Dialect& d) {
  return d.function("solve_" + step_name(plan, index)) + "(" + target + ", " + sign +
         (sign.empty() ? "" : ", ") + work + ")";
}

}  // namespace qvgen::emit
