// SPDX-License-Identifier: MIT
#include "description/xml/urdf_spheres.h"

#include <algorithm>
#include <map>

#include "description/xml/decimals.h"
#include "description/xml/reader.h"
#include "description/xml/urdf_composed.h"

namespace qvgen::description::xml {
namespace {

std::string attribute_of(const Element* element, const char* key) {
  const Attribute* found = element == nullptr ? nullptr : element->attribute(key);
  return found == nullptr ? "" : found->value;
}

class Spheres {
 public:
  Spheres(Context& context, const Element& root) : context_(context) {
    for (const Element& each : root.children)
      if (each.name == "joint") joints_[attribute_of(each.child("child"), "link")] = &each;
    std::size_t moving = 0;
    for (const UrdfLink& link : urdf_chain(context, root)) {
      if (moving_.empty()) moving_[attribute_of(link.joint->child("parent"), "link")] = 0;
      if (link.moves) moving_[attribute_of(link.link, "name")] = moving += freedoms(*link.joint);
    }
  }

  void add(const Element& link, std::vector<UrdfSphere>& to) {
    const auto place = place_of(attribute_of(&link, "name"));
    if (!place) return;
    for (const Element& collision : link.children) {
      if (collision.name != "collision") continue;
      const Element* geometry = collision.child("geometry");
      const Element* sphere = geometry == nullptr ? nullptr : geometry->child("sphere");
      if (sphere == nullptr) continue;
      to.push_back(*place);
      to.back().ways.push_back(read_origin(context_, collision));
      to.back().radius = cln::double_approx(read_decimal(context_, *sphere, "radius", 0).value);
    }
  }

 private:
  static std::size_t freedoms(const Element& joint) { return is_composed(joint) ? 3 : 1; }

  [[nodiscard]] bool holds(const Element& joint) const {
    const auto& fixed = context_.options.fixed;
    return attribute_of(&joint, "type") == "fixed" ||
           std::find(fixed.begin(), fixed.end(), attribute_of(&joint, "name")) != fixed.end();
  }

  /// Returns the moving link that a link is fixed to, and the way to it; nothing beside the chain.
  [[nodiscard]] std::optional<UrdfSphere> place_of(std::string link) const {
    UrdfSphere result;
    for (std::size_t steps = 0; steps <= joints_.size(); ++steps) {
      if (const auto moving = moving_.find(link); moving != moving_.end()) {
        result.joints = moving->second;
        return result;
      }
      const auto joint = joints_.find(link);
      if (joint == joints_.end() || !holds(*joint->second)) return std::nullopt;
      result.ways.insert(result.ways.begin(), read_origin(context_, *joint->second));
      link = attribute_of(joint->second->child("parent"), "link");
    }
    return std::nullopt;
  }

  Context& context_;
  std::map<std::string, const Element*> joints_;  ///< by the link that they hold
  std::map<std::string, std::size_t>
      moving_;  ///< moving links of the chain and its base, by joints before them
};

}  // namespace

std::vector<UrdfSphere> urdf_spheres(const std::string& text, const ReadOptions& options) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || text[begin] != '<') return {};
  Context context(text, "", options);
  const auto root = parse(context, text);
  if (!root || root->name != "robot") return {};
  Spheres spheres(context, *root);
  std::vector<UrdfSphere> result;
  for (const Element& each : root->children)
    if (each.name == "link") spheres.add(each, result);
  return result;
}

}  // namespace qvgen::description::xml
