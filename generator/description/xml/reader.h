// SPDX-License-Identifier: MIT
#pragma once

#include "description/tree/tree.h"
#include "description/xml/element.h"

namespace qvgen::description::xml {

/// <robot>: a URDF. <mujoco>: an MJCF; <mujocoinclude>: a part of one. The chain between the options' base
/// and tip, or the whole tree; mistakes go into the context. The loops of a URDF are told by another file.
model::Mechanism read_urdf(Context& context, const Element& root, const tree::Loops& loops = {});
model::Mechanism read_mjcf(Context& context, const Element& root);

/// A link of a URDF on the way from base to tip.
struct UrdfLink {
  const Element* link;
  const Element* joint;               ///< the one that holds it
  bool moves;                         ///< false: the joint is fixed, or held by the options
  std::vector<const Element*> rigid;  ///< links that hang on it by fixed joints, further ones included
};

/// Returns the links from base (left out) to tip as read_urdf takes them; empty where it reports a mistake.
std::vector<UrdfLink> urdf_chain(Context& context, const Element& root);

}  // namespace qvgen::description::xml
