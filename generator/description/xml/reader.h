// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// <robot>: a URDF. <mujoco>: an MJCF; <mujocoinclude>: a part of one. The chain between the options' base
/// and tip; mistakes go into the context.
model::Robot read_urdf(Context& context, const Element& root);
model::Robot read_mjcf(Context& context, const Element& root);

}  // namespace qvgen::description::xml
