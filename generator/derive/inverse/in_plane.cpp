// SPDX-License-Identifier: MIT
#include "derive/inverse/in_plane.h"

#include "derive/inverse/position.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

Screw moved(const Screw& screw, const Vector& by) {
  Screw result = screw;
  result.point = screw.point + by;
  return result;
}

}  // namespace

std::string missing_plane(const Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  const Scope& scope = attempt.scope;
  const Screw& last = screws[3];
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
  return "";
}

std::string place_in_plane(Attempt& attempt, const Flat& sum, const Vector& beyond, const Vector& goal) {
  const Scope& scope = attempt.scope;
  const auto& screws = attempt.chain.screws;
  const Screw& last = screws[3];
  const std::string reason = solve_position(attempt.builder, screws[0], moved(screws[1], beyond),
                                            moved(screws[2], beyond), last.point + beyond, goal);
  if (!reason.empty())
    return "three joints place a point on the axis of " + last.variable + ", but: " + reason;
  Flat rest = sum;
  for (const Screw& screw : {screws[1], screws[2]}) {
    if (!screw.revolute) continue;
    const Scope::Turn at = attempt.builder.value(screw);
    const int sense = scope.sample(dot(screw.axis, last.axis)) > 0 ? 1 : -1;
    rest = rest * Flat{at.cosine, -sense * at.sine};
  }
  attempt.builder.turn_by_pair(last, rest, "what the other joints leave of their sum");
  return "";
}

}  // namespace qvgen::derive::inverse
