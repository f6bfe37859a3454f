// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_numbers.h"

#include <algorithm>
#include <cctype>

#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description::xml {

model::Expression MjcfNumbers::angle(const Decimal& written) const {
  if (!settings_.degrees) return snap_.angle(written);
  return model::multiply(written.value / 180, model::Expression::pi());
}

std::vector<model::Turn> MjcfNumbers::euler(const std::vector<Decimal>& angles) const {
  std::vector<model::Turn> turns;
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = settings_.euler_sequence[i];
    const model::Turn turn{model::unit_vector(static_cast<std::size_t>(std::tolower(letter) - 'x')),
                           angle(angles[i])};
    if (turn.angle.is_literal_zero()) continue;
    turns.insert(std::isupper(static_cast<unsigned char>(letter)) != 0 ? turns.begin() : turns.end(), turn);
  }
  return turns;
}

bool MjcfNumbers::is_zero(const Attribute& attribute, const std::vector<Decimal>& numbers,
                          std::size_t count) const {
  const auto end = numbers.begin() + static_cast<std::ptrdiff_t>(count);
  if (std::any_of(numbers.begin(), end, [](const Decimal& number) { return !cln::zerop(number.value); }))
    return false;
  context_->error(attribute.place, "'" + attribute.name + "' has length zero", "give a direction");
  return true;
}

std::vector<model::Turn> MjcfNumbers::other_turns(const Element& element) const {
  const auto text = [&](const std::string& key) {
    return key + "=\"" + element.attribute(key)->value + "\"";
  };
  if (element.attribute("quat") != nullptr) {
    const auto q = read_decimals(*context_, element, "quat", 4);
    if (!q || is_zero(*element.attribute("quat"), *q, 4)) return {};
    return turns_of(snap_, matrix_of(*q), together(*q, text("quat")));
  }
  if (element.attribute("axisangle") != nullptr) {
    const auto a = read_decimals(*context_, element, "axisangle", 4);
    if (!a || is_zero(*element.attribute("axisangle"), *a, 3)) return {};
    const model::Turn turn{snap_.direction({(*a)[0], (*a)[1], (*a)[2]}), angle((*a)[3])};
    return turn.angle.is_literal_zero() ? std::vector<model::Turn>{} : std::vector<model::Turn>{turn};
  }
  if (element.attribute("xyaxes") != nullptr) {
    const auto axes = read_decimals(*context_, element, "xyaxes", 6);
    if (!axes) return {};
    const auto matrix = matrix_of_axes(*axes);
    if (matrix) return turns_of(snap_, *matrix, together(*axes, text("xyaxes")));
    context_->error(element.attribute("xyaxes")->place, "the axes of 'xyaxes' are parallel",
                    "give two directions");
    return {};
  }
  const auto z = read_decimals(*context_, element, "zaxis", 3);
  if (!z || is_zero(*element.attribute("zaxis"), *z, 3)) return {};
  return turns_of(snap_, matrix_of_z(*z), together(*z, text("zaxis")));
}

std::vector<model::Turn> MjcfNumbers::turns(const Element& element) const {
  static const std::vector<std::string> keys{"quat", "axisangle", "xyaxes", "zaxis", "euler"};
  const Attribute* found = nullptr;
  for (const std::string& key : keys) {
    const Attribute* attribute = element.attribute(key);
    if (attribute != nullptr && found != nullptr)
      context_->error(attribute->place, "both '" + found->name + "' and '" + key + "' are given",
                      "keep one of them");
    if (found == nullptr) found = attribute;
  }
  if (found == nullptr) return {};
  if (found->name != "euler") return other_turns(element);
  const auto angles = read_decimals(*context_, element, "euler", 3);
  return angles ? euler(*angles) : std::vector<model::Turn>{};
}

model::Displacement MjcfNumbers::frame(const Element& element) const {
  model::Displacement result;
  if (const auto pos = read_decimals(*context_, element, "pos", 3)) result.translation = snap_.lengths(*pos);
  result.turns = turns(element);
  return result;
}

std::vector<model::Turn> MjcfNumbers::turns_of_copy(const Element& replicate, long copy) const {
  auto angles = read_decimals(*context_, replicate, "euler", 3);
  if (!angles) return {};
  for (Decimal& angle : *angles) {
    angle.value = angle.value * copy;
    angle.units *= static_cast<int>(std::min(copy, 1000L));  // a copy is as many times as rough
    angle.text = std::to_string(copy) + " times " + angle.text;
  }
  return euler(*angles);
}

model::Vector3 MjcfNumbers::offset_of_copies(const Element& replicate) const {
  const auto offset = read_decimals(*context_, replicate, "offset", 3);
  return offset ? snap_.lengths(*offset) : model::Vector3{};
}

std::optional<model::Limits> MjcfNumbers::limits(const Element& joint, const std::string& name,
                                                 bool hinge) const {
  const std::string limited = text_of(joint, "limited", "auto");
  if (limited == "false" || (limited == "auto" && !settings_.automatic_limits)) return std::nullopt;
  const auto range = read_decimals(*context_, joint, "range", 2);
  if (!range) return std::nullopt;
  const Decimal &lower = range->front(), &upper = range->back();
  if (limited == "auto" && cln::zerop(lower.value) && cln::zerop(upper.value)) return std::nullopt;
  if (lower.value >= upper.value) {
    context_->error(lower.place, "the range of '" + name + "' is empty: the lower end is not below the upper",
                    "write range=\"lower upper\"");
    return std::nullopt;
  }
  const auto bound = [&](const Decimal& end) {
    return hinge && settings_.degrees ? angle(end) : model::Expression(end.value);
  };
  return model::Limits{bound(lower), bound(upper)};
}

/// The force that all actuators of a joint may have together, if it is as great both ways.
std::optional<model::Expression> MjcfNumbers::greatest_effort(const Element& joint) const {
  if (text_of(joint, "actuatorfrclimited", "auto") == "false") return std::nullopt;
  const auto range = read_decimals(*context_, joint, "actuatorfrcrange", 2);
  if (!range || range->front().value != -range->back().value || !cln::plusp(range->back().value))
    return std::nullopt;
  return range->back().value;
}

model::Drive MjcfNumbers::drive(const Element& joint) const {
  model::Drive drive;
  drive.viscous_friction = read_decimal(*context_, joint, "damping", 0).value;
  drive.coulomb_friction = read_decimal(*context_, joint, "frictionloss", 0).value;
  drive.rotor_inertia = read_decimal(*context_, joint, "armature", 0).value;
  const Decimal stiffness = read_decimal(*context_, joint, "stiffness", 0);
  if (!cln::zerop(stiffness.value))
    context_->warning(stiffness.place, "the spring of a " + joint.name + " is not read",
                      "add its force to what the dynamics gives");
  return drive;
}

model::Motor MjcfNumbers::tendon_motor(const Element& tendon, const std::string& name, bool turns) const {
  model::Motor motor;
  motor.type = turns ? model::JointType::revolute : model::JointType::prismatic;
  motor.variable = name;
  motor.limits = limits(tendon, name, false);
  motor.greatest_effort = greatest_effort(tendon);
  motor.drive = drive(tendon);
  return motor;
}

bool MjcfNumbers::is_hinge(const Element& joint) {
  return text_of(joint, "type", joint.name == "freejoint" ? "free" : "hinge") == "hinge";
}

model::Expression MjcfNumbers::reference(const Element& joint) const {
  const Decimal written = read_decimal(*context_, joint, "ref", 0);
  if (cln::zerop(written.value)) return {};
  return is_hinge(joint) ? angle(written) : model::Expression(written.value);
}

std::optional<tree::Segment> MjcfNumbers::joint(const Element& joint, const std::string& name) const {
  const std::string type = text_of(joint, "type", joint.name == "freejoint" ? "free" : "hinge");
  if (type != "hinge" && type != "slide") {
    context_->error(joint.place, "the joint '" + name + "' is of type " + type,
                    "a chain has hinges and slides: choose --base behind it");
    return std::nullopt;
  }
  tree::MovingJoint moving;
  moving.name = name;
  moving.is_named = joint.attribute("name") != nullptr;
  moving.place = joint.place;
  moving.type = type == "hinge" ? model::JointType::revolute : model::JointType::prismatic;
  moving.axis = model::unit_vector(2);
  if (const auto axis = read_decimals(*context_, joint, "axis", 3);
      axis && !is_zero(*joint.attribute("axis"), *axis, 3))
    moving.axis = snap_.direction(*axis);
  moving.limits = limits(joint, name, type == "hinge");
  moving.greatest_effort = greatest_effort(joint);
  moving.drive = drive(joint);

  tree::Segment segment;
  if (const auto pos = read_decimals(*context_, joint, "pos", 3))
    segment.before.translation = snap_.lengths(*pos);
  segment.after.translation = model::subtract({}, segment.before.translation);
  const model::Expression in_pose = reference(joint);
  if (!in_pose.is_literal_zero()) {
    if (type == "hinge") {
      segment.before.turns.push_back({moving.axis, model::negate(in_pose)});
    } else {
      for (std::size_t i = 0; i < 3; ++i)
        segment.before.translation.at(i) =
            model::subtract(segment.before.translation.at(i), model::multiply(in_pose, moving.axis.at(i)));
    }
  }
  segment.joint = moving;
  return segment;
}

}  // namespace qvgen::description::xml
