// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/in_plane.h"
#include "symbolic/model.h"

/// A position and a pitch, by four joints e0 e1 e2 e3. The first turns the whole arm, the others move it in
/// one plane across their common axis y, so that the tool's turn is e0 Rot(y, pitch) whatever the first joint
/// does.
///
/// The pose is taken for its position p and for its pitch: the direction of joint 0's axis, seen by the tool,
/// does not depend on that joint. With the pitch known the vector d from axis 3 to the tool point is known in
/// the plane, and e0 (e1 e2 P3 + d) = p for a point P3 of axis 3. Moving axes 1 and 2 and that point by d
/// turns this into the position of three joints. What their turns leave of the pitch is the last joint's.
namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::dot;
using symbolic::Vector;

namespace {

/// Cosine and sine of the turn about y that the pose has, of the unit circle if it is one of the arm's.
Flat pitch_of(Attempt& attempt, Target& target, const Screw& base, const Screw& last) {
  Scope& scope = attempt.scope;
  const Vector seen = scope.clean(target.direction_source(base.axis));
  attempt.builder.require_zero(scope.clean(dot(last.axis, seen - base.axis)), 1, "no tilt out of the plane");
  const Flat own = in_frame(last, base.axis, scope), now = in_frame(last, seen, scope);
  const Flat turn = own * conjugate(now);
  const ex square = scope.clean(own.x * own.x + own.y * own.y);
  return {scope.define(attempt.plan.target, "pitch_cosine", scope.clean(turn.x) / square),
          scope.define(attempt.plan.target, "pitch_sine", scope.clean(turn.y) / square)};
}

}  // namespace

std::string by_pitch(Attempt& attempt) {
  if (std::string missing = missing_plane(attempt); !missing.empty()) return missing;
  if (std::string dependent = dependent_joints_of_pitch(attempt); !dependent.empty()) return dependent;
  Scope& scope = attempt.scope;
  const auto& screws = attempt.chain.screws;
  const Screw& last = screws[3];
  Target target(attempt.builder, attempt.chain.home);
  const Flat pitch = pitch_of(attempt, target, screws[0], last);
  const Vector reach = scope.clean(attempt.chain.home.p - last.point);
  const Flat turned = pitch * in_frame(last, reach, scope);
  const Vector beyond =
      scope.define(attempt.plan.target, "beyond",
                   dot(last.axis, reach) * last.axis + turned.x * last.first + turned.y * last.second);
  if (std::string reason = place_in_plane(attempt, pitch, beyond, target.pose().p); !reason.empty())
    return reason;
  attempt.plan.structure = "joints " + attempt.joints(1, 3) +
                           " move in one plane: the pitch tells where the axis of " + last.variable +
                           " is, the others place it";
  return "";
}

}  // namespace qvgen::derive::inverse
