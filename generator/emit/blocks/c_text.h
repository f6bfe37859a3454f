// SPDX-License-Identifier: MIT
// Prints definitions of a unit in C. Operators keep their order and grouping, and so every bit. Comments have
// no letter beyond ASCII.
#pragma once

#include <string>

#include "emit/blocks/unit.h"

namespace qvgen::emit::blocks {

/// Name of the function that makes a struct of its fields: "Rotor" -> "rotor".
std::string snake(const std::string& name);

std::string c_text(const Unit& unit, const Structure& structure);
std::string c_text(const Unit& unit, const Constant& constant);
std::string c_text(const Unit& unit, const Function& function);

}  // namespace qvgen::emit::blocks
