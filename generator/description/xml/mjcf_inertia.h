// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/mjcf_geoms.h"

namespace qvgen::description::xml {

/// The inertia of an MJCF's bodies, from <inertial> or from geoms, with the bounds of <compiler>, as MuJoCo
/// has it.
class MjcfInertia {
 public:
  explicit MjcfInertia(Context& context) : context_(&context), geoms_(context) {}
  /// In the body's frame.
  [[nodiscard]] tree::Body of(const Placed& body, const std::vector<Placed>& contents);

 private:
  [[nodiscard]] tree::Body given(const Placed& inertial) const;
  /// Without <inertial> and geoms.
  [[nodiscard]] tree::Body none(const Placed& body) const;
  /// Nothing if no geom counts.
  [[nodiscard]] std::optional<tree::Body> from_geoms(const Placed& body, const std::vector<Placed>& contents);

  Context* context_;
  MjcfGeoms geoms_;
};

}  // namespace qvgen::description::xml
