// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_defaults.h"

#include <algorithm>

#include "description/names.h"

namespace qvgen::description::xml {
namespace {

bool is_orientation(const Attribute& attribute) {
  static const std::vector<std::string> keys{"quat", "axisangle", "xyaxes", "zaxis", "euler"};
  return std::find(keys.begin(), keys.end(), attribute.name) != keys.end();
}

/// Those of the second win; an orientation replaces one that is written in another way.
std::vector<Attribute> merged(std::vector<Attribute> attributes, const std::vector<Attribute>& over) {
  if (std::any_of(over.begin(), over.end(), is_orientation))
    attributes.erase(std::remove_if(attributes.begin(), attributes.end(), is_orientation), attributes.end());
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

MjcfDefaults::MjcfDefaults(Context& context, const Element& root) {
  for (const Element& child : root.children)
    if (child.name == "default") read(context, child, classes_[main_], true);
  classes_.try_emplace(main_);
}

void MjcfDefaults::read(Context& context, const Element& defaults, const Class& inherited, bool outermost) {
  const Attribute* name = defaults.attribute("class");
  if (name == nullptr && !outermost) {
    context.error(defaults.place, "a <default> within another without 'class'", "add class=\"...\"");
    return;
  }
  Class attributes = inherited;
  for (const Element& child : defaults.children)
    if (child.name != "default")
      attributes[child.name] = merged(std::move(attributes[child.name]), child.attributes);
  if (outermost && name != nullptr) main_ = name->value;
  classes_[outermost ? main_ : name->value] = attributes;
  for (const Element& child : defaults.children)
    if (child.name == "default") read(context, child, attributes, false);
}

Element MjcfDefaults::completed(Context& context, const Element& element,
                                const std::string& childclass) const {
  const Attribute* own = element.attribute("class");
  const std::string name = own != nullptr ? own->value : childclass.empty() ? main_ : childclass;
  Element result = element;
  const auto found = classes_.find(name);
  if (found != classes_.end()) {
    const auto attributes = found->second.find(element.name);
    if (attributes != found->second.end()) result.attributes = merged(attributes->second, element.attributes);
  } else {
    std::vector<std::string> names;
    for (const auto& entry : classes_) names.push_back(entry.first);
    const std::string near = nearest(name, names);
    context.error(own == nullptr ? element.place : own->place, "there is no default class '" + name + "'",
                  near.empty() ? "add <default class=\"" + name + "\">" : "did you mean '" + near + "'?");
  }
  return result;
}

}  // namespace qvgen::description::xml
