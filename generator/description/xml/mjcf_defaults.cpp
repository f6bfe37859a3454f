// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_defaults.h"

#include <algorithm>

#include "description/names.h"

namespace qvgen::description::xml {
namespace {

/// Those of the second win.
std::vector<Attribute> merged(std::vector<Attribute> attributes, const std::vector<Attribute>& over) {
  for (const Attribute& attribute : over) {
    const auto same = std::find_if(attributes.begin(), attributes.end(),
                                   [&](const Attribute& other) { return other.name == attribute.name; });
    if (same == attributes.end())
      attributes.push_back(attribute);
    else
      *same = attribute;
  }
  return attributes;
}

}  // namespace

JointDefaults::JointDefaults(Context& context, const Element& root) : context_(&context) {
  for (const Element& child : root.children)
    if (child.name == "default") read(child, {}, true);
  classes_.try_emplace(main_);
}

void JointDefaults::read(const Element& defaults, const Attributes& inherited, bool outermost) {
  const Attribute* name = defaults.attribute("class");
  if (name == nullptr && !outermost) {
    context_->error(defaults.place, "a <default> within another without 'class'", "add class=\"...\"");
    return;
  }
  Attributes attributes = inherited;
  for (const Element& child : defaults.children)
    if (child.name == "joint") attributes = merged(std::move(attributes), child.attributes);
  if (outermost) main_ = name == nullptr ? "main" : name->value;
  classes_[outermost ? main_ : name->value] = attributes;
  for (const Element& child : defaults.children)
    if (child.name == "default") read(child, attributes, false);
}

Element JointDefaults::completed(const Element& joint, const std::string& childclass) const {
  const Attribute* own = joint.attribute("class");
  const std::string name = own != nullptr ? own->value : childclass.empty() ? main_ : childclass;
  Element result = joint;
  const auto found = classes_.find(name);
  if (found != classes_.end()) {
    result.attributes = merged(found->second, joint.attributes);
  } else {
    std::vector<std::string> names;
    for (const auto& entry : classes_) names.push_back(entry.first);
    const std::string near = nearest(name, names);
    context_->error(own == nullptr ? joint.place : own->place, "there is no default class '" + name + "'",
                    near.empty() ? "add <default class=\"" + name + "\">" : "did you mean '" + near + "'?");
  }
  return result;
}

}  // namespace qvgen::description::xml
