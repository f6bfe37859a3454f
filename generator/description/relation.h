// SPDX-License-Identifier: MIT
// Relations between joints and motors: "1/2 ml - 1/2 mr + 10 deg".
//
// A relation is linear in the names of joints and motors, with rational factors, and may have a constant. Or
// it is a polynomial of one name, "1/2 ml + 1/5 ml^2", whose powers may be those of a difference, "1/2 ml +
// 1/5 (ml - 10 deg)^3". It is written as expressions are (parser.h); between a number and a name or a bracket
// a blank stands for a product.
#pragma once

#include <optional>

#include "description/context.h"

namespace qvgen::description {

struct Relation {
  model::Follows leaders;     ///< by the names of the text, in the order in which they come
  Entry constant;             ///< in the units of the file
  model::Powers powers = {};  ///< of the only leader, whose factor among the leaders may be 0
};

/// Returns the relation that a text in quotes at `place` states; reports what is wrong with it.
std::optional<Relation> read_relation(Context& context, const std::string& text, Place place);

}  // namespace qvgen::description
