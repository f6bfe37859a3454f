// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// The attributes that elements of an MJCF's classes have where they do not give them themselves.
class MjcfDefaults {
 public:
  MjcfDefaults() = default;
  /// Reads every <default> of the file.
  MjcfDefaults(Context& context, const Element& root);
  /// Returns a joint, geom, site or mesh with everything that it inherits; `childclass` is that of the bodies
  /// and frames around it, or empty.
  [[nodiscard]] Element completed(Context& context, const Element& element,
                                  const std::string& childclass) const;

 private:
  using Attributes = std::vector<Attribute>;
  using Class = std::map<std::string, Attributes>;  ///< by the elements' name
  void read(Context& context, const Element& defaults, const Class& inherited, bool outermost);

  std::map<std::string, Class> classes_;
  std::string main_ = "main";
};

}  // namespace qvgen::description::xml
