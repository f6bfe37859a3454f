// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "model/robot.h"
#include "report/chain.h"
#include "report/html.h"
#include "toolchain/generated.h"

namespace qvgen::report {

/// The arm to be moved by hand, computed by its own generated functions; or what it takes to have that. Those
/// that are generated in C++ alone are compiled with the runtime's sources, if they are given.
Section live_section(const model::Robot& robot, const toolchain::Runtime* runtime);

/// Returns an arm as the scripts draw it: its frames, the joints that are moved with their ranges, and its
/// size.
nlohmann::json chain_data(const Chain& chain);

/// The scripts that draw an arm.
std::string drawing_script();

/// The scripts of that section.
std::string live_script();

}  // namespace qvgen::report
