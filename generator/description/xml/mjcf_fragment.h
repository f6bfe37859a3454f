// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// A <mujocoinclude>, made for an <include> of another file, as a model of its own; nothing if it is none,
/// which is reported with the models near by that include it.
std::optional<Element> model_of_fragment(Context& context, const Element& root);

}  // namespace qvgen::description::xml
