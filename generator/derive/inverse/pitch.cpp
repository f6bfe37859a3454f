// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/position.h"
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
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

/// Why the joints do not have the structure.
std::string missing_structure(const Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  const Scope& scope = attempt.scope;
  const Screw& last = screws.back();
  if (!screws.front().revolute || !last.revolute)
    return "of the four joints that are solved for, the first and the last have to turn";
  for (std::size_t i = 1; i < 3; ++i) {
    const Screw& screw = screws[i];
    const bool is_in_plane = screw.revolute ? scope.is_zero(cross(screw.axis, last.axis))
                                            : scope.is_zero(dot(screw.axis, last.axis));
    if (!is_in_plane) return "joints " + attempt.joints(1, 3) + " do not move in one plane";
  }
  if (scope.is_zero(cross(screws.front().axis, last.axis)))
    return "all axes are parallel: a position and a yaw may be asked for";
  return dependent_joints_of_pitch(attempt);
}

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

Screw moved(const Screw& screw, const Vector& by) {
  Screw result = screw;
  result.point = screw.point + by;
  return result;
}

}  // namespace

std::string by_pitch(Attempt& attempt) {
  if (std::string missing = missing_structure(attempt); !missing.empty()) return missing;
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
  const std::string reason = solve_position(attempt.builder, screws[0], moved(screws[1], beyond),
                                            moved(screws[2], beyond), last.point + beyond, target.pose().p);
  if (!reason.empty())
    return "three joints place a point on the axis of " + last.variable + ", but: " + reason;
  Flat rest = pitch;
  for (const Screw& screw : {screws[1], screws[2]}) {
    if (!screw.revolute) continue;
    const Scope::Turn at = attempt.builder.value(screw);
    const int sense = scope.sample(dot(screw.axis, last.axis)) > 0 ? 1 : -1;
    rest = rest * Flat{at.cosine, -sense * at.sine};
  }
  attempt.builder.turn_by_pair(last, rest, "what the other joints leave of the pitch");
  attempt.plan.structure = "joints " + attempt.joints(1, 3) +
                           " move in one plane: the pitch tells where the axis of " + last.variable +
                           " is, the others place it";
  return "";
}

}  // namespace qvgen::derive::inverse
