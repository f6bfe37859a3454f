// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/math/notation.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The thesis's half-angle-sum form of the forward kinematics as text, one component after the other
/// ("w = ..."), wrapped to fit a comment. Empty where the robot has symbolic twists.
std::vector<std::string> closed_form_lines(const model::Robot& described, Notation notation);

/// Returns the pose's formulas for people, sums collected: one formula a component.
std::vector<std::string> pose_formulas(const model::Robot& robot, Notation notation);

/// These in lines that fit, in LaTeX an align* environment.
std::vector<std::string> pose_lines(const model::Robot& robot, Notation notation);

}  // namespace qvgen::emit
