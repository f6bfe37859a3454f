// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// True if a <mujoco> has no bodies and models near by include it, which is reported with their names.
bool is_part_of_model(Context& context, const Element& root);

/// A <mujocoinclude>, made for an <include> of another file, as a model of its own; nothing if it is none,
/// which is reported with the models near by that include it.
std::optional<Element> model_of_fragment(Context& context, const Element& root);

}  // namespace qvgen::description::xml
