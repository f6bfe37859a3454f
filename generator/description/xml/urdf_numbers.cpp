// SPDX-License-Identifier: MIT
#include "description/xml/urdf_numbers.h"

#include <algorithm>

#include "description/names.h"
#include "description/xml/urdf_composed.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description::xml {
namespace {

std::string name_of(const Element& element) {
  const Attribute* name = element.attribute("name");
  return name == nullptr ? "" : name->value;
}

/// Turns about the fixed axes x, y, z: R = Rz Ry Rx.
std::vector<model::Turn> roll_pitch_yaw(const std::array<model::Expression, 3>& angles) {
  std::vector<model::Turn> turns;
  for (std::size_t i = 3; i-- > 0;)
    if (!angles.at(i).is_literal_zero()) turns.push_back({model::unit_vector(i), angles.at(i)});
  return turns;
}

void warn_of_children(Context& context, const Element& joint) {
  static const std::vector<std::string> known{
      "origin", "parent", "child", "axis", "calibration", "dynamics", "limit", "mimic", "safety_controller"};
  for (const Element& child : joint.children) {
    if (std::find(known.begin(), known.end(), child.name) != known.end()) continue;
    const std::string near = nearest(child.name, known);
    if (!near.empty())
      context.warning(child.place, "nobody reads <" + child.name + "> of a joint",
                      "did you mean <" + near + ">?");
  }
}

}  // namespace

model::Displacement UrdfNumbers::origin(const Element& parent) const {
  const Element* origin = parent.child("origin");
  if (origin == nullptr) return {};
  warn_of_others(*context_, *origin, {"xyz", "rpy"});
  model::Displacement result;
  if (const auto xyz = read_decimals(*context_, *origin, "xyz", 3)) result.translation = snap_.lengths(*xyz);
  const auto rpy = read_decimals(*context_, *origin, "rpy", 3);
  if (!rpy) return result;
  for (const Decimal& angle : *rpy)
    if (cln::abs(angle.value) > cln::cl_RA(62832) / 10000)
      context_->warning(angle.place, "the angle " + angle.text + " is more than a full turn in radians",
                        "URDF has radians: 90 degrees are 1.5708");
  result.turns = roll_pitch_yaw({snap_.angle((*rpy)[0]), snap_.angle((*rpy)[1]), snap_.angle((*rpy)[2])});
  return result;
}

model::Vector3 UrdfNumbers::axis(const Element& joint) const {
  const Element* axis = joint.child("axis");
  if (axis == nullptr) return model::unit_vector(0);
  warn_of_others(*context_, *axis, {"xyz"});
  const auto xyz = read_decimals(*context_, *axis, "xyz", 3);
  if (!xyz) return model::unit_vector(0);
  if (std::any_of(xyz->begin(), xyz->end(), [](const Decimal& d) { return !cln::zerop(d.value); }))
    return snap_.direction(*xyz);
  context_->error(axis->attribute("xyz")->place, "the axis of '" + name_of(joint) + "' has length zero",
                  "give a direction, e.g. xyz=\"0 0 1\"");
  return model::unit_vector(0);
}

std::optional<model::Limits> UrdfNumbers::limits(const Element& joint, model::JointType type) const {
  const Element* limit = joint.child("limit");
  if (limit == nullptr) {
    context_->warning(joint.place,
                      "the joint '" + name_of(joint) + "' has no <limit>: it is read as unlimited",
                      "add <limit lower=\"...\" upper=\"...\" .../>, or make it continuous");
    return std::nullopt;
  }
  warn_of_others(*context_, *limit, {"lower", "upper", "effort", "velocity"});
  const auto bound = [&](const std::string& key) -> std::optional<Decimal> {
    if (limit->attribute(key) == nullptr) return Decimal{0, 0, 1, limit->place, "0"};
    const auto numbers = read_decimals(*context_, *limit, key, 1);
    return numbers ? std::optional(numbers->front()) : std::nullopt;
  };
  const auto lowest = bound("lower"), highest = bound("upper");
  if (!lowest || !highest) return std::nullopt;
  Decimal lower = *lowest, upper = *highest;
  if (lower.value > upper.value) {
    std::swap(lower, upper);
    context_->warning(upper.place,
                      "the limits of '" + name_of(joint) + "' are reversed: they are read as " + lower.text +
                          " to " + upper.text,
                      "swap lower and upper");
  }
  if (lower.value == upper.value) {
    context_->warning(limit->place,
                      "the limits of '" + name_of(joint) + "' leave it no way: it is read as unlimited",
                      "give lower and upper, or make it fixed");
    return std::nullopt;
  }
  for (const Decimal& end : {lower, upper})
    if (type == model::JointType::revolute && cln::abs(end.value) > 100)
      context_->warning(end.place, "the limit " + end.text + " is many turns in radians",
                        "URDF has radians: 180 degrees are 3.14159");
  return model::Limits{lower.value, upper.value};
}

std::optional<model::Expression> UrdfNumbers::greatest(const Element& joint, const std::string& key) const {
  const Element* limit = joint.child("limit");
  const Attribute* attribute = limit == nullptr ? nullptr : limit->attribute(key);
  if (attribute == nullptr) return std::nullopt;
  Context trial("", "", {});  // a number that nothing of the arm depends on makes no file wrong
  const auto numbers = read_decimals(trial, *attribute);
  if (!numbers || numbers->size() != 1 || cln::minusp(numbers->front().value)) {
    context_->warning(attribute->place, "the " + key + " '" + attribute->value + "' is left out",
                      "write a positive number");
    return std::nullopt;
  }
  // Zero stands where it is not known: what cannot move is fixed.
  if (cln::zerop(numbers->front().value)) return std::nullopt;
  return numbers->front().value;
}

model::Drive UrdfNumbers::drive(const Element& joint) const {
  const Element* dynamics = joint.child("dynamics");
  if (dynamics == nullptr) return {};
  warn_of_others(*context_, *dynamics, {"damping", "friction"});
  model::Drive drive;
  for (const bool viscous : {true, false}) {
    const Decimal value = read_decimal(*context_, *dynamics, viscous ? "damping" : "friction", 0);
    (viscous ? drive.viscous_friction : drive.coulomb_friction) = value.value;
    if (cln::minusp(value.value))
      context_->warning(value.place,
                        "the friction of '" + name_of(joint) + "' is negative: it drives the joint",
                        "give a positive number");
  }
  return drive;
}

tree::MovingJoint UrdfNumbers::moving(const Element& joint, const std::string& type) const {
  tree::MovingJoint result;
  result.name = name_of(joint);
  result.place = joint.place;
  result.type = type == "prismatic" || type == unlimited_slide ? model::JointType::prismatic
                                                               : model::JointType::revolute;
  result.axis = axis(joint);
  if (type != "continuous" && type != unlimited_slide) result.limits = limits(joint, result.type);
  result.greatest_velocity = greatest(joint, "velocity");
  result.greatest_effort = greatest(joint, "effort");
  result.drive = drive(joint);
  result.mimic = mimic(joint, result.type);
  return result;
}

std::optional<tree::Mimic> UrdfNumbers::mimic(const Element& joint, model::JointType type) const {
  const Element* mimic = joint.child("mimic");
  if (mimic == nullptr) return std::nullopt;
  warn_of_others(*context_, *mimic, {"joint", "multiplier", "offset"});
  const Attribute* leader = mimic->attribute("joint");
  if (leader == nullptr) {
    context_->error(mimic->place, "the joint '" + name_of(joint) + "' mimics none",
                    "name the joint that leads: <mimic joint=\"...\"/>");
    return std::nullopt;
  }
  const Decimal ratio = read_decimal(*context_, *mimic, "multiplier", 1);
  const Decimal offset = read_decimal(*context_, *mimic, "offset", 0);
  if (cln::zerop(ratio.value)) {
    context_->error(ratio.place, "with a multiplier of 0 the joint '" + name_of(joint) + "' does not move",
                    "make it fixed");
    return std::nullopt;
  }
  const bool turns = type == model::JointType::revolute;
  return tree::Mimic{{{leader->value, ratio.value}},
                     turns ? snap_.angle(offset) : model::Expression(offset.value),
                     mimic->place};
}

tree::Body UrdfNumbers::body(const Element& link) const {
  const Element* inertial = link.child("inertial");
  if (inertial == nullptr) return {};
  tree::Body body;
  if (const Element* mass = inertial->child("mass")) {
    warn_of_others(*context_, *mass, {"value"});
    body.mass = read_decimal(*context_, *mass, "value", 0).value;
  }
  if (const Element* inertia = inertial->child("inertia")) {
    static const std::vector<std::string> names{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
    static const std::vector<std::string> mirrored{"ixx", "iyx", "izx", "iyy", "izy", "izz"};  // symmetric
    std::vector<std::string> all = names;
    all.insert(all.end(), mirrored.begin(), mirrored.end());
    warn_of_others(*context_, *inertia, all);
    const auto entry = [&](std::size_t i) -> cln::cl_R {
      const Decimal other = read_decimal(*context_, *inertia, mirrored[i], 0);
      const Decimal own = read_decimal(*context_, *inertia, names[i], other.value);
      if (inertia->attribute(mirrored[i]) != nullptr && own.value != other.value)
        context_->warning(other.place, names[i] + " and " + mirrored[i] + " differ: " + own.text + " is read",
                          "the tensor is symmetric");
      return own.value;
    };
    const cln::cl_R xy = entry(1), xz = entry(2), yz = entry(4);
    body.inertia = {tree::Vector{entry(0), xy, xz}, tree::Vector{xy, entry(3), yz},
                    tree::Vector{xz, yz, entry(5)}};
  }
  return moved(origin(*inertial), body);
}

/// Returns what a joint may be in the place of a type that is not read.
static std::string in_place_of(const std::string& type) {
  if (type == "hinge") return "did you mean 'revolute', or 'continuous' without limits?";
  const std::string base =
      "a chain has revolute, continuous, prismatic and fixed joints: choose --base behind it";
  return base + (type == "floating" ? ", or read the whole robot with --floating" : "");
}

std::optional<tree::Segment> UrdfNumbers::segment(const Element& link, const Element& joint) const {
  const std::string type = joint.attribute("type")->value;
  static const std::vector<std::string> types{"revolute", "continuous", "prismatic", "fixed",
                                              unlimited_slide};
  if (std::find(types.begin(), types.end(), type) == types.end()) {
    context_->error(joint.attribute("type")->place, "the joint '" + name_of(joint) + "' is " + type,
                    in_place_of(type));
    return std::nullopt;
  }
  warn_of_children(*context_, joint);
  tree::Segment segment;
  segment.before = origin(joint);
  if (type != "fixed") segment.joint = moving(joint, type);
  segment.body = body(link);
  return segment;
}

}  // namespace qvgen::description::xml
