// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/freedom.h"
#include "derive/inverse/inverse.h"
#include "derive/inverse/orientation.h"
#include "derive/inverse/position.h"
#include "derive/inverse/wrist.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

std::string joint_range(std::size_t first, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += (i == 0 ? "" : i + 1 == count ? " and " : ", ") + std::to_string(first + i + 1);
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

/// Three revolute joints about a point, their axes as numbers: in the base frame if they are that there, else
/// in the first one's own frame.
struct Wrist {
  std::array<Screw, 3> axes;
  bool own_frame = false;
  Vector centre;  ///< in the base frame
};

std::optional<Wrist> wrist_of(Attempt& attempt, std::size_t k) {
  const auto& screws = attempt.chain.screws;
  Scope& scope = attempt.scope;
  const auto serves = [&](const std::array<Screw, 3>& axes) {
    return is_wrist(axes[0], axes[1], axes[2], scope);
  };
  Wrist wrist{{screws[k], screws[k + 1], screws[k + 2]}, false, {}};
  if (!serves(wrist.axes)) wrist = {in_own_frame(attempt.robot, k, scope), true, {}};
  if (!serves(wrist.axes)) return std::nullopt;
  const auto point = meeting_point(screws[k], screws[k + 1], scope);
  if (!point || !scope.is_zero(cross(screws[k + 2].axis, *point - screws[k + 2].point))) return std::nullopt;
  wrist.centre = wrist.own_frame ? scope.define(attempt.plan.target, "centre", *point) : *point;
  return wrist;
}

/// The wrist's angles from the rotation that its joints have to make, in the base frame.
void turn_wrist(Attempt& attempt, std::size_t k, const Wrist& wrist, const symbolic::Quaternion& rotation) {
  const symbolic::Quaternion& frame = attempt.chain.screws[k].frame;
  solve_wrist(attempt.builder, wrist.axes[0], wrist.axes[1], wrist.axes[2],
              wrist.own_frame ? symbolic::inverse(frame) * rotation * frame : rotation);
}

/// The screw as it stands after a locked joint has moved.
Screw carried(Attempt& attempt, const Screw& lock, const Screw& screw) {
  Scope& scope = attempt.scope;
  const Scope::Turn at = attempt.builder.value(lock);
  const auto direction = [&](const std::string& what, const Vector& v) {
    const Vector moved =
        apply(lock, at.cosine, at.sine, lock.point + v) - apply(lock, at.cosine, at.sine, lock.point);
    return scope.define(attempt.plan.target, what + "_" + screw.variable, scope.clean(moved));
  };
  Screw result = screw;
  result.axis = direction("axis", screw.axis);
  result.first = direction("first", screw.first);
  result.second = direction("second", screw.second);
  result.point = scope.define(attempt.plan.target, "point_" + screw.variable,
                              scope.clean(apply(lock, at.cosine, at.sine, screw.point)));
  return result;
}

/// Seven joints: the wrist last, one of the four others held; the joints beyond it are carried along.
std::string by_locked_joint(Attempt& attempt, Target& target, const Wrist& wrist, std::size_t k,
                            std::size_t locked) {
  const auto& screws = attempt.chain.screws;
  if (k != 4 || locked >= k) return "the wrist is not last";
  const Screw& lock = screws[locked];
  if (!lock.revolute) return "the locked joint is prismatic";
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < screws.size(); ++i)
    if (i != locked) free.push_back(i);
  const std::string dependent = dependent_joints(attempt, free, false);
  if (!dependent.empty()) return "with " + lock.variable + " given: " + dependent;
  attempt.scope.turn(locked_joint);
  attempt.plan.locked = static_cast<int>(locked);
  attempt.plan.joints[locked] = {true, std::string("cos_") + locked_joint,
                                 std::string("sin_") + locked_joint};
  std::vector<Screw> arm;
  for (std::size_t i = 0; i < k; ++i)
    if (i != locked) arm.push_back(i < locked ? screws[i] : carried(attempt, lock, screws[i]));
  const Scope::Turn at = attempt.builder.value(lock);
  const Vector start = attempt.scope.define(
      attempt.plan.target, "start", attempt.scope.clean(apply(lock, at.cosine, at.sine, wrist.centre)));
  const Vector goal =
      attempt.scope.define(attempt.plan.target, "goal", attempt.scope.clean(target.image(wrist.centre)));
  const std::string reason = solve_position(attempt.builder, arm[0], arm[1], arm[2], start, goal);
  if (!reason.empty()) return "with " + lock.variable + " given: " + reason;
  const std::vector<Screw> pre(screws.begin(), screws.begin() + static_cast<std::ptrdiff_t>(k));
  const symbolic::Quaternion rotation = without_first(attempt.builder, pre, target.orientation());
  turn_wrist(attempt, k, wrist, rotation);
  attempt.plan.structure =
      "with " + lock.variable + " given, the axes of joints " + joint_range(k, 3) + " meet in one point";
  return "";
}

}  // namespace

std::string by_common_point(Attempt& attempt, std::size_t k, int locked) {
  const auto& screws = attempt.chain.screws;
  const auto wrist = wrist_of(attempt, k);
  if (!wrist) return "joints " + joint_range(k, 3) + ": their axes do not meet in one point";
  Target target(attempt.builder, attempt.chain.home);
  const std::vector<Screw> pre(screws.begin(), screws.begin() + static_cast<std::ptrdiff_t>(k));
  if (locked >= 0) return by_locked_joint(attempt, target, *wrist, k, static_cast<std::size_t>(locked));
  const std::vector<Screw> post(screws.begin() + static_cast<std::ptrdiff_t>(k) + 3, screws.end());
  const auto named = [&](const Vector& v) {
    return attempt.scope.define(attempt.plan.target, "goal", attempt.scope.clean(v));
  };
  std::string reason;
  if (k == 3) {
    reason = solve_position(attempt.builder, pre[0], pre[1], pre[2], wrist->centre,
                            named(target.image(wrist->centre)));
  } else if (k == 0) {
    reason = solve_position(attempt.builder, reversed(post[2]), reversed(post[1]), reversed(post[0]),
                            wrist->centre, named(target.source(wrist->centre)));
  } else {
    // post T^-1 pre carries the point to itself; the first joints are seen through T^-1.
    std::vector<Screw> loop = post;
    for (std::size_t i = 0; i < pre.size(); ++i) {
      Screw seen = pre[i];
      const std::string name = "seen" + std::to_string(i + 1);
      auto& program = attempt.plan.target;
      seen.axis = attempt.scope.define(program, name + "_axis", target.direction_source(pre[i].axis));
      seen.first = attempt.scope.define(program, name + "_first", target.direction_source(pre[i].first));
      seen.second = attempt.scope.define(program, name + "_second", target.direction_source(pre[i].second));
      seen.point = attempt.scope.define(program, name + "_point", target.source(pre[i].point));
      loop.push_back(seen);
    }
    reason = solve_position(attempt.builder, loop[0], loop[1], loop[2], named(target.source(wrist->centre)),
                            wrist->centre);
  }
  if (!reason.empty())
    return "joints " + joint_range(k, 3) + " meet in a point, but the others cannot place it: " + reason;
  const symbolic::Quaternion first = without_first(attempt.builder, pre, target.orientation());
  const symbolic::Quaternion rotation = without_last(attempt.builder, post, first);
  turn_wrist(attempt, k, *wrist, rotation);
  attempt.plan.structure =
      "the axes of joints " + joint_range(k, 3) + " meet in one point: position and orientation decouple";
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
  attempt.plan.position_only = true;
  attempt.plan.structure = "three joints place the tool point; the orientation follows";
  return "";
}

}  // namespace qvgen::derive::inverse
