// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "model/robot.h"
#include "report/chain.h"
#include "report/html.h"
#include "report/live_functions.h"
#include "toolchain/generated.h"

namespace qvgen::report {

/// An arm for the scripts that move it, with its functions. If there is nothing, `lacking` says why.
struct LiveArm {
  nlohmann::json data;
  InverseCall inverse;
  CppFunctions more;
  std::string lacking;
};
LiveArm live_arm(const model::Robot& robot, const toolchain::Runtime* runtime);

/// A section that says why it moves nothing.
Section still_section(const std::string& reason);

/// The arm to be moved by hand, computed by its own generated functions; or what it takes to have that. Those
/// that are generated in C++ alone are compiled with the runtime's sources, if they are given.
Section live_section(const model::Robot& robot, const toolchain::Runtime* runtime);

/// Returns an arm as the scripts draw it: its frames, the joints that are moved with their ranges, and its
/// size.
nlohmann::json chain_data(const Chain& chain);
nlohmann::json motion_data(const Motion& motion);

/// The scripts that draw an arm.
std::string drawing_script();

/// The scripts of that section, those of a whole robot's (whole_page.h), and those of a mechanism's with
/// loops (loop_page.h).
std::string live_script();
std::string whole_script();
std::string loop_script();

}  // namespace qvgen::report
