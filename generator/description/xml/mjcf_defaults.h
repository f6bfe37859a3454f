// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// The attributes that joints of an MJCF's classes have where they do not give them themselves.
class JointDefaults {
 public:
  JointDefaults(Context& context, const Element& root);
  /// The joint with everything that it inherits; `childclass` is that of the bodies around it, or empty.
  [[nodiscard]] Element completed(const Element& joint, const std::string& childclass) const;

 private:
  using Attributes = std::vector<Attribute>;
  void read(const Element& defaults, const Attributes& inherited, bool outermost);

  Context* context_;
  std::map<std::string, Attributes> classes_;
  std::string main_ = "main";
};

}  // namespace qvgen::description::xml
