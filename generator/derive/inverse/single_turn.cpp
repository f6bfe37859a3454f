// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "derive/inverse/attempt.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/orientation.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

/// cos and sin of an angle, of any length: the quaternion's turn about the axis.
Flat twist(const symbolic::Quaternion& q, const Vector& axis, const Scope& scope) {
  const ex along = scope.clean(dot(axis, Vector{q.x, q.y, q.z}));
  return {q.w * q.w - along * along, 2 * q.w * along};
}

bool are_parallel(const std::vector<Screw>& joints, const Screw& turn, const Scope& scope) {
  return std::all_of(joints.begin(), joints.end(), [&](const Screw& joint) {
    return !joint.revolute || scope.is_zero(cross(joint.axis, turn.axis));
  });
}

/// Returns the part of the tool's turn that the other joints leave; all of them turn about parallel axes.
Flat rest_in_plane(Attempt& attempt, const std::vector<Screw>& others, const Screw& turn, Target& target) {
  Flat rest = twist(target.orientation(), turn.axis, attempt.scope);
  for (const Screw& joint : others) {
    if (!joint.revolute) continue;
    const Scope::Turn at = attempt.builder.value(joint);
    const int sense = attempt.scope.sample(dot(joint.axis, turn.axis)) > 0 ? 1 : -1;
    rest = rest * Flat{at.cosine, -sense * at.sine};
  }
  return rest;
}

/// Finds a point on the axis of joint k that the other joints place. The nearest to the arm's lines is tried
/// first. It may be where another axis crosses, about which that joint turns in vain; then one beside it
/// serves.
std::optional<Vector> placed_point(const Attempt& attempt, std::size_t k, std::string& reason) {
  const Screw& turn = attempt.chain.screws[k];
  const ex beside = GiNaC::numeric(1, 4);  // metres
  for (const Vector& point : {turn.point, turn.point + beside * turn.axis}) {
    reason = dependent_joints_about(attempt, k, point);
    if (reason.empty()) return point;
  }
  return std::nullopt;
}

}  // namespace

std::string by_single_turn(Attempt& attempt, std::size_t k) {
  const Screw turn = attempt.chain.screws[k];
  const std::string number = attempt.joints(k, 1);
  if (!turn.revolute) return "joint " + number + " does not turn";
  const std::string no_place = "the others cannot place a point on axis " + number + ": ";
  std::string reason;
  const std::optional<Vector> point = placed_point(attempt, k, reason);
  if (!point) return no_place + reason;
  Target target(attempt.builder, attempt.chain.home);
  reason = place_centre(attempt, target, k, 1, *point);
  if (!reason.empty()) return no_place + reason;
  const auto& screws = attempt.chain.screws;
  const auto middle = screws.begin() + static_cast<std::ptrdiff_t>(k);
  const std::vector<Screw> pre(screws.begin(), middle);
  const std::vector<Screw> post(middle + 1, screws.end());
  if (are_parallel(screws, turn, attempt.scope)) {
    std::vector<Screw> others = pre;
    others.insert(others.end(), post.begin(), post.end());
    attempt.builder.turn_by_pair(turn, rest_in_plane(attempt, others, turn, target),
                                 "what the other joints leave of the tool's turn");
  } else {
    const symbolic::Quaternion first = without_first(attempt.builder, pre, target.orientation());
    const symbolic::Quaternion rest = without_last(attempt.builder, post, first);
    attempt.plan.candidates = true;
    attempt.builder.turn_by_pair(turn, twist(rest, turn.axis, attempt.scope), "the rest of the orientation");
  }
  attempt.plan.structure = "the other joints place a point on the axis of " + turn.variable;
  return "";
}

}  // namespace qvgen::derive::inverse
