// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/elements.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/inverse.h"
#include "derive/inverse/orientation.h"
#include "derive/inverse/position.h"
#include "derive/inverse/wrist.h"
#include "derive/inverse/wrist_axes.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

std::string Attempt::joints(std::size_t first, std::size_t count) const {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    const int place = problem.places[first + i];
    const bool is_own = place < problem.own_joints;
    text += (i == 0           ? ""
             : i + 1 == count ? " and "
                              : ", ") +
            (is_own ? std::to_string(place + 1) : std::string("the tool's own"));
  }
  return text;
}

std::optional<Vector> meeting_point(const Screw& a, const Screw& b, const Scope& scope) {
  const Vector normal = scope.clean(cross(a.axis, b.axis));
  const ex size = scope.clean(dot(normal, normal));
  if (scope.is_zero(size)) return std::nullopt;
  const Vector between = scope.clean(b.point - a.point);
  if (!scope.is_zero(dot(normal, between))) return std::nullopt;
  return scope.clean(a.point + (scope.clean(dot(cross(between, b.axis), normal)) / size) * a.axis);
}

namespace {

/// Three revolute joints about a point.
struct Wrist {
  WristAxes turning;
  Vector centre;  ///< in the base frame
};

std::optional<Wrist> wrist_of(Attempt& attempt, std::size_t k) {
  const auto& screws = attempt.chain.screws;
  Scope& scope = attempt.scope;
  const auto turning = wrist_axes(attempt, {k, k + 1, k + 2});
  if (!turning) return std::nullopt;
  const auto point = meeting_point(screws[k], screws[k + 1], scope);
  if (!point || !scope.is_zero(cross(screws[k + 2].axis, *point - screws[k + 2].point))) return std::nullopt;
  return Wrist{*turning,
               turning->frame ? scope.define(attempt.plan.target, "centre", scope.settled(*point)) : *point};
}

/// The wrist's angles from the rotation that its joints have to make, in the base frame.
void turn_wrist(Attempt& attempt, const WristAxes& turning, const symbolic::Quaternion& rotation) {
  const auto& [first, middle, last] = turning.axes;
  solve_wrist(attempt.builder, first, middle, last, turning.seen(rotation));
}

/// One joint alone brings `start` to `goal`, which lies where it can be brought: empty, or why it cannot.
std::string place_by_one(Attempt& attempt, const Screw& joint, const Vector& start, const Vector& goal) {
  const Scope& scope = attempt.scope;
  if (!joint.revolute) {
    attempt.builder.slide_by_value(joint, scope.clean(dot(joint.axis, goal - start)),
                                   "the displacement along " + joint.variable);
    return "";
  }
  const Flat arm = in_frame(joint, scope.clean(start - joint.point), scope);
  if (scope.is_zero(arm.x) && scope.is_zero(arm.y))
    return "the axis of " + joint.variable + " goes through it too";
  const Flat turn = in_frame(joint, scope.clean(goal - joint.point), scope) * conjugate(arm);
  attempt.builder.turn_by_pair(joint, turn, "the turn that brings the common point to its place");
  return "";
}

}  // namespace

std::string place_centre(Attempt& attempt, Target& target, std::size_t k, std::size_t count,
                         const Vector& centre) {
  const auto& screws = attempt.chain.screws;
  const auto place = [&](std::size_t i) { return screws.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::vector<Screw> pre(screws.begin(), place(k));
  const std::vector<Screw> post(place(k + count), screws.end());
  const auto named = [&](const Vector& v) {
    return attempt.scope.define(attempt.plan.target, "goal", attempt.scope.clean(v));
  };
  if (pre.size() + post.size() == 1) {
    // The others need not follow every pose, whose rows are looked at.
    attempt.plan.candidates = true;
    return post.empty() ? place_by_one(attempt, pre[0], centre, named(target.image(centre)))
                        : place_by_one(attempt, reversed(post[0]), centre, named(target.source(centre)));
  }
  if (post.empty())
    return solve_position(attempt.builder, pre[0], pre[1], pre[2], centre, named(target.image(centre)));
  if (pre.empty())
    return solve_position(attempt.builder, reversed(post[2]), reversed(post[1]), reversed(post[0]), centre,
                          named(target.source(centre)));
  // post T^-1 pre carries the point to itself. The fewer joints are seen through T or T^-1, so that equations
  // between the others do not hold the pose.
  const auto seen = [&](const Screw& screw, std::size_t i, bool by_tool) {
    Screw result = screw;
    const std::string name = "seen" + std::to_string(i + 1);
    auto& program = attempt.plan.target;
    const auto direction = [&](const Vector& v) {
      return by_tool ? target.direction_image(v) : target.direction_source(v);
    };
    result.axis = attempt.scope.define(program, name + "_axis", direction(screw.axis));
    result.first = attempt.scope.define(program, name + "_first", direction(screw.first));
    result.second = attempt.scope.define(program, name + "_second", direction(screw.second));
    result.point = attempt.scope.define(program, name + "_point",
                                        by_tool ? target.image(screw.point) : target.source(screw.point));
    return result;
  };
  if (post.size() < pre.size())
    return solve_position(attempt.builder, seen(post[0], 0, true), pre[0], pre[1], centre,
                          named(target.image(centre)));
  return solve_position(attempt.builder, post[0], post[1], seen(pre[0], 0, false),
                        named(target.source(centre)), centre);
}

namespace {

/// The arm with its held joint at zero: what a tool's orientation is by turns about constant axes, the held
/// joint's among them.
struct AtZero {
  std::vector<Screw> pre, post;
  WristAxes turning;
  symbolic::Quaternion home;
};

/// Nothing if no joint's angle is held, if it is one between the wrist's joints, or if the axes are no
/// numbers at zero either.
std::optional<AtZero> at_zero(Attempt& attempt, std::size_t k) {
  const auto held = static_cast<std::size_t>(attempt.problem.given);
  if (!attempt.scope.held() || (held > k && held < k + 3)) return std::nullopt;
  const std::size_t first = held <= k ? k + 1 : k;
  Scope scope(attempt.problem.moving);
  symbolic::Program constants;
  Chain chain = chain_of(attempt.problem.moving, scope, constants);
  if (!constants.outputs().empty()) return std::nullopt;
  for (Screw& screw : chain.screws)
    if (const auto joint = static_cast<std::size_t>(screw.joint); joint >= held)
      screw.joint = joint == held ? -1 : screw.joint - 1;
  const auto place = [&](std::size_t i) { return chain.screws.begin() + static_cast<std::ptrdiff_t>(i); };
  const WristAxes turning{{*place(first), *place(first + 1), *place(first + 2)}, {}};
  if (!is_wrist(turning.axes[0], turning.axes[1], turning.axes[2], attempt.scope)) return std::nullopt;
  return AtZero{
      {chain.screws.begin(), place(first)}, {place(first + 3), chain.screws.end()}, turning, chain.home.q};
}

/// The angles of joints k, k+1, k+2 from the tool's orientation and the other joints.
void turn_tool(Attempt& attempt, Target& target, const WristAxes& turning, const std::vector<Screw>& pre,
               const std::vector<Screw>& post) {
  const symbolic::Quaternion first = without_first(attempt.builder, pre, target.orientation());
  turn_wrist(attempt, turning, without_last(attempt.builder, post, first));
  if (post.empty()) attempt.plan.steps.back().elements = quaternion_elements(turning.axes.front());
}

}  // namespace

std::string by_common_point(Attempt& attempt, std::size_t k) {
  const auto& screws = attempt.chain.screws;
  const auto wrist = wrist_of(attempt, k);
  if (!wrist) return "joints " + attempt.joints(k, 3) + ": their axes do not meet in one point";
  Target target(attempt.builder, attempt.chain.home);
  const std::vector<Screw> pre(screws.begin(), screws.begin() + static_cast<std::ptrdiff_t>(k));
  const std::vector<Screw> post(screws.begin() + static_cast<std::ptrdiff_t>(k) + 3, screws.end());
  const std::string reason = place_centre(attempt, target, k, 3, wrist->centre);
  if (!reason.empty())
    return "joints " + attempt.joints(k, 3) + " meet in a point, but the " +
           (screws.size() == 4 ? "other" : "others") + " cannot place it: " + reason;
  if (const auto zero = at_zero(attempt, k)) {
    target.orientation(zero->home);
    turn_tool(attempt, target, zero->turning, zero->pre, zero->post);
  } else {
    turn_tool(attempt, target, wrist->turning, pre, post);
  }
  attempt.plan.structure =
      "the axes of joints " + attempt.joints(k, 3) + " meet in one point: position and orientation decouple";
  return "";
}

std::string by_orientation(Attempt& attempt) {
  const auto turning = wrist_axes(attempt, {0, 1, 2});
  if (!turning)
    return "three turns make an orientation, but neighbouring axes are parallel or not all joints turn";
  Target target(attempt.builder, attempt.chain.home);
  turn_wrist(attempt, *turning, target.orientation());
  attempt.plan.steps.back().elements = quaternion_elements(turning->axes.front());
  attempt.plan.structure = "three axes turn the tool; the position follows";
  return "";
}

std::string by_position(Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  const std::string dependent = dependent_joints(attempt, {0, 1, 2}, true);
  if (!dependent.empty()) return "three joints place the tool point, but " + dependent;
  Target target(attempt.builder, attempt.chain.home);
  const std::string reason =
      solve_position(attempt.builder, screws[0], screws[1], screws[2], attempt.chain.home.p, target.pose().p);
  if (!reason.empty()) return "three joints place the tool point, but: " + reason;
  attempt.plan.structure = "three joints place the tool point; the orientation follows";
  return "";
}

}  // namespace qvgen::derive::inverse
