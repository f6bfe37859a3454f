// SPDX-License-Identifier: MIT
#pragma once

#include "description/tree/rigid.h"
#include "description/xml/mjcf_contents.h"

namespace qvgen::description::xml {

/// The numbers of the frames around elements of bodies, each read once.
class MjcfFrames {
 public:
  MjcfFrames(Context& context, const SnapOptions& snap) : context_(&context), snap_(snap) {}
  /// From the body's frame to the innermost frame around the element.
  [[nodiscard]] model::Displacement around(const std::shared_ptr<const Around>& frame);
  /// Returns the element's place in its body: the frames around it, then its own.
  [[nodiscard]] model::Displacement frame(const Placed& placed);

 private:
  [[nodiscard]] model::Displacement own(const Around& frame);
  [[nodiscard]] model::Displacement copy(const Around& frame);

  Context* context_;
  SnapOptions snap_;
  std::map<std::shared_ptr<const Around>, model::Displacement> known_;
  std::map<const Element*, std::vector<model::Vector3>> offsets_;  ///< of the copies of a <replicate>
};

}  // namespace qvgen::description::xml
