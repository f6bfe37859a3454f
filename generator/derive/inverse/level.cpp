// SPDX-License-Identifier: MIT
#include "derive/inverse/level.h"

#include <cmath>

#include "derive/inverse/freedom.h"
#include "derive/inverse/in_plane.h"
#include "exact/constant_angle.h"
#include "symbolic/model.h"

/// A position and a yaw, by five joints e0 e1 e2 e3 e4. The first turns the whole arm about z, the next three
/// move it in one plane across their common axis y, the last turns the tool about z again, as long as the sum
/// of the turns about y is what it is with all joints of the described arm at zero: the tool stays level.
///
/// A point X of the last axis is where the pose has it. The vector d from axis 3 to X is constant in the
/// plane, so that the others place X (in_plane.h). What e0 leaves of the tool's turn about z is e4's. No step
/// looks for the direction of the last axis: it is that of the first one, where such a step would be
/// singular.
namespace qvgen::derive::inverse {

using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

int sense_of(const Vector& axis, const Vector& other, const Scope& scope) {
  return scope.sample(dot(axis, other)) > 0 ? 1 : -1;
}

/// The sum of the turns with all joints of the described arm at zero, rad, in the sense of the last.
double level_sum(const Attempt& attempt) {
  const std::vector<exact::Angle>& phases = attempt.problem.phases;
  double sum = 0;
  for (const auto& [place, sense] : balance_of(attempt).turns)
    if (const auto at = static_cast<std::size_t>(place); at < phases.size())
      sum += sense * cln::double_approx(*exact::radians(phases[at]));
  return sum;
}

/// Cosine and sine of that sum, which brings the last axis along the first one, in its sense or the other.
Flat level_turn(const Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  const Scope& scope = attempt.scope;
  const Flat from = in_frame(screws[3], screws[4].axis, scope),
             to = in_frame(screws[3], screws[0].axis, scope);
  const Flat turn = to * conjugate(from);
  const GiNaC::ex square = scope.clean(from.x * from.x + from.y * from.y);
  const Flat unit{scope.clean(turn.x) / square, scope.clean(turn.y) / square};
  const double sum = level_sum(attempt);
  const bool is_opposite = scope.sample(unit.x) * std::cos(sum) + scope.sample(unit.y) * std::sin(sum) < 0;
  return is_opposite ? Flat{-unit.x, -unit.y} : unit;
}

Vector turned(const Screw& screw, const Flat& turn, const Vector& v, const Scope& scope) {
  const Flat now = turn * in_frame(screw, v, scope);
  return scope.clean(dot(screw.axis, v) * screw.axis + scope.clean(now.x) * screw.first +
                     scope.clean(now.y) * screw.second);
}

bool has_numeric_phases(const Problem& problem) {
  for (const exact::Angle& phase : problem.phases)
    if (!exact::radians(phase)) return false;
  return true;
}

/// True if the last axis has the direction of the first one with all joints of the described arm at zero.
bool is_level_at_zero(const Attempt& attempt, const Flat& level) {
  const auto& screws = attempt.chain.screws;
  const Scope& scope = attempt.scope;
  const double sum = level_sum(attempt);
  return std::abs(scope.sample(level.x) - std::cos(sum)) < 1e-9 &&
         std::abs(scope.sample(level.y) - std::sin(sum)) < 1e-9 &&
         scope.is_zero(cross(turned(screws[3], level, screws[4].axis, scope), screws[0].axis));
}

/// Why five joints do not keep the tool level; empty if they do.
std::string missing_level(const Attempt& attempt) {
  if (std::string missing = missing_plane(attempt); !missing.empty()) return missing;
  const auto& screws = attempt.chain.screws;
  if (!screws[4].revolute || !has_numeric_phases(attempt.problem))
    return "the last of the five joints that are solved for has to turn";
  if (attempt.scope.is_zero(cross(screws[3].axis, screws[4].axis)) ||
      !is_level_at_zero(attempt, level_turn(attempt)))
    return "with all joints at zero the last one does not turn about the direction of the first";
  return dependent_joints_of_level(attempt);
}

/// Turns the last joint by what joint 0 leaves of the tool's turn.
void turn_last(Attempt& attempt, const Target& target, const Flat& level) {
  const auto& screws = attempt.chain.screws;
  const Scope& scope = attempt.scope;
  const Screw &first = screws[0], &last = screws[4];
  // A vector that is across the first axis when the tool is level: both turns carry it about that axis.
  const Vector carried = target.direction_image(turned(screws[3], conjugate(level), first.first, scope));
  const Flat turn = in_frame(first, carried, scope);
  const Scope::Turn at = attempt.builder.value(first);
  const Flat rest = turn * Flat{at.cosine, -at.sine};
  const Vector axis = turned(screws[3], level, last.axis, scope);
  attempt.builder.turn_by_pair(last, {rest.x, sense_of(axis, first.axis, scope) * rest.y},
                               "what " + first.variable + " leaves of the tool's turn");
}

}  // namespace

Balance balance_of(const Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  Balance balance;
  for (std::size_t i = 1; i < 4; ++i)
    if (screws[i].revolute)
      balance.turns.emplace_back(attempt.problem.places[i],
                                 sense_of(screws[i].axis, screws[3].axis, attempt.scope));
  return balance;
}

std::string by_level(Attempt& attempt) {
  if (std::string missing = missing_level(attempt); !missing.empty()) return missing;
  Scope& scope = attempt.scope;
  const auto& screws = attempt.chain.screws;
  Target target(attempt.builder, attempt.chain.home);
  const Flat level = level_turn(attempt);
  const Vector beyond = turned(screws[3], level, screws[4].point - screws[3].point, scope);
  const Vector goal = scope.define(attempt.plan.target, "goal", scope.clean(target.image(screws[4].point)));
  if (std::string reason = place_in_plane(attempt, level, beyond, goal); !reason.empty()) return reason;
  turn_last(attempt, target, level);
  attempt.plan.structure =
      "joints " + attempt.joints(1, 3) +
      " move in one plane and keep the tool level: the others place a point on the axis of " +
      screws[4].variable;
  return "";
}

}  // namespace qvgen::derive::inverse
