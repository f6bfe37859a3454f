// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "report/html.h"

namespace qvgen::report {

/// The arm to be moved by hand, computed by its own generated functions; or what it takes to have that.
Section live_section(const model::Robot& robot);

/// The scripts of that section.
std::string live_script();

}  // namespace qvgen::report
