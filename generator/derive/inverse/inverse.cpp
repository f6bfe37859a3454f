// SPDX-License-Identifier: MIT
#include "derive/inverse/inverse.h"

#include <algorithm>
#include <functional>

#include "derive/inverse/attempt.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/lengths.h"
#include "derive/inverse/range_test.h"
#include "derive/inverse/results.h"
#include "derive/inverse/schedule.h"
#include "derive/inverse/target.h"

namespace qvgen::derive::inverse {

namespace {

using Method = std::function<std::string(Attempt&)>;

/// Takes the first method that succeeds; the reasons of the others are kept only if none does.
Derivation first_of(const model::Robot& robot, const std::vector<Method>& methods) {
  Derivation derivation;
  for (const Method& method : methods) {
    Attempt attempt(robot);
    const std::string reason = method(attempt);
    if (!reason.empty()) {
      derivation.reasons.push_back(reason);
      continue;
    }
    schedule(attempt.plan);
    spare_lengths(attempt.plan, attempt.scope);
    read_results(attempt.plan, attempt.scope);
    attempt.plan.range_test = range_test(attempt.plan, attempt.scope);
    if (attempt.plan.quartic()) read_unit_quaternion(attempt.plan.target);
    prune(attempt.plan);
    for (const Step& step : attempt.plan.steps) attempt.plan.capacity *= step.branches;
    derivation.plan = std::move(attempt.plan);
    derivation.found = true;
    derivation.reasons.clear();
    return derivation;
  }
  return derivation;
}

}  // namespace

Derivation derive(const model::Robot& robot) {
  std::vector<Method> methods;
  const std::size_t count = robot.joints.size();
  if (count == 6) {
    const std::string reason = dependent_joints(Attempt(robot), {0, 1, 2, 3, 4, 5}, false);
    if (!reason.empty()) return {false, {}, {reason}};
    for (const std::size_t k : {3U, 0U, 2U, 1U})
      methods.push_back([k](Attempt& a) { return by_common_point(a, k); });
    for (const std::size_t k : {1U, 2U, 0U, 3U})
      methods.push_back([k](Attempt& a) { return by_parallel_axes(a, k); });
  } else if (count == 3) {
    methods.push_back([](Attempt& a) { return in_plane(a, false); });
    methods.push_back(by_position);
  } else if (count == 2) {
    methods.push_back([](Attempt& a) { return in_plane(a, false); });
  }
  Derivation derivation = first_of(robot, methods);
  if (methods.empty())
    derivation.reasons.push_back(std::to_string(count) + " joints: a pose in space fixes six, a point three");
  return derivation;
}

Derivation derive_locked(const model::Robot& robot) {
  if (robot.joints.size() == 3) return first_of(robot, {[](Attempt& a) { return in_plane(a, true); }});
  if (robot.joints.size() != 7) return {};
  std::vector<Method> methods;
  for (const int locked : {2, 1, 0, 3})
    methods.push_back([locked](Attempt& a) { return by_common_point(a, 4, locked); });
  return first_of(robot, methods);
}

namespace {

bool has_oblique_wrist(const Derivation& derivation) {
  const auto& steps = derivation.plan.steps;
  return derivation.found && std::any_of(steps.begin(), steps.end(),
                                         [](const Step& step) { return step.kind == Kind::oblique_wrist; });
}

}  // namespace

canonical::Arm arm_to_solve(const model::Robot& described) {
  canonical::Arm arm = canonical::for_kinematics(described);
  if (!has_oblique_wrist(derive(arm.robot)) && !has_oblique_wrist(derive_locked(arm.robot))) return arm;
  canonical::Arm other = canonical::along_normals(described);
  const Derivation whole = derive(other.robot);
  const Derivation locked = derive_locked(other.robot);
  const bool better =
      (whole.found || locked.found) && !has_oblique_wrist(whole) && !has_oblique_wrist(locked);
  return better ? other : arm;
}

}  // namespace qvgen::derive::inverse
