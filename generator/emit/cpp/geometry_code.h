// SPDX-License-Identifier: MIT
#pragma once

#include "dag/graph.h"
#include "emit/cpp/code.h"
#include "emit/cpp/inverse/dialect.h"
#include "model/robot.h"

namespace qvgen::emit {

/// A function of the geometry alone; sines of its angles are computed where they stand.
Code geometry_code(const model::Robot& robot, const dag::Function& function, const Spelling& spelling);
Code geometry_code(const model::Robot& robot, const dag::Function& function,
                   const Dialect& dialect = cpp_dialect());

}  // namespace qvgen::emit
