// SPDX-License-Identifier: MIT
// The values that `qvgen path` moves along a path, with their limits: joints of the description, or the
// motors that move them.
#pragma once

#include <string>
#include <vector>

#include "cli/path_options.h"
#include "model/robot.h"
#include "path/arm_program.h"

namespace qvgen::cli {

/// Joints or motors of an arm that move along a path.
struct Movers {
  std::vector<path::MovingJoint> joints;   ///< or motors
  std::vector<path::MovingJoint> coupled;  ///< joints that follow motors and have limits of their own
  std::vector<std::string> axes;           ///< names of all joints that motors move; empty without motors
};

/// Returns those of an arm, with the limits of the description and of the options. Throws std::runtime_error
/// if a number is missing.
Movers movers_of(const PathArguments& arguments, const model::Robot& robot);

/// Returns the one of a name; throws UsageError with the names that there are.
path::MovingJoint& joint_called(std::vector<path::MovingJoint>& joints, const std::string& option,
                                const std::string& name);

}  // namespace qvgen::cli
