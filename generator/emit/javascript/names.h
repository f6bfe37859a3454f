// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "emit/blocks/unit.h"

/// Names of C in JavaScript's habits: what a module exports is in camelCase without the robot's name, types
/// begin with a capital; what it does not export keeps the name that it has in C.
namespace qvgen::emit::javascript {

/// "by_position" -> "byPosition".
std::string camel(const std::string& name);
std::string function_name(const blocks::Unit& unit, const blocks::Function& function);
std::string constant_name(const blocks::Unit& unit, const blocks::Constant& constant);
std::string type_name(const blocks::Unit& unit, const std::string& structure);
/// A field; those of a description's constants keep their names.
std::string field_name(const blocks::Structure& structure, const std::string& field);
/// A variable; a word of the language gets an underscore.
std::string value_name(const std::string& name);

}  // namespace qvgen::emit::javascript
