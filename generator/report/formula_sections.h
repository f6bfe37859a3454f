// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/robot.h"
#include "report/html.h"

namespace qvgen::report {

/// What was derived, as mathematics; each says why where there is nothing.
Section forward_section(const model::Robot& robot);
Section inverse_section(const model::Robot& robot);
Section jacobian_section(const model::Robot& robot);
Section dynamics_section(const model::Robot& robot);

}  // namespace qvgen::report
