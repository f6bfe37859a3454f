// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/robot.h"
#include "report/html.h"

namespace qvgen::report {

/// Sections with the derived mathematics; each says why if there is none.
Section forward_section(const model::Robot& robot);
Section inverse_section(const model::Robot& robot);
Section jacobian_section(const model::Robot& robot);
Section dynamics_section(const model::Robot& robot);

}  // namespace qvgen::report
