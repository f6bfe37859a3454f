// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_couplings.h"

#include <algorithm>

#include "description/xml/mjcf_loops.h"
#include "model/arithmetic.h"

namespace qvgen::description::xml {
namespace {

/// The name of a tendon's length in sums with joints, which no joint has.
std::string key_of(const std::string& tendon) { return "\n" + tendon; }

bool has_loops(const Element& root) {
  return std::any_of(root.children.begin(), root.children.end(), [](const Element& section) {
    return section.name == "equality" &&
           std::any_of(section.children.begin(), section.children.end(), is_loop);
  });
}

/// A tendon with what its class gives it.
Element completed_tendon(Context& context, const MjcfModel& model, Element tendon) {
  tendon.name = "tendon";
  return model.defaults.completed(context, tendon, "");
}

/// The five coefficients; fewer are filled up by 0.
std::optional<std::vector<Decimal>> coefficients(Context& context, const Element& element) {
  const Attribute* attribute = element.attribute("polycoef");
  std::vector<Decimal> numbers(5);
  numbers[1].value = 1;
  if (attribute == nullptr) return numbers;
  const auto written = read_decimals(context, *attribute);
  if (!written) return std::nullopt;
  if (written->empty() || written->size() > 5) {
    context.error(attribute->place, "'polycoef' has " + std::to_string(written->size()) + " numbers",
                  "give one to five, e.g. polycoef=\"0 1\"");
    return std::nullopt;
  }
  std::copy(written->begin(), written->end(), numbers.begin());
  return numbers;
}

}  // namespace

MjcfCouplings::MjcfCouplings(Context& context, const MjcfModel& model, const MjcfTree& tree)
    : context_(&context) {
  for (const MjcfPart& part : tree.parts)
    if (part.joint) joints_[part.joint->name] = &*part.joint;
  for (const Element& section : model.root.children)
    if (section.name == "tendon")
      for (const Element& tendon : section.children)
        if (tendon.name == "fixed") tendons_[text_of(tendon, "name")] = &tendon;
  for (const Element& section : model.root.children)
    if (section.name == "equality")
      for (const Element& element : section.children) read(element);
  read_motors(model);
  for (const Element& section : model.root.children)
    if (section.name == "tendon" && has_more(section)) warn_of_tendons(context, section);
}

bool MjcfCouplings::follow_powers() const {
  return std::any_of(relations_.begin(), relations_.end(),
                     [](const auto& relation) { return !relation.second.powers.empty(); });
}

/// True if a section has tendons that tie no joints.
bool MjcfCouplings::has_more(const Element& section) const {
  return std::any_of(section.children.begin(), section.children.end(), [&](const Element& tendon) {
    return tendon.name != "fixed" || used_.count(text_of(tendon, "name")) == 0;
  });
}

void MjcfCouplings::read(const Element& element) {
  if (text_of(element, "active") == "false" || is_loop(element)) return;
  if (element.name == "joint" && joints_.count(text_of(element, "joint1")) > 0) return read_joint(element);
  if (element.name == "tendon" && tendons_.count(text_of(element, "tendon1")) > 0)
    return read_tendons(element);
  context_->warning(element.place, "<" + element.name + "> of <equality> is not read: joints move freely",
                    "remove it if that is right");
}

void MjcfCouplings::read_joint(const Element& element) {
  const auto numbers = coefficients(*context_, element);
  if (!numbers) return;
  Relation relation{element.place, &element, {}, (*numbers)[0]};
  const std::string leader = text_of(element, "joint2");
  if (!leader.empty()) {
    relation.leaders[leader] = (*numbers)[1].value;
    for (std::size_t degree = 2; degree < numbers->size(); ++degree)
      relation.powers.push_back((*numbers)[degree].value);
    while (!relation.powers.empty() && cln::zerop(relation.powers.back())) relation.powers.pop_back();
  }
  add(text_of(element, "joint1"), relation);
}

/// The factors of a tendon's joints; `last`: the one that is named last.
MjcfCouplings::Sum MjcfCouplings::joints_of_tendon(const std::string& tendon_name, std::string* last) {
  Sum sum;
  const auto tendon = tendons_.find(tendon_name);
  if (tendon == tendons_.end()) return sum;
  used_.insert(tendon->first);
  for (const Element& joint : tendon->second->children) {
    const std::string name = text_of(joint, "joint");
    const cln::cl_RA factor = read_decimal(*context_, joint, "coef", 0).value;
    if (name.empty() || cln::zerop(factor)) continue;
    sum[name] = sum[name] + factor;
    if (last != nullptr) *last = name;
  }
  return sum;
}

void MjcfCouplings::read_tendons(const Element& element) {
  const auto numbers = coefficients(*context_, element);
  std::string follower;
  const Sum first = joints_of_tendon(text_of(element, "tendon1"), &follower);
  const Sum second = joints_of_tendon(text_of(element, "tendon2"), nullptr);
  if (!numbers || follower.empty()) return;
  Sum rest;  // of all but the follower, and of the follower: first - a1 second = a0
  for (const auto& [name, factor] : first) rest[name] = rest[name] + factor;
  for (const auto& [name, factor] : second) rest[name] = rest[name] - (*numbers)[1].value * factor;
  const cln::cl_RA own = rest[follower];
  if (cln::zerop(own)) {
    context_->warning(element.place, "the tendons leave '" + follower + "' free: their relation is not read",
                      "name the joint that follows last in 'tendon1'");
    return;
  }
  Relation relation{element.place, &element, {}, (*numbers)[0], 1 / own};
  for (const auto& [name, factor] : rest)
    if (name != follower && !cln::zerop(factor)) relation.leaders[name] = -factor / own;
  add(follower, relation);
}

/// Returns a joint in terms of joints that follow none: itself, if it follows none; nothing if it is
/// reported.
std::optional<MjcfCouplings::Followed> MjcfCouplings::in_leaders(const std::string& joint) {
  if (joints_.count(joint) == 0) return std::nullopt;
  if (relations_.count(joint) == 0) return Followed{{{joint, 1}}, {}};
  std::set<std::string> above;
  const Followed* found = followed(joint, above);
  if (found != nullptr) return *found;
  wrong_.insert(joint);
  return std::nullopt;
}

std::optional<MjcfCouplings::Followed> MjcfCouplings::length_of(const std::string& tendon) {
  Followed length;
  for (const auto& [joint, factor] : joints_of_tendon(tendon, nullptr)) {
    const auto own = in_leaders(joint);
    if (own && !own->powers.empty())
      context_->error(relations_.at(joint).place,
                      "the joint '" + joint + "' follows by a polynomial, and the tendon '" + tendon +
                          "', which has a motor, moves it",
                      "give the motor to the joint that leads");
    if (!own || !own->powers.empty()) return std::nullopt;
    length.offset.add(factor, own->offset);
    for (const auto& [name, share] : own->sum) length.sum[name] = length.sum[name] + factor * share;
  }
  std::erase_if(length.sum, [](const auto& share) { return cln::zerop(share.second); });
  if (length.sum.empty()) return std::nullopt;
  return length;
}

/// Ties joints to the motors of tendons.
void MjcfCouplings::read_motors(const MjcfModel& model) {
  const auto actuators = actuators_of(model.root, "tendon");
  std::map<std::string, Sum> lengths;
  for (const auto& [tendon, actuator] : actuators) {
    const auto length = length_of(tendon);
    if (!length) continue;
    lengths[key_of(tendon)] = length->sum;
    TendonMotor& motor = motors_[key_of(tendon)];
    motor.in_pose = length->offset;
    for (const auto& [joint, factor] : length->sum) motor.in_pose.add(factor, in_pose(joint));
  }
  std::set<std::string> driven;
  for (const char* key : {"joint", "jointinparent"})
    for (const auto& actuator : actuators_of(model.root, key)) driven.insert(actuator.first);
  const bool beside_loops = has_loops(model.root) && tree::takes_loops(context_->options);
  for (const TendonGroup& group : tendon_groups(lengths, driven, beside_loops))
    add_group(model, group, actuators);
  followed_.clear();
}

namespace {

/// True if the length of the only tendon is the value of its only joint.
bool is_the_joint(const TendonGroup& group) {
  if (group.relations.size() != 1) return false;
  const JointSum& only = group.relations.begin()->second;
  return only.size() == 1 && only.begin()->second == 1;
}

std::string list_of(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

}  // namespace

/// Says that joints of a group have values of their own.
void MjcfCouplings::tell_of_group(const TendonGroup& group,
                                  const std::map<std::string, const Element*>& actuators) {
  for (const std::string& key : group.tendons) {
    const std::string tendon = key.substr(1);
    context_->warning(
        actuators.at(tendon)->place,
        "the motor of the tendon '" + tendon + "' moves " + list_of(group.joints) +
            ", which motors do not tell apart: each has a value of its own",
        "its force acts by the tendon's 'coef'; what ties the joints by <equality>, or a motor for each, "
        "would tell them apart");
  }
}

/// Ties the joints of a group. A single joint whose value is the tendon's length stays as it is.
void MjcfCouplings::add_group(const MjcfModel& model, const TendonGroup& group,
                              const std::map<std::string, const Element*>& actuators) {
  if (group.relations.empty()) return tell_of_group(group, actuators);
  if (is_the_joint(group)) {
    driven_by_lengths_.insert(group.relations.begin()->first);
    return;
  }
  const MjcfNumbers numbers(*context_, model.settings);
  const bool turns = MjcfNumbers::is_hinge(joints_.at(*group.joints.begin())->element);
  for (const std::string& key : group.tendons) {
    const std::string tendon = key.substr(1);
    const Element completed = completed_tendon(*context_, model, *tendons_.at(tendon));
    motors_.at(key).motor = {key, numbers.tendon_motor(completed, tendon, turns), group.joints,
                             actuators.at(tendon)->place};
  }
  const Element& actuator = *actuators.at(group.tendons.front().substr(1));
  for (const auto& [joint, sum] : group.relations) add(joint, {actuator.place, &actuator, sum, {}});
}

void MjcfCouplings::add(const std::string& follower, Relation relation) {
  const auto [place, is_new] = relations_.try_emplace(follower, std::move(relation));
  if (!is_new) place->second.is_again = true;
}

void MjcfCouplings::Value::add(const cln::cl_RA& factor, const Value& other) {
  plain = plain + factor * other.plain;
  half_turns = half_turns + factor * other.half_turns;
}

MjcfCouplings::Value MjcfCouplings::value_of(const model::Expression& expression) {
  const auto form = model::angle_form(expression).value_or(model::AngleForm{});
  return {form.radians, form.half_turns};
}

/// The value of a joint or a tendon as the file has it; 0 for what is no hinge and no slide.
MjcfCouplings::Value MjcfCouplings::in_pose(const std::string& joint) const {
  if (const auto motor = motors_.find(joint); motor != motors_.end()) return motor->second.in_pose;
  const auto known = joints_.find(joint);
  if (known == joints_.end()) return {};
  const MjcfNumbers numbers(*context_, known->second->placed.model->settings);
  return value_of(numbers.reference(known->second->element));
}

MjcfCouplings::Value MjcfCouplings::constant_of(const std::string& joint, const Relation& relation) const {
  const MjcfJoint& follower = *joints_.at(joint);
  const MjcfNumbers numbers(*context_, follower.placed.model->settings);
  const bool is_angle = MjcfNumbers::is_hinge(follower.element) && relation.of_constant == 1;
  if (is_angle) return value_of(numbers.radians(relation.constant));
  return {relation.constant.value * relation.of_constant, 0};
}

/// True, and reported, if a relation cannot be one of a joint that follows others.
bool MjcfCouplings::is_wrong(const std::string& joint, const std::set<std::string>& above) const {
  constexpr std::size_t most_above = 100;
  const Relation& relation = relations_.at(joint);
  const std::string told = "the joint '" + joint + "'";
  const auto wrong = [&](const std::string& message) {
    context_->error(relation.place, told + message, "keep one of the relations");
    return true;
  };
  if (relation.is_again) return wrong(" is tied twice");
  if (above.count(joint) > 0) return wrong(" follows joints that follow it");
  if (above.size() > most_above) return wrong(" is followed by more than 100 joints, one by the other");
  if (relation.element->name == "joint") return false;
  const auto numbers = coefficients(*context_, *relation.element);
  for (std::size_t degree = 4; numbers && degree > 1; --degree) {
    if (cln::zerop((*numbers)[degree].value)) continue;
    context_->error((*numbers)[degree].place,
                    told + " follows by a polynomial of degree " + std::to_string(degree),
                    "tendons tie sums of multiples of joints, polycoef=\"a0 a1\"; without the relation the "
                    "joint is free");
    return true;
  }
  return false;
}

std::optional<MjcfCouplings::Followed> MjcfCouplings::resolved(const std::string& joint,
                                                               std::set<std::string>& above) {
  const Relation& relation = relations_.at(joint);
  Followed result{{}, constant_of(joint, relation)};
  result.offset.add(1, in_pose(joint));
  for (const auto& [leader, factor] : relation.leaders) {
    result.offset.add(-factor, in_pose(leader));
    if (relations_.count(leader) == 0) {
      result.sum[leader] = result.sum[leader] + factor;
      if (!add_powers(joint, relation, nullptr, result)) return std::nullopt;
      continue;
    }
    const Followed* further = followed(leader, above);
    if (further == nullptr) return std::nullopt;
    result.offset.add(factor, further->offset);
    for (const auto& [name, share] : further->sum) result.sum[name] = result.sum[name] + factor * share;
    if (!add_powers(joint, relation, further, result)) return std::nullopt;
  }
  return result;
}

/// Adds powers of a relation with one leader: its own, (r z + d - x0)^k = r^k (z - (x0 - d) / r)^k where the
/// leader follows r z + d, or those by which the leader follows. False, and reported, if it has other ones.
bool MjcfCouplings::add_powers(const std::string& joint, const Relation& relation, const Followed* leader,
                               Followed& to) {
  const bool own = !relation.powers.empty(), others = leader != nullptr && !leader->powers.empty();
  if (!own && !others) return true;
  if (relation.leaders.size() > 1 || to.sum.size() != 1 || (own && others)) {
    context_->error(
        relation.place, "the joint '" + joint + "' follows by polynomials of several joints",
        "a joint follows by one polynomial of one joint that follows none, or that follows one by "
        "polycoef=\"a0 a1\"");
    return false;
  }
  if (others) {
    const cln::cl_RA factor = relation.leaders.begin()->second;
    to.from = leader->from;
    for (const cln::cl_RA& power : leader->powers) to.powers.push_back(factor * power);
    return true;
  }
  const cln::cl_RA ratio = leader == nullptr ? 1 : leader->sum.begin()->second;
  to.from.add(1 / ratio, in_pose(relation.leaders.begin()->first));
  if (leader != nullptr) to.from.add(-1 / ratio, leader->offset);
  cln::cl_RA scale = ratio;
  for (const cln::cl_RA& power : relation.powers) {
    scale = scale * ratio;
    to.powers.push_back(scale * power);
  }
  return true;
}

/// Returns what a joint follows, in joints that follow none; nothing if it is reported.
const MjcfCouplings::Followed* MjcfCouplings::followed(const std::string& joint,
                                                       std::set<std::string>& above) {
  if (const auto known = followed_.find(joint); known != followed_.end()) return &known->second;
  if (is_wrong(joint, above)) return nullptr;
  above.insert(joint);
  const auto result = resolved(joint, above);
  above.erase(joint);
  return result ? &followed_.emplace(joint, *result).first->second : nullptr;
}

std::optional<tree::Mimic> MjcfCouplings::of(const std::string& joint) {
  const auto relation = relations_.find(joint);
  if (relation == relations_.end() || wrong_.count(joint) > 0) return std::nullopt;
  std::set<std::string> above;
  const Followed* found = followed(joint, above);
  if (found == nullptr) return std::nullopt;
  tree::Mimic mimic{{}, {}, relation->second.place, true};
  const auto in_angle = [](const Value& value) {
    return model::add(model::Expression(value.plain),
                      model::multiply(model::Expression(value.half_turns), model::Expression::pi()));
  };
  mimic.offset = in_angle(found->offset);
  if (!found->powers.empty()) mimic.powers = {found->powers, in_angle(found->from)};
  for (const auto& [name, factor] : found->sum) {
    if (cln::zerop(factor) && mimic.powers.empty()) continue;
    mimic.leaders.push_back({name, factor});
    if (const auto motor = motors_.find(name); motor != motors_.end())
      mimic.motors.push_back(motor->second.motor);
  }
  if (!mimic.leaders.empty()) return mimic;
  context_->warning(relation->second.place,
                    "<equality> holds the joint '" + joint + "', which is read as free",
                    "with --fixed " + joint + " it is held at zero");
  return std::nullopt;
}

}  // namespace qvgen::description::xml
