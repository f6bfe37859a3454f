// SPDX-License-Identifier: MIT
#include "derive/inverse/inverse.h"

#include <algorithm>
#include <functional>

#include "derive/inverse/attempt.h"
#include "derive/inverse/exchange.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/lengths.h"
#include "derive/inverse/level.h"
#include "derive/inverse/range_test.h"
#include "derive/inverse/results.h"
#include "derive/inverse/schedule.h"
#include "derive/inverse/size.h"
#include "derive/inverse/target.h"

namespace qvgen::derive::inverse {

namespace {

using Method = std::function<std::string(Attempt&)>;

/// Takes the first method that succeeds; the reasons of the others are kept only if none does.
Derivation first_of(const Problem& problem, const std::vector<Method>& methods) {
  Derivation derivation;
  derivation.problem = problem;
  for (const Method& method : methods) {
    Attempt attempt(problem);
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
    derivation.plan.places = problem.places;
    derivation.plan.row_size = problem.row_size;
    derivation.plan.given = problem.given;
    derivation.found = true;
    derivation.reasons.clear();
    return derivation;
  }
  return derivation;
}

/// With the joints in the order that the problem has them in.
Derivation derive_pose_in_order(const Problem& problem) {
  std::vector<Method> methods;
  const std::size_t count = problem.robot.joints.size();
  if (count == 6) {
    for (const std::size_t k : {3U, 0U, 2U, 1U})
      methods.push_back([k](Attempt& a) { return by_common_point(a, k); });
    for (const std::size_t k : {1U, 2U, 0U, 3U})
      methods.push_back([k](Attempt& a) { return by_parallel_axes(a, k); });
    methods.emplace_back(by_three_slides);
  } else if (count == 4) {
    for (const std::size_t k : {1U, 0U}) methods.push_back([k](Attempt& a) { return by_common_point(a, k); });
    for (const std::size_t k : {3U, 0U, 2U, 1U})
      methods.push_back([k](Attempt& a) { return by_single_turn(a, k); });
    methods.emplace_back(by_two_slides);
  } else if (count == 3) {
    methods.emplace_back(in_plane);
  }
  return first_of(problem, methods);
}

/// Says that joints have another order in the plan; equations between an arm's own pairs are not among its
/// steps then.
void tell_order(Derivation& derivation) {
  std::string order;
  for (const model::Joint& joint : derivation.problem.robot.joints)
    order += (order.empty() ? "" : ", ") + joint.variable;
  derivation.plan.structure += "; a turn and a slide along its axis commute: in the order " + order;
  for (Step& step : derivation.plan.steps) step.elements = {};
}

}  // namespace

Derivation derive_pose(const Problem& problem) {
  if (problem.robot.joints.size() == 6) {
    const std::string reason = dependent_joints(Attempt(problem), {0, 1, 2, 3, 4, 5}, false);
    if (!reason.empty()) return {false, problem, {}, {reason}};
  }
  const Derivation in_order = derive_pose_in_order(problem);
  if (in_order.found) return in_order;
  for (const Problem& other : in_other_orders(problem)) {
    Derivation derivation = derive_pose_in_order(other);
    if (!derivation.found) continue;
    tell_order(derivation);
    return derivation;
  }
  return in_order;
}

Derivation derive_position(const Problem& problem) {
  if (problem.robot.joints.size() == 2) return first_of(problem, {in_plane});
  return first_of(problem, {by_position});
}

Derivation derive_orientation(const Problem& problem) { return first_of(problem, {by_orientation}); }

Derivation derive_pitch(const Problem& problem) { return first_of(problem, {by_pitch}); }

Derivation derive_inclination(const Problem& problem) { return first_of(problem, {by_inclination}); }

Derivation derive_level(const Problem& problem) {
  Derivation derivation = first_of(problem, {by_level});
  if (derivation.found) derivation.problem.balance = balance_of(Attempt(problem));
  return derivation;
}

Derivation in_canonical_frames(const Problem& problem,
                               const std::function<Derivation(const Problem&)>& derived) {
  Derivation derivation = derived(of_canonical_arm(problem, canonical::for_kinematics(problem.robot)));
  if (!derivation.plan.has_oblique_wrist()) return derivation;
  Derivation other = derived(of_canonical_arm(problem, canonical::along_normals(problem.robot)));
  // Frames of their own may also make directions long that were short.
  const bool is_short = other.found && nodes(other.plan) <= 2 * nodes(derivation.plan);
  return is_short && !other.plan.has_oblique_wrist() ? other : derivation;
}

}  // namespace qvgen::derive::inverse
