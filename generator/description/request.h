// SPDX-License-Identifier: MIT
#pragma once

#include "description/document.h"
#include "model/robot.h"

namespace qvgen::description {

/// Reads what the file asks of the inverse kinematics: `task`, `tool_axis`, `given`, `ideal`.
void read_request(const Table& root, model::Robot& robot);

}  // namespace qvgen::description
