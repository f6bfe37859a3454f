// SPDX-License-Identifier: MIT
#include "description/xml/urdf_composed.h"

#include <algorithm>
#include <array>
#include <optional>

#include "description/xml/decimals.h"

namespace qvgen::description::xml {
namespace {

constexpr std::array<const char*, 3> directions{"1 0 0", "0 1 0", "0 0 1"};
constexpr std::array<const char*, 3> opposite{"-1 0 0", "0 -1 0", "0 0 -1"};

struct Normal {
  std::size_t axis = 0;
  bool reversed = false;
};

/// URDF's usual axis is x.
std::optional<Normal> normal_of(Context& context, const Element& planar) {
  const Element* axis = planar.child("axis");
  if (axis == nullptr) return Normal{};
  const auto xyz = read_decimals(context, *axis, "xyz", 3);
  if (!xyz) return Normal{};
  std::optional<Normal> result;
  for (std::size_t k = 0; k < 3; ++k) {
    if (cln::zerop((*xyz)[k].value)) continue;
    if (result) return std::nullopt;
    result = Normal{k, cln::minusp((*xyz)[k].value)};
  }
  return result;
}

Element with(const char* name, Place place, std::vector<Attribute> attributes) {
  return {name, place, std::move(attributes), {}};
}

Element joint(const Element& planar, const std::string& name, const std::string& type,
              const std::string& parent, const std::string& child, const std::string& axis) {
  const Place place = planar.place;
  Element result = with("joint", place, {{"name", name, place}, {"type", type, place}});
  result.children = {with("parent", place, {{"link", parent, place}}),
                     with("child", place, {{"link", child, place}}),
                     with("axis", place, {{"xyz", axis, place}})};
  return result;
}

std::string link_of(const Element& planar, const char* end) {
  const Element* element = planar.child(end);
  const Attribute* link = element == nullptr ? nullptr : element->attribute("link");
  return link == nullptr ? "" : link->value;
}

/// The parts of a composed joint, along or about `axes` and named by `letters`.
std::deque<Element> parts_of(const Element& composed, const std::string& name,
                             const std::array<std::size_t, 3>& letters, const char* slides_or_turns,
                             const std::array<const char*, 3>& axes) {
  const auto called = [&](std::size_t part) { return name + "_" + "xyz"[letters.at(part)]; };
  std::deque<Element> made{
      with("link", composed.place, {{"name", called(0), composed.place}}),
      joint(composed, called(0), slides_or_turns, link_of(composed, "parent"), called(0), axes[0]),
      with("link", composed.place, {{"name", called(1), composed.place}}),
      joint(composed, called(1), slides_or_turns, called(0), called(1), axes[1]),
      joint(composed, called(2), "continuous", called(1), link_of(composed, "child"), axes[2])};
  if (const Element* origin = composed.child("origin")) made[1].children.push_back(*origin);
  return made;
}

std::string type_of(const Element& joint) {
  const Attribute* type = joint.attribute("type");
  return type == nullptr ? "" : type->value;
}

/// Says what a spherical joint is read as, and what of it is not read.
std::deque<Element> turns_of(Context& context, const Element& ball, const std::string& name) {
  context.note(ball.place,
               "the spherical joint '" + name + "' is read as three turns, " + name + "_x, " + name +
                   "_y and " + name + "_z, each about an axis that the one before has turned",
               "they have no limits; with the second at 90 or -90 degrees they lack one of its motions");
  for (const char* key : {"limit", "dynamics", "mimic"})
    if (const Element* child = ball.child(key))
      context.warning(child->place, "<" + std::string(key) + "> of a spherical joint is not read",
                      "write three continuous or revolute joints, each with its own");
  return parts_of(ball, name, {0, 1, 2}, "continuous", directions);
}

}  // namespace

bool is_composed(const Element& joint) { return type_of(joint) == "planar" || type_of(joint) == "spherical"; }

std::deque<Element> successive_joints(Context& context, const Element& planar) {
  const Attribute* named = planar.attribute("name");
  const std::string name = named == nullptr ? "" : named->value;
  if (type_of(planar) == "spherical") return turns_of(context, planar, name);
  const auto normal = normal_of(context, planar);
  if (!normal) {
    context.error(
        planar.place, "the normal of the planar joint '" + name + "' is no coordinate axis",
        "turn the joint's frame by <origin rpy=\"...\"/> so that <axis xyz=\"0 0 1\"/> is its normal");
    return {};
  }
  const std::size_t first = (normal->axis + 1) % 3, second = (normal->axis + 2) % 3;
  const auto called = [&](std::size_t axis) { return name + "_" + "xyz"[axis]; };
  const auto& turns = normal->reversed ? opposite : directions;
  context.note(planar.place,
               "the planar joint '" + name + "' is read as two slides, " + called(first) + " and " +
                   called(second) + ", and a turn, " + called(normal->axis),
               "they have no limits");
  return parts_of(planar, name, {first, second, normal->axis}, unlimited_slide,
                  {directions.at(first), directions.at(second), turns.at(normal->axis)});
}

}  // namespace qvgen::description::xml
