// SPDX-License-Identifier: MIT
#include "description/followers.h"

#include <algorithm>
#include <utility>

#include "description/entries.h"
#include "description/names.h"
#include "description/relation.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"
#include "model/followers.h"
#include "model/mechanism.h"

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

/// The value of the only leader at which the follower has the value of `limit`.
Expression at_leader(const Expression& limit, const Follower& follower) {
  return model::divide(model::subtract(limit, follower.offset), Expression(follower.leaders.front().ratio));
}

bool is_below(const Expression& a, const Expression& b) {
  return cln::minusp(model::evaluate(a) - model::evaluate(b));
}

void narrow(model::Limits& limits, const model::Limits& by) {
  if (is_below(limits.lower, by.lower)) limits.lower = by.lower;
  if (is_below(by.upper, limits.upper)) limits.upper = by.upper;
}

/// A joint or a motor.
struct Leader {
  std::string variable;
  std::optional<model::Limits>* limits;
};

/// Limits of a joint with one leader as limits of that. An offset with symbols has no value yet: they are
/// dropped.
void hand_on_limits(Context& context, const Follower& follower, model::Joint& joint, const Leader& leader) {
  const std::optional<model::Limits> own = joint.limits;
  joint.limits.reset();
  if (!own || !symbols(follower.offset).empty()) return;
  model::Limits limits{at_leader(own->lower, follower), at_leader(own->upper, follower)};
  if (cln::minusp(follower.leaders.front().ratio)) std::swap(limits.lower, limits.upper);
  if (*leader.limits) narrow(limits, **leader.limits);
  const std::string contradicted = "the limits of '" + joint.variable + "' and of '" + leader.variable +
                                   "', which it follows, leave no value that is within both";
  if (!is_below(limits.lower, limits.upper) && follower.may_be_alone)
    return context.warning(follower.place, contradicted + ": those of '" + leader.variable + "' count",
                           "correct the relation or the limits");
  *leader.limits = limits;
  if (!is_below(limits.lower, limits.upper))
    context.error(follower.place, contradicted, "correct ratio, offset or limits");
}

/// Limits of a joint with several leaders, as limits of the relation without its offset, which stands in the
/// joint's frame.
void shift_limits(const Follower& follower, model::Joint& joint) {
  if (!joint.limits) return;
  if (!symbols(follower.offset).empty()) return joint.limits.reset();
  joint.limits->lower = model::subtract(joint.limits->lower, follower.offset);
  joint.limits->upper = model::subtract(joint.limits->upper, follower.offset);
}

class Ties {
 public:
  Ties(Context& context, const std::vector<std::string>& names, model::Robot& robot)
      : context_(context), names_(names), robot_(robot) {}

  void tie(const Follower& follower) {
    if (follower.may_be_alone && is_alone(follower)) return;
    if (!follower.powers.empty())
      return context_.error(follower.place,
                            "'" + names_[follower.joint] + "' follows by powers of '" +
                                follower.leaders.front().variable + "', and joints of one chain follow sums",
                            "read the whole robot, in which such a joint has a value of its own");
    model::Joint& joint = robot_.joints[follower.joint];
    std::vector<Leader> leaders;
    for (const model::Lead& lead : follower.leaders) {
      const auto leader = leader_of(follower, lead.variable);
      if (!leader) return;
      leaders.push_back(*leader);
      joint.follows.push_back({leader->variable, lead.ratio});
    }
    if (leaders.size() == 1)
      hand_on_limits(context_, follower, joint, leaders.front());
    else
      shift_limits(follower, joint);
    add_offset(joint, follower.offset);
    if (leaders.size() > 1 && !joint.drive.coulomb_friction.is_literal_zero())
      context_.error(follower.place,
                     "'" + joint.variable +
                         "' follows several and has Coulomb friction, whose direction is no "
                         "sum of theirs",
                     "give the friction to the motors");
  }

  /// The relation of a joint that keeps a value of its own; nothing where it is reported.
  std::optional<model::Gear> gear(const Follower& follower) {
    if (follower.may_be_alone && is_alone(follower)) return std::nullopt;
    model::Gear gear{follower.joint, {}, follower.offset, follower.powers};
    std::vector<Leader> leaders;
    for (const model::Lead& lead : follower.leaders) {
      const auto leader = leader_of(follower, lead.variable);
      if (!leader) return std::nullopt;
      leaders.push_back(*leader);
      gear.leaders.emplace_back(std::find(names_.begin(), names_.end(), lead.variable) - names_.begin(),
                                lead.ratio);
    }
    if (leaders.size() == 1 && follower.powers.empty())
      hand_on_limits(context_, follower, robot_.joints[follower.joint], leaders.front());
    return gear;
  }

  /// Every motor moves something, and no two alike.
  void check_motors() {
    const auto is_led = [&](const model::Motor& motor) {
      return std::any_of(robot_.joints.begin(), robot_.joints.end(), [&](const model::Joint& joint) {
        return std::any_of(joint.follows.begin(), joint.follows.end(),
                           [&](const model::Lead& lead) { return lead.variable == motor.variable; });
      });
    };
    for (std::size_t i = 0; i < robot_.motors.size(); ++i)
      if (!is_led(robot_.motors[i]))
        context_.error(context_.motor_places[i],
                       "no joint follows the motor '" + robot_.motors[i].variable + "'",
                       "write follows = \"" + robot_.motors[i].variable + "\" in the joint that it moves");
    if (context_.has_error || robot_.motors.empty() || model::has_independent_motors(robot_)) return;
    context_.error(
        context_.motor_places.front(),
        "the relations of the joints do not tell the motors apart: some motion of the motors moves no "
        "joint",
        "correct the factors of 'follows'; there are at most as many motors as joints");
  }

 private:
  [[nodiscard]] bool is_motor(const std::string& name) const {
    return std::any_of(robot_.motors.begin(), robot_.motors.end(),
                       [&](const model::Motor& motor) { return motor.variable == name; });
  }

  /// True, and told, if a leader is no joint of the chain.
  bool is_alone(const Follower& follower) {
    for (const model::Lead& lead : follower.leaders) {
      if (is_motor(lead.variable) || std::find(names_.begin(), names_.end(), lead.variable) != names_.end())
        continue;
      context_.warning(follower.place,
                       "'" + names_[follower.joint] + "' follows '" + lead.variable +
                           "', which is no joint of the chain: it is read as free",
                       "take a chain with both if it shall follow");
      return true;
    }
    return false;
  }

  /// The leader of that name; reported if there is none that may lead.
  std::optional<Leader> leader_of(const Follower& follower, const std::string& name) {
    for (model::Motor& motor : robot_.motors)
      if (motor.variable == name) return Leader{motor.variable, &motor.limits};
    const std::string told = "'" + names_[follower.joint] + "' follows '" + name + "'";
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return unknown(follower, name, told);
    const auto leader = static_cast<std::size_t>(found - names_.begin());
    if (std::none_of(context_.followers.begin(), context_.followers.end(),
                     [&](const Follower& other) { return other.joint == leader; }))
      return Leader{robot_.joints[leader].variable, &robot_.joints[leader].limits};
    context_.error(
        follower.place,
        told + (leader == follower.joint ? ": no joint leads itself" : ", which follows another itself"),
        follower.leaders.size() == 1 ? "name the joint at the beginning, with the product of the ratios"
                                     : "name joints that follow none, or motors");
    return std::nullopt;
  }

  std::nullopt_t unknown(const Follower& follower, const std::string& name, const std::string& told) {
    std::vector<std::string> others = names_;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(follower.joint));
    for (const model::Motor& motor : robot_.motors) others.push_back(motor.variable);
    const std::string near = nearest(name, others);
    context_.error(follower.place,
                   told + (robot_.motors.empty() ? ", which is no joint of the chain"
                                                 : ", which is neither a joint of the chain nor a motor"),
                   near.empty() ? "take a chain with both, or make it a joint of its own"
                                : "did you mean '" + near + "'?");
    return std::nullopt;
  }

  Context& context_;
  const std::vector<std::string>& names_;
  model::Robot& robot_;
};

Entry offset_of(const Table& table, const Entry& entry, model::JointType type) {
  Context& context = table.context();
  const bool turns = type == model::JointType::revolute;
  Entry offset = (turns ? in_radians : in_metres)(context, entry);
  if (turns)
    check_angle(context, offset);
  else
    check_length(context, offset, "offset");
  return offset;
}

/// A leader by its name alone, with `ratio` and `offset`.
Follower plain_follower(const Table& table, const std::string& leader, model::JointType type) {
  const Entry offset = offset_of(table, entry_or_zero(table, "offset", {}), type);
  return {table.context().joint_places.size() - 1,
          {{leader, read_ratio(table)}},
          offset.value,
          table.place_of("follows")};
}

bool is_name(const std::string& text) { return text.find_first_of(" +-*/^()\t") == std::string::npos; }

/// A relation, which has factors and constant itself.
void read_sum(const Table& table, const std::string& text, model::JointType type) {
  Context& context = table.context();
  for (const char* key : {"ratio", "offset"})
    if (table.has(key))
      context.error(table.key_place(key), "'" + std::string(key) + "' beside a sum in 'follows'",
                    "write it in the sum, e.g. follows = \"1/2 ml + 1/2 mr + 10 deg\"");
  const auto relation = read_relation(context, text, table.place_of("follows"));
  if (!relation) return;
  if (!relation->powers.empty() && (context.units.degrees || context.units.length != 1))
    context.error(table.place_of("follows"), "factors of powers are for radians and metres",
                  "leave 'angle_unit' and 'length_unit' out, and write units, e.g. 10 deg");
  const Entry offset = offset_of(table, relation->constant, type);
  context.followers.push_back({context.joint_places.size() - 1, relation->leaders, offset.value,
                               table.place_of("follows"), false, relation->powers});
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
  const std::string text = table.text("follows").value_or("");
  if (is_name(text))
    context.followers.push_back(plain_follower(table, text, type));
  else
    read_sum(table, text, type);
}

bool follows_sum(const Table& table) {
  return table.has("follows") && !is_name(table.find("follows")->value_or(std::string()));
}

void tie_followers(Context& context, const std::vector<std::string>& names, model::Robot& robot) {
  Ties ties(context, names, robot);
  for (const Follower& follower : context.followers) ties.tie(follower);
  ties.check_motors();
}

std::vector<model::Gear> gears_of(Context& context, const std::vector<std::string>& names,
                                  model::Robot& robot) {
  Ties ties(context, names, robot);
  std::vector<model::Gear> gears;
  for (const Follower& follower : context.followers)
    if (const auto gear = ties.gear(follower)) gears.push_back(*gear);
  return gears;
}

bool follow_powers(const Context& context) {
  return std::any_of(context.followers.begin(), context.followers.end(),
                     [](const Follower& follower) { return !follower.powers.empty(); });
}

void drive_leaders(model::Mechanism& mechanism) {
  model::Loops& loops = mechanism.loops;
  if (!loops.closures.empty()) return;
  for (std::size_t i = 0; i < mechanism.robot.joints.size(); ++i)
    if (std::none_of(loops.gears.begin(), loops.gears.end(),
                     [&](const model::Gear& gear) { return gear.joint == i; }))
      loops.actuated.push_back(i);
}

void make_motors_joints(Context& context, model::Robot& robot) {
  const std::vector<model::Motor> motors = std::exchange(robot.motors, {});
  for (std::size_t i = 0; i < motors.size(); ++i) {
    model::Joint joint;
    joint.type = motors[i].type;
    joint.variable = motors[i].variable;
    joint.axis = {Expression(), Expression(), Expression(cln::cl_RA(1))};
    joint.limits = motors[i].limits;
    joint.drive = motors[i].drive;
    joint.greatest_velocity = motors[i].greatest_velocity;
    joint.greatest_effort = motors[i].greatest_effort;
    robot.joints.push_back(std::move(joint));
    model::set_parent(robot, robot.joints.size() - 1, model::base_link);
    context.joint_places.push_back(context.motor_places[i]);
  }
}

}  // namespace qvgen::description
