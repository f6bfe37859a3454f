// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/element.h"
#include "model/mechanism.h"

namespace qvgen::description::xml {

/// <robot>: a URDF. <mujoco>: an MJCF; <mujocoinclude>: a part of one. The chain between the options' base
/// and tip, or the whole tree; mistakes go into the context.
model::Mechanism read_urdf(Context& context, const Element& root);
model::Mechanism read_mjcf(Context& context, const Element& root);

}  // namespace qvgen::description::xml
