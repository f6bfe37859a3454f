// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "application/inverse/lower.h"
#include "model/robot.h"

namespace qvgen::application {

/// Where generated code has a joint's value: "q[2]".
std::string joint_place(int joint);

/// Assignments of the joints' values that a step leaves in `work`, angles by their arctangent.
std::vector<std::string> joint_lines(const model::Robot& robot, const LoweredPlan& plan,
                                     const derive::inverse::Step& step, const std::string& work = "w");

/// Call of a step's function; `sign` is empty for a step with one branch.
std::string step_call(const LoweredPlan& plan, std::size_t index, const std::string& sign,
                      const std::string& work = "w", const std::string& target = "t");

}  // namespace qvgen::application
