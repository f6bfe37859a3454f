// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "report/html.h"
#include "toolchain/generated.h"

namespace qvgen::report {

/// The arm to be moved by hand, computed by its own generated functions; or what it takes to have that. Those
/// that are generated in C++ alone are compiled with the runtime's sources, if they are given.
Section live_section(const model::Robot& robot, const toolchain::Runtime* runtime);

/// The scripts of that section.
std::string live_script();

}  // namespace qvgen::report
