// SPDX-License-Identifier: MIT
#include "description/xml/urdf_planar.h"

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

}  // namespace

std::deque<Element> successive_joints(Context& context, const Element& planar) {
  const Attribute* named = planar.attribute("name");
  const std::string name = named == nullptr ? "" : named->value;
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
  std::deque<Element> made{
      with("link", planar.place, {{"name", called(first), planar.place}}),
      joint(planar, called(first), unlimited_slide, link_of(planar, "parent"), called(first),
            directions.at(first)),
      with("link", planar.place, {{"name", called(second), planar.place}}),
      joint(planar, called(second), unlimited_slide, called(first), called(second), directions.at(second)),
      joint(planar, called(normal->axis), "continuous", called(second), link_of(planar, "child"),
            turns.at(normal->axis))};
  if (const Element* origin = planar.child("origin")) made[1].children.push_back(*origin);
  return made;
}

}  // namespace qvgen::description::xml
