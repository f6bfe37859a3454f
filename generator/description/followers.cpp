// SPDX-License-Identifier: MIT
#include "description/followers.h"

#include <algorithm>

#include "description/entries.h"
#include "description/names.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

using model::Expression;

/// A rational number other than 0; reported if it is none.
cln::cl_RA read_ratio(const Table& table) {
  if (!table.has("ratio")) return 1;
  const auto entry = read_entry(table.context(), *table.find("ratio"), {Role::constant}, "'ratio'");
  if (!entry || !symbols(entry->value).empty()) return 1;
  const auto ratio = model::rational_value(model::evaluate(entry->value));
  if (ratio && !cln::zerop(*ratio)) return *ratio;
  table.context().error(table.place_of("ratio"),
                        ratio ? "with a ratio of 0 the joint does not move" : "the ratio is not rational",
                        ratio ? "leave the joint out" : "write a number or a quotient, e.g. \"3/2\"");
  return 1;
}

/// The constant by which a joint lies off its value, put into the frame before it.
void add_offset(model::Joint& joint, const Expression& offset) {
  if (offset.is_literal_zero()) return;
  if (joint.type == model::JointType::revolute) {
    joint.before.turns.push_back({joint.axis, offset});
    return;
  }
  model::Vector3 way;
  for (std::size_t i = 0; i < 3; ++i) way.at(i) = model::multiply(offset, joint.axis.at(i));
  joint.before = model::compose(joint.before, {{}, way});
}

/// The value of the leader at which the follower has the value of `limit`.
Expression at_leader(const Expression& limit, const Follower& follower) {
  return model::divide(model::subtract(limit, follower.offset), Expression(follower.ratio));
}

bool is_below(const Expression& a, const Expression& b) {
  return cln::minusp(model::evaluate(a) - model::evaluate(b));
}

void narrow(model::Limits& limits, const model::Limits& by) {
  if (is_below(limits.lower, by.lower)) limits.lower = by.lower;
  if (is_below(by.upper, limits.upper)) limits.upper = by.upper;
}

/// A follower's limits as limits of its leader. An offset with symbols has no value yet: they are dropped.
void hand_on_limits(Context& context, const Follower& follower, model::Joint& joint, model::Joint& leader) {
  const std::optional<model::Limits> own = joint.limits;
  joint.limits.reset();
  if (!own || !symbols(follower.offset).empty()) return;
  model::Limits limits{at_leader(own->lower, follower), at_leader(own->upper, follower)};
  if (cln::minusp(follower.ratio)) std::swap(limits.lower, limits.upper);
  if (leader.limits) narrow(limits, *leader.limits);
  leader.limits = limits;
  if (is_below(limits.lower, limits.upper)) return;
  context.error(follower.place,
                "the limits of '" + joint.variable + "' and of '" + leader.variable +
                    "', which it follows, leave no value that is within both",
                "correct ratio, offset or limits");
}

/// The index of the leader; reported if there is none that may lead.
std::optional<std::size_t> leader_of(Context& context, const Follower& follower,
                                     const std::vector<std::string>& names) {
  const std::string told = "'" + names[follower.joint] + "' follows '" + follower.leader + "'";
  const auto found = std::find(names.begin(), names.end(), follower.leader);
  if (found == names.end()) {
    std::vector<std::string> others = names;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(follower.joint));
    const std::string near = nearest(follower.leader, others);
    context.error(follower.place, told + ", which is no joint of the chain",
                  near.empty() ? "take a chain with both, or make it a joint of its own"
                               : "did you mean '" + near + "'?");
    return std::nullopt;
  }
  const auto leader = static_cast<std::size_t>(found - names.begin());
  if (std::none_of(context.followers.begin(), context.followers.end(),
                   [&](const Follower& other) { return other.joint == leader; }))
    return leader;
  context.error(
      follower.place,
      told + (leader == follower.joint ? ": no joint leads itself" : ", which follows another itself"),
      "name the joint at the beginning, with the product of the ratios");
  return std::nullopt;
}

}  // namespace

void read_follower(const Table& table, model::JointType type) {
  Context& context = table.context();
  if (!table.has("follows")) {
    for (const char* key : {"ratio", "offset"})
      if (table.has(key))
        context.error(table.key_place(key), "'" + std::string(key) + "' without 'follows'",
                      "write follows = \"theta1\", the variable of the joint that leads");
    return;
  }
  const bool turns = type == model::JointType::revolute;
  const Entry offset = (turns ? in_radians : in_metres)(context, entry_or_zero(table, "offset", {}));
  if (turns)
    check_angle(context, offset);
  else
    check_length(context, offset, "offset");
  context.followers.push_back({context.joint_places.size() - 1, table.text("follows").value_or(""),
                               read_ratio(table), offset.value, table.place_of("follows")});
}

void tie_followers(Context& context, const std::vector<std::string>& names, model::Robot& robot) {
  for (const Follower& follower : context.followers) {
    const auto leader = leader_of(context, follower, names);
    if (!leader) continue;
    model::Joint& joint = robot.joints[follower.joint];
    joint.follows = model::Follows{*leader, follower.ratio};
    add_offset(joint, follower.offset);
    hand_on_limits(context, follower, joint, robot.joints[*leader]);
  }
}

}  // namespace qvgen::description
