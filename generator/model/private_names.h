// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/robot.h"

namespace qvgen::model {

/// The robot with names that meet no name of a derivation's own values: every symbol of the geometry is
/// marked with a dot, which no name of a description has, and variables are joint1, joint2, ... unless each
/// is letters and a number, as derivations' own names never are.
Robot with_private_names(const Robot& robot);

/// True if a name is that of a symbol of the geometry, so marked.
bool is_marked(const std::string& name);
/// The name as the description has it.
std::string described_name(const std::string& name);
/// An expression's text with its names so.
std::string without_marks(std::string text);

}  // namespace qvgen::model
