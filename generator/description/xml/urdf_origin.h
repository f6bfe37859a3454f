// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// Place of a joint or a body: m; rad, about the fixed axes x, y, z one after the other.
struct UrdfOrigin {
  std::array<double, 3> xyz{}, rpy{};
};

/// Returns three numbers of an attribute; `otherwise` if the element or the attribute is absent.
std::array<double, 3> read_triple(Context& context, const Element* element, const std::string& key,
                                  const std::array<double, 3>& otherwise);

/// Returns the place that the child <origin> of an element says; zero without one.
UrdfOrigin read_origin(Context& context, const Element& element);

}  // namespace qvgen::description::xml
