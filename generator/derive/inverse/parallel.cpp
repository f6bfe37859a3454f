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

void last_parallel_joint(Attempt& attempt, const std::vector<Screw>& s) {
  const Scope::Turn sum = {symbolic::symbol(std::string("cos_") + sum_name), symbolic::symbol(std::string("sin_") + sum_name)};
  Flat rest{sum.cosine, sum.sine};
  const auto sense = [&](const Screw& screw) { return attempt.scope.sample(dot(s[1].axis, screw.axis)) > 0 ? 1 : -1; };
  for (const Screw* screw : {&s[1], &s[2]}) {
    const Scope::Turn at = attempt.builder.value(*screw);
    rest = rest * Flat{at.cosine, -sense(*screw) * at.sine};
  }
  attempt.builder.turn_by_pair(s[3], {rest.x, sense(s[3]) * rest.y}, "what the sum of the three leaves for " + s[3].variable);
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
  const symbolic::Quaternion whole = back ? symbolic::inverse(target.orientation()) : target.orientation();
  const symbolic::Quaternion rotation = without_first(builder, {s[0]}, whole);
  Screw sum = s[1];
  sum.variable = sum_name;
  sum.joint = -1;
  solve_wrist(builder, sum, s[4], s[5], rotation);
  attempt.plan.wrist.ends_the_plan = false;
  // e2 e3 x4 = e1^-1 T (e5 e6)^-1 x4 for x4 on the fourth axis.
  Vector x4 = s[3].point;
  for (const Screw* screw : {&s[4], &s[5]}) {
    const Scope::Turn at = builder.value(*screw);
    x4 = apply(*screw, at.cosine, -at.sine, x4);
    const std::string name = "fourth_" + screw->variable;
    x4 = {builder.keep(name + "_x", scope.clean(x4.x)), builder.keep(name + "_y", scope.clean(x4.y)), builder.keep(name + "_z", scope.clean(x4.z))};
  }
  const Scope::Turn at = builder.value(s[0]);
  const Vector there = apply(s[0], at.cosine, -at.sine, motion(x4));
  two_link(attempt, s[1], s[2], s[3].point, there);
  last_parallel_joint(attempt, s);
  attempt.plan.structure = "the axes of joints " + joint_range(k, 3) + " are parallel";
  return "";
}

}  // namespace qvgen::derive::inverse
