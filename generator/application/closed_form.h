// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/notation.h"
#include "model/robot.h"

namespace qvgen::application {

/// The thesis's half-angle-sum form of the forward kinematics, one line per component ("w = ..."); lines of
/// text are wrapped to fit a comment. Empty where the robot has symbolic twists.
std::vector<std::string> closed_form_lines(const model::Robot& robot, emit::Notation notation);

}  // namespace qvgen::application
