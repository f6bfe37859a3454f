// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "report/html.h"

namespace qvgen::report {

/// Section on where the tool comes to: by samples, and by its boundary where there is a closed form.
Section reach_section(const model::Robot& robot);

}  // namespace qvgen::report
