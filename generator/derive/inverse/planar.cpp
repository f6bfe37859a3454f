// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

ex square_of(const ex& value) { return GiNaC::pow(value, 2); }

/// The pose has to keep the height along the axes, up to noise.
void require_height(Attempt& attempt, const Vector& axis, const Vector& start, const Vector& goal) {
  attempt.builder.require_zero(attempt.scope.clean(dot(axis, goal - start)),
                               GiNaC::sqrt(symbolic::symbol(names::size_square)),
                               "the height along the axes");
}

/// Why two links cannot place a point that is `start` at zero: one of them has no length.
std::string missing_link(const Scope& scope, const Screw& a, const Screw& b, const Vector& start) {
  const auto has_no_length = [&](const Flat& link) { return scope.is_zero(link.x) && scope.is_zero(link.y); };
  if (has_no_length(in_frame(b, b.point - a.point, scope)))
    return "the axes of " + a.variable + " and " + b.variable + " coincide";
  if (has_no_length(in_frame(b, start - b.point, scope)))
    return "the point to be placed lies on the axis of " + b.variable;
  return "";
}

void place_by_two_links(Attempt& attempt, const Screw& a, const Screw& b, const Vector& start,
                        const Vector& goal) {
  two_link(attempt, a, b, start, goal);
  attempt.builder.polish({a, b}, {start}, {goal});
}

}  // namespace

Flat in_frame(const Screw& screw, const Vector& v, const Scope& scope) {
  return {scope.clean(dot(screw.first, v)), scope.clean(dot(screw.second, v))};
}

void two_link(Attempt& attempt, const Screw& a, const Screw& b, const Vector& start, const Vector& goal) {
  const Scope& scope = attempt.scope;
  Builder& builder = attempt.builder;
  const Flat g = in_frame(a, goal - a.point, scope);
  const Flat plane_g{builder.keep("reach_" + a.variable + "_x", g.x),
                     builder.keep("reach_" + a.variable + "_y", g.y)};
  const ex square = builder.keep("square_" + b.variable, square_of(plane_g.x) + square_of(plane_g.y));
  const Flat v = in_frame(b, b.point - a.point, scope);
  const Flat x0 = in_frame(b, start - b.point, scope);
  builder.turn_by_distance(b, 1, v, x0, square, "distance from the axis of " + a.variable + ": the same");
  const Scope::Turn turn = builder.value(b);
  const Flat x{turn.cosine * x0.x - turn.sine * x0.y, turn.sine * x0.x + turn.cosine * x0.y};
  // The second link's end in the first joint's frame.
  const Vector end = (v.x + x.x) * b.first + (v.y + x.y) * b.second;
  const Flat f = in_frame(a, end, scope);
  builder.turn_by_pair(a, plane_g * conjugate(f), "the turn about the axis of " + a.variable);
}

std::string in_plane(Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  const Scope& scope = attempt.scope;
  for (const Screw& screw : screws)
    if (!screw.revolute || !scope.is_zero(cross(screw.axis, screws[0].axis)))
      return "not a planar arm: the axes are not all parallel";
  const Vector axis = screws[0].axis;
  Target target(attempt.builder, attempt.chain.home);
  // The tool point as a held joint has moved it.
  const Vector tool = scope.held() ? attempt.scope.define(attempt.plan.target, "start", attempt.chain.home.p)
                                   : attempt.chain.home.p;
  const Vector placed = screws.size() == 3 ? screws[2].point : tool;
  if (std::string missing = missing_link(scope, screws[0], screws[1], placed); !missing.empty())
    return missing;
  if (screws.size() == 2) {
    require_height(attempt, axis, tool, target.pose().p);
    place_by_two_links(attempt, screws[0], screws[1], tool, target.pose().p);
    attempt.plan.structure = "two parallel axes place the tool point in their plane; the orientation follows";
    return "";
  }
  const Screw& third = screws[2];
  const symbolic::Quaternion& q = target.orientation();
  const Vector part{q.x, q.y, q.z};
  attempt.builder.require_zero(scope.clean(dot(screws[0].first, part)), 1, "no tilt out of the plane");
  attempt.builder.require_zero(scope.clean(dot(screws[0].second, part)), 1, "no tilt out of the plane");
  require_height(attempt, axis, third.point, target.image(third.point));
  place_by_two_links(attempt, screws[0], screws[1], third.point, target.image(third.point));
  const ex along = scope.clean(dot(axis, part));
  Flat rest{q.w * q.w - along * along, 2 * q.w * along};
  const auto without = [&](const Screw& screw) {
    const Scope::Turn at = attempt.builder.value(screw);
    const int sign = scope.sample(dot(axis, screw.axis)) > 0 ? 1 : -1;
    rest = rest * Flat{at.cosine, -sign * at.sine};
  };
  without(screws[0]);
  without(screws[1]);
  const int sign = scope.sample(dot(axis, third.axis)) > 0 ? 1 : -1;
  attempt.builder.turn_by_pair(third, {rest.x, sign * rest.y}, "the rest of the orientation");
  attempt.plan.structure = "three parallel axes: position and orientation in the plane";
  return "";
}

}  // namespace qvgen::derive::inverse
