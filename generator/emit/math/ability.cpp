// SPDX-License-Identifier: MIT
#include "emit/math/ability.h"

#include <fmt/format.h>

#include "canonical/arm.h"
#include "derive/inverse/spherical_arm.h"
#include "model/private_names.h"
#include "model/tasks.h"

namespace qvgen::emit {

using derive::inverse::Derivation;
using derive::inverse::Filter;
using derive::inverse::Problem;
using model::Task;

namespace {

std::string asked(const Problem& problem) {
  switch (problem.task) {
    case Task::pose:
      return problem.filter == Filter::none ? "position and orientation" : "the poses that it can take";
    case Task::position:
      return "a position of the tool point";
    case Task::position_and_direction:
      return "a position of the tool point and the direction of the tool's axis " +
             model::axis_text(problem.tool_axis);
    case Task::position_and_yaw:
      return "a position of the tool point and a turn about the direction that its axes share";
    case Task::position_and_pitch:
      return "a position of the tool point and the pitch of the tool's axis " +
             model::axis_text(problem.tool_axis);
    case Task::position_and_inclination:
      return "a position of the tool point and the direction of the first axis as the tool sees it";
    case Task::direction:
      return "the direction of the tool's axis " + model::axis_text(problem.tool_axis);
    case Task::orientation:
      return "an orientation of the tool";
  }
  return {};
}

/// Names the joints that the derivation has put behind the arm's own.
std::string virtual_joints(const Problem& problem) {
  std::string text;
  const auto& joints = problem.moving.joints;
  for (std::size_t i = static_cast<std::size_t>(problem.own_joints); i < joints.size(); ++i)
    text +=
        fmt::format(" Below, {} is {}.", joints[i].variable,
                    joints[i].type != model::JointType::revolute ? "a slide of the tool, which ends at zero"
                    : problem.has_heading()                      ? "the heading, which is left open"
                                                                 : "the turn of the tool that is left open");
  return text;
}

std::string ability(const model::Robot& described, const Problem& problem, const std::string& structure,
                    int capacity, const std::string& how) {
  const std::size_t own = described.joints.size();
  std::string text = fmt::format("{} {}, asked for {}", own, own == 1 ? "joint" : "joints", asked(problem));
  if (problem.given >= 0)
    text += fmt::format(" with {} given by the caller",
                        described.joints[static_cast<std::size_t>(problem.given)].variable);
  text += fmt::format(": {}. At most {} {}{}.", structure, capacity, capacity == 1 ? "solution" : "solutions",
                      how);
  if (problem.task == Task::position_and_pitch)
    text +=
        " A pose may be given too, for its position and pitch; one that is tilted to the side is "
        "unreachable.";
  else if (problem.task == Task::position_and_inclination)
    text += " A pose may be given too; its heading, the turn about the first axis, is not used.";
  else if (problem.task != Task::pose && problem.task != Task::position)
    text += " A whole pose may be asked for too; it is unreachable unless the arm can take it.";
  return text + virtual_joints(problem);
}

/// Returns the most solutions of an elimination: with two slides its polynomial has half the degree.
int most_solutions(const derive::inverse::EliminationDerivation& derivation) {
  namespace elimination = qvgen::inverse::elimination;
  const bool slides = derivation.setup.eliminations[0].pair == elimination::Pair::slides;
  return slides ? elimination::most_solutions / 2 : elimination::most_solutions;
}

}  // namespace

std::string ability(const model::Robot& described, const Derivation& derivation) {
  return ability(described, derivation.problem, derivation.plan.structure, derivation.plan.capacity,
                 derivation.plan.quartic() ? ", by a quartic" : "");
}

std::string ability(const model::Robot& described, const derive::inverse::EliminationDerivation& derivation) {
  const std::string near = described.ideal.empty() ? ""
                                                   : " Next to a seed also from the closed form of " +
                                                         described.ideal + ", not complete (from_ideal.h).";
  return ability(described, derivation.problem, "no structure that a closed form needs",
                 most_solutions(derivation), ", by elimination") +
         near;
}

std::string arm_angle_ability(const model::Robot& described) {
  if (!derive::inverse::has_seven_turns(described)) return "";
  const auto arm =
      derive::inverse::spherical_arm(canonical::for_dynamics(model::with_private_names(described)));
  if (!arm.found) return "Not by an arm angle: " + arm.reason + ".";
  return "By the arm angle too (arm_angle.h), the elbow's turn about the line from the shoulder, where "
         "the axes of joints 1, 2 and 3 meet, to the wrist, where those of joints 5, 6 and 7 do: at most 8 "
         "solutions of a pose and an arm angle, the arm angles that joint limits leave, and a solution "
         "within limits wherever there is one.";
}

}  // namespace qvgen::emit
