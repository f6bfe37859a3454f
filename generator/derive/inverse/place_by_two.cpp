// SPDX-License-Identifier: MIT
// Two joints that bring a point to its goal, e_a e_b start = goal: they carry it on a surface, and the goal
// lies on it. Joint b keeps what is along n: its own axis if it turns; if it slides, across its axis and
// that of a. So n·(e_a^-1 goal) = n·start holds joint a alone, and b follows.
#include "derive/inverse/attempt.h"
#include "derive/inverse/block.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

constexpr const char* equation = "two joints bring the point to its place";

/// True if a turn moves the point, which is not on its axis.
bool moves(const Screw& turn, const Vector& point, const Scope& scope) {
  const Flat arm = in_frame(turn, scope.clean(point - turn.point), scope);
  return !scope.is_zero(arm.x) || !scope.is_zero(arm.y);
}

std::string by_two_slides_alone(Attempt& attempt, const Screw& a, const Screw& b, const Vector& rest) {
  const Scope& scope = attempt.scope;
  const Vector n = scope.clean(cross(a.axis, b.axis));
  const ex square = scope.clean(dot(n, n));
  if (scope.is_zero(square)) return "two parallel prismatic joints";
  attempt.builder.slide_by_value(a, scope.clean(dot(rest, cross(b.axis, n))) / square, equation);
  attempt.builder.slide_by_value(b, scope.clean(dot(rest, cross(n, a.axis))) / square, equation);
  return "";
}

/// Turns joint a about the direction of joint b.
std::string about_one_direction(Attempt& attempt, const Screw& a, const Screw& b, const Vector& start,
                                const Vector& goal) {
  const Scope& scope = attempt.scope;
  if (!moves(b.revolute ? b : a, start, scope) || (b.revolute && !moves(a, b.point, scope)))
    return "the axes of " + a.variable + " and " + b.variable + " lie along each other or go through it";
  if (b.revolute) {
    two_link(attempt, a, b, start, goal);
    return "";
  }
  const Flat from = in_frame(a, scope.clean(start - a.point), scope);
  attempt.builder.turn_by_pair(a, in_frame(a, scope.clean(goal - a.point), scope) * conjugate(from),
                               equation);
  attempt.builder.slide_by_value(b, scope.clean(dot(b.axis, goal - start)), equation);
  return "";
}

}  // namespace

std::string place_by_two(Attempt& attempt, const Screw& a, const Screw& b, const Vector& start,
                         const Vector& goal) {
  const Scope& scope = attempt.scope;
  Builder& builder = attempt.builder;
  if (!a.revolute && !b.revolute) return by_two_slides_alone(attempt, a, b, goal - start);
  if (!a.revolute) return place_by_two(attempt, reversed(b), reversed(a), goal, start);
  if (scope.is_zero(cross(a.axis, b.axis))) return about_one_direction(attempt, a, b, start, goal);
  if (b.revolute && !moves(b, start, scope)) return "the axis of " + b.variable + " goes through it too";
  const Block brought = block_of(a, -1, goal, scope);
  const Vector n = b.revolute ? b.axis : scope.clean(cross(a.axis, b.axis));
  const Block::Form form = brought.form(n, scope);
  builder.turn_by_line(a, form.coefficients, scope.clean(dot(n, start) - form.constant),
                       "along a direction that " + b.variable + " does not change");
  const auto left = [&](const Vector& along, const Vector& from) {
    return brought.at_value(along, builder) - scope.clean(dot(along, from));
  };
  if (!b.revolute) {
    builder.slide_by_value(b, left(b.axis, start), equation);
    return "";
  }
  const Flat to{builder.keep("reach_" + b.variable + "_x", left(b.first, b.point)),
                builder.keep("reach_" + b.variable + "_y", left(b.second, b.point))};
  const Flat from = in_frame(b, scope.clean(start - b.point), scope);
  builder.turn_by_pair(b, to * conjugate(from), equation);
  return "";
}

}  // namespace qvgen::derive::inverse
