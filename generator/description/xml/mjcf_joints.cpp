// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_joints.h"

#include <algorithm>

#include "description/xml/decimals.h"

namespace qvgen::description::xml {
namespace {

std::string type_of(const Element& joint) {
  const Attribute* type = joint.attribute("type");
  return joint.name == "freejoint" ? "free" : type == nullptr ? "hinge" : type->value;
}

/// Attributes that act about each axis of the body that a ball moves; no turn about a moved axis has them.
const std::vector<std::string>& isotropic() {
  static const std::vector<std::string> keys{"damping", "frictionloss", "armature", "stiffness"};
  return keys;
}

/// The turn about one coordinate axis: R = Rx Ry Rz.
Element turn(const Element& ball, std::size_t axis) {
  static const std::vector<std::string> kept{"pos", "group"};
  static const std::array<const char*, 3> axes{"1 0 0", "0 1 0", "0 0 1"};
  Element result{ball.name, ball.place, {}, {}};
  std::copy_if(ball.attributes.begin(), ball.attributes.end(), std::back_inserter(result.attributes),
               [&](const Attribute& a) { return std::find(kept.begin(), kept.end(), a.name) != kept.end(); });
  result.attributes.push_back({"axis", axes.at(axis), ball.place});
  return result;
}

}  // namespace

bool is_free(const Element& completed) { return type_of(completed) == "free"; }

std::vector<MjcfJoint> joints_of(Context& context, const Placed& joint, const std::string& otherwise) {
  const Element complete = joint.element->name == "joint" ? joint.completed(context) : *joint.element;
  const std::string own = joint.name();
  const std::string name = own.empty() ? otherwise : own;
  if (is_free(complete)) return {};
  if (type_of(complete) != "ball") return {{complete, joint, name, false}};
  std::vector<MjcfJoint> turns;
  for (std::size_t axis = 0; axis < 3; ++axis)
    turns.push_back({turn(complete, axis), joint, name + "_" + "xyz"[axis], axis == 0});
  return turns;
}

void tell_of_ball(Context& context, const MjcfJoint& joint) {
  const Element complete = joint.placed.completed(context);
  const std::string name = joint.name.substr(0, joint.name.size() - 2);
  context.note(complete.place,
               "the ball joint '" + name + "' is read as three turns, " + name + "_x, " + name + "_y and " +
                   name + "_z, each about an axis that the one before has turned",
               "with the second at 90 or -90 degrees they lack one of its motions");
  const Attribute* range = complete.attribute("range");
  const Attribute* limited = complete.attribute("limited");
  if (range != nullptr && (limited == nullptr || limited->value != "false"))
    context.warning(range->place,
                    "the range of a ball joint is not read: it limits the angle of all three turns together",
                    "give the three turns as hinges with ranges of their own");
  for (const std::string& key : isotropic())
    if (!cln::zerop(read_decimal(context, complete, key, 0).value))
      context.warning(complete.attribute(key)->place, "'" + key + "' of a ball joint is not read",
                      "add its moment, which is about the axes of the body, to what the dynamics gives");
}

}  // namespace qvgen::description::xml
