// SPDX-License-Identifier: MIT
// Limits of joint forces for the least time along a path: the description's, or those of an option.
#pragma once

#include "cli/path_options.h"
#include "model/robot.h"
#include "path/arm_program.h"

namespace qvgen::cli {

/// Sets the largest force of each joint, as --joint-torques wants it. Throws UsageError for numbers that are
/// not one for all or one for each, std::runtime_error for a robot without masses or limits.
void set_forces(const PathArguments& arguments, const model::Robot& robot,
                std::vector<path::MovingJoint>& joints);

/// Returns one number for each joint, from as many or from one; throws UsageError.
std::vector<double> for_each_joint(const std::string& option, const std::vector<double>& numbers,
                                   std::size_t count);

}  // namespace qvgen::cli
