// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "report/chain.h"
#include "report/html.h"

namespace qvgen::report {

/// The arm drawn at two poses, its joints as the description has them, Denavit-Hartenberg parameters and
/// class.
Section arm_section(const model::Robot& robot, const Chain& chain);

}  // namespace qvgen::report
