// SPDX-License-Identifier: MIT
#pragma once

#include "emit/cpp/code.h"
#include "model/robot.h"

namespace qvgen::emit {

/// A function of the geometry alone; sines of its angles are computed where they stand.
Code geometry_code(const model::Robot& robot, const dag::Function& function,
                   const ast::Printer& language = cpp());

}  // namespace qvgen::emit
