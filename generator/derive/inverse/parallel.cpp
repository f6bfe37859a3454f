// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/block.h"
#include "derive/inverse/orientation.h"
#include "derive/inverse/wrist.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

constexpr const char* sum_name = "sum";  ///< the sum of the three parallel joints' angles

bool all_parallel(const std::vector<Screw>& screws, std::size_t k, const Scope& scope) {
  for (const Screw& screw : screws)
    if (!screw.revolute) return false;
  return scope.is_zero(cross(screws[k].axis, screws[k + 1].axis)) && scope.is_zero(cross(screws[k].axis, screws[k + 2].axis));
}

/// The arm read from tool to base: joints in reverse order, axes negated.
Chain mirrored(const Chain& chain) {
  Chain result = chain;
  result.screws.assign(chain.screws.rbegin(), chain.screws.rend());
  for (Screw& screw : result.screws) screw = reversed(screw);
  return result;
}

/// point moved by T, or by T^-1 for the mirrored arm.
struct Motion {
  Target& target;
  bool back;
  [[nodiscard]] Vector operator()(const Vector& x) const { return back ? target.source(x) : target.image(x); }
};

Flat turn_of(const std::string& name) { return {symbolic::symbol("cos_" + name), symbolic::symbol("sin_" + name)}; }

int sense(const Attempt& attempt, const Screw& axis, const Screw& screw) {
  return attempt.scope.sample(dot(axis.axis, screw.axis)) > 0 ? 1 : -1;
}

void last_parallel_joint(Attempt& attempt, const std::vector<Screw>& s) {
  Flat rest = turn_of(sum_name);
  for (const Screw* screw : {&s[1], &s[2]}) {
    const Scope::Turn at = attempt.builder.value(*screw);
    rest = rest * Flat{at.cosine, -sense(attempt, s[1], *screw) * at.sine};
  }
  attempt.builder.turn_by_pair(s[3], {rest.x, sense(attempt, s[1], s[3]) * rest.y},
                               "what the sum of the three leaves for " + s[3].variable);
}

/// Where axis 5 is parallel to axis 6 turned onto the three, the sum is free: one that the two links can reach.
Scope::Turn free_sum(Attempt& attempt, const std::vector<Screw>& s, const Flat& point, const Flat& offset) {
  const auto length = [&](std::size_t from) {
    const Flat link = in_frame(s[1], s[from + 1].point - s[from].point, attempt.scope);
    return ex(GiNaC::sqrt(attempt.scope.clean(link.x * link.x + link.y * link.y)));
  };
  const ex first = length(1);
  const ex second = length(2);
  std::vector<Step::Seed> seeds;
  for (const Screw* screw : {&s[1], &s[2], &s[3]}) seeds.push_back({screw->joint, sense(attempt, s[1], *screw)});
  return attempt.builder.reachable(std::string("free_") + sum_name, seeds, point, offset,
                                   attempt.scope.clean(GiNaC::pow(first - second, 2)), attempt.scope.clean(GiNaC::pow(first + second, 2)));
}

}  // namespace

std::string by_parallel_axes(Attempt& attempt, std::size_t k) {
  Scope& scope = attempt.scope;
  if (!all_parallel(attempt.chain.screws, k, scope)) return "joints " + joint_range(k, 3) + ": their axes are not parallel";
  const bool back = k == 2;
  const Chain chain = back ? mirrored(attempt.chain) : attempt.chain;
  const auto& s = chain.screws;
  const auto centre = meeting_point(s[4], s[5], scope);
  if (!centre || !is_wrist(s[1], s[4], s[5], scope))
    return "joints " + joint_range(k, 3) + " are parallel, but the axes of " + s[4].variable + " and " + s[5].variable + " do not meet";
  Target target(attempt.builder, attempt.chain.home);
  const Motion motion{target, back};
  Builder& builder = attempt.builder;
  // The centre keeps its height along the three axes: q1 alone.
  const Vector seen = scope.define(attempt.plan.target, "goal", scope.clean(motion(*centre)));
  const Block first = block_of(s[0], -1, seen, scope);
  const Block::Form height = first.form(s[1].axis, scope);
  if (!first.depends(s[1].axis, scope)) return s[0].variable + " does not change the height along the parallel axes";
  builder.turn_by_line(s[0], height.coefficients, scope.clean(dot(s[1].axis, *centre) - height.constant),
                       "height along the axes of " + s[1].variable + ", " + s[2].variable + ", " + s[3].variable);
  // e1^-1 R is a turn about the three axes, then q5, q6: a wrist.
  // The centre seen from joint 1 is e2 e3 e4 centre, and the fourth axis stands off from it by a constant of the arm.
  const Scope::Turn at = builder.value(s[0]);
  const Flat centre_seen = in_frame(s[1], apply(s[0], at.cosine, -at.sine, seen) - s[1].point, scope);
  const Flat point{builder.keep("centre_x", centre_seen.x), builder.keep("centre_y", centre_seen.y)};
  const Flat offset = in_frame(s[1], s[3].point - *centre, scope);
  const symbolic::Quaternion whole = back ? symbolic::inverse(target.orientation()) : target.orientation();
  const symbolic::Quaternion rotation = without_first(builder, {s[0]}, whole);
  const Scope::Turn free = free_sum(attempt, s, point, offset);
  Screw sum = s[1];
  sum.variable = sum_name;
  sum.joint = -1;
  solve_wrist(builder, sum, s[4], s[5], rotation);
  attempt.plan.wrist.ends_the_plan = false;
  if (!attempt.plan.wrist.right)
    return "joints " + joint_range(k, 3) + " are parallel, but the angles from them to " + s[4].variable + " and on to " +
           s[5].variable + " are not right angles";
  attempt.plan.steps.back().before.output("choice_x", free.cosine);
  attempt.plan.steps.back().before.output("choice_y", free.sine);
  const Flat turned = turn_of(sum_name) * offset;
  const Vector there = s[1].point + (point.x + turned.x) * s[1].first + (point.y + turned.y) * s[1].second;
  two_link(attempt, s[1], s[2], s[3].point, there);
  last_parallel_joint(attempt, s);
  attempt.plan.structure = "the axes of joints " + joint_range(k, 3) + " are parallel";
  return "";
}

}  // namespace qvgen::derive::inverse
