// SPDX-License-Identifier: MIT
#pragma once

#include "emit/code.h"
#include "model/robot.h"

namespace qvgen::emit {

/// A function of the geometry alone; sines of its angles are computed where they stand.
ast::Straight geometry_tree(const model::Robot& robot, const dag::Function& function);
Code geometry_code(const model::Robot& robot, const dag::Function& function, const ast::Printer& language);

}  // namespace qvgen::emit
