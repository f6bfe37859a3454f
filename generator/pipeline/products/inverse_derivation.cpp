// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_derivation.h"

#include <algorithm>

#include "derive/inverse/freedom.h"
#include "model/followers.h"
#include "model/merged_joints.h"
#include "model/private_names.h"
#include "pipeline/products/brief_reasons.h"
#include "pipeline/products/inverse_motors.h"

namespace qvgen::pipeline {
namespace {

/// True if some of six joints that shall reach a pose can always move without moving the tool: then no solver
/// can serve.
bool is_singular_everywhere(const model::Robot& robot) {
  using namespace derive::inverse;
  const model::InverseRequest& request = robot.inverse;
  if (robot.joints.size() != 6 || request.task.value_or(model::Task::pose) != model::Task::pose) return false;
  const Problem problem = problem_of(robot, model::Task::pose);
  return !dependent_joints(Attempt(problem), {0, 1, 2, 3, 4, 5}, false).empty();
}

/// Returns false if nothing else can serve either, which the reasons say then.
bool add_closed_forms(const model::Robot& described, InverseDerivation& result) {
  const model::Robot robot = model::with_private_names(described);
  std::vector<derive::inverse::Derivation> all{derive::inverse::derive(robot)};
  for (auto& derivation : derive::inverse::derive_given(robot)) all.push_back(std::move(derivation));
  for (const auto& derivation : all) {
    if (derivation.found) result.closed_forms.push_back(derivation);
    result.reasons.insert(result.reasons.end(), derivation.reasons.begin(), derivation.reasons.end());
  }
  return result.found() || !is_singular_everywhere(robot);
}

void add_eliminations(const model::Robot& described, InverseDerivation& result) {
  derive::inverse::EliminationDerivations derivations = derive::inverse::derive_eliminations(described);
  result.eliminations = std::move(derivations.found);
  result.reasons.insert(result.reasons.end(), derivations.reasons.begin(), derivations.reasons.end());
}

/// True if a closed form is a quartic of an arm with axes that nearly meet. Its equations are nearly those of
/// a simpler arm, and its roots carry so few digits that solutions take twenty times as long as by
/// elimination; the smallest offsets lose some.
bool has_faint_quartic(const model::Robot& described, const InverseDerivation& derivation) {
  const auto is_quartic = [](const derive::inverse::Derivation& form) { return form.plan.quartic(); };
  return std::any_of(derivation.closed_forms.begin(), derivation.closed_forms.end(), is_quartic) &&
         derive::inverse::nearly_has_structure(described);
}

/// Puts eliminations in place of closed forms, if there are any.
void replace_by_eliminations(const model::Robot& described, InverseDerivation& derivation) {
  derive::inverse::EliminationDerivations derivations = derive::inverse::derive_eliminations(described);
  if (derivations.found.empty()) return;
  derivation.closed_forms.clear();
  derivation.reasons.clear();
  derivation.eliminations = std::move(derivations.found);
}

/// Leaves out forms with a given joint that is no motor: the caller has no value for it.
template <class Form>
void leave_out_coupled(const model::Robot& robot, std::vector<Form>& forms,
                       std::vector<std::string>& reasons) {
  const auto is_coupled = [&](const Form& form) {
    const int given = form.problem.given;
    return given >= 0 && !robot.joints[static_cast<std::size_t>(given)].follows.empty();
  };
  for (const Form& form : forms)
    if (is_coupled(form))
      reasons.push_back("with " + robot.joints[static_cast<std::size_t>(form.problem.given)].variable +
                        " given: it follows motors, none of which is given then");
  std::erase_if(forms, is_coupled);
}

/// Adds the closed form of an arm one of whose joints keeps its tool level.
void add_level_form(const model::Robot& coupled, InverseDerivation& result) {
  model::Robot robot = model::with_private_names(result.arm);
  const auto asked = robot.inverse.task;
  robot.inverse.task = model::Task::position_and_yaw;
  derive::inverse::Derivation derivation = derive::inverse::derive(robot);
  const bool may_be_asked = !asked || *asked == model::Task::pose || *asked == model::Task::position_and_yaw;
  if (derivation.found && may_be_asked && keeps_balance(coupled, derivation.problem.balance)) {
    if (asked == model::Task::pose) derive::inverse::ask_for_poses(derivation.problem);
    result.closed_forms.push_back(std::move(derivation));
    return;
  }
  result.reasons = {
      "4 motors move 5 joints: three of these, behind the first, would have to keep the tool level by "
      "the sum of their turns, and the task to be a position and a yaw, or a pose"};
}

InverseDerivation derive_without_outer_joints(const model::Robot& robot) {
  InverseDerivation result;
  result.coupled = model::with_merged_joints(robot);
  const model::Robot described = result.arm = model::in_joints(result.coupled);
  if (const std::string reason = obstacle_of_motors(result.coupled); !reason.empty()) {
    result.reasons = {reason};
    return result;
  }
  if (has_a_joint_over(result.coupled)) {
    add_level_form(result.coupled, result);
    return result;
  }
  const bool has_no_structure = derive::inverse::lacks_structure(described);
  if (has_no_structure) add_eliminations(described, result);
  const bool may_have_others = result.found() || add_closed_forms(described, result);
  if (!result.found() && !has_no_structure && may_have_others) add_eliminations(described, result);
  if (has_faint_quartic(described, result)) replace_by_eliminations(described, result);
  leave_out_coupled(result.coupled, result.closed_forms, result.reasons);
  leave_out_coupled(result.coupled, result.eliminations, result.reasons);
  result.reasons = brief_reasons(result.reasons, described.joints.size());
  return result;
}

/// The first way to give several joints that leads to something.
InverseDerivation derive_with_outer_joints(const model::Robot& robot) {
  InverseDerivation result;
  result.reasons = {reason_against_giving(robot)};
  if (model::has_followers(robot)) return result;
  for (const OuterJoints& way : ways_to_give(robot)) {
    result = derive_without_outer_joints(way.inner);
    result.coupled = robot;
    result.outer = way;
    if (result.found()) break;
  }
  return result;
}

}  // namespace

InverseDerivation derive_inverse(const model::Robot& robot) {
  return gives_several(robot) ? derive_with_outer_joints(robot) : derive_without_outer_joints(robot);
}

}  // namespace qvgen::pipeline
