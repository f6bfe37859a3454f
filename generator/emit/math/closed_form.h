// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/math/notation.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The thesis's half-angle-sum form of the forward kinematics, one line per component ("w = ..."); lines of
/// text are wrapped to fit a comment. Empty where the robot has symbolic twists.
std::vector<std::string> closed_form_lines(const model::Robot& described, Notation notation);

/// The same for people: sums collected, lines that fit, in LaTeX an align* environment.
std::vector<std::string> pose_lines(const model::Robot& robot, Notation notation);

}  // namespace qvgen::emit
