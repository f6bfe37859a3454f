// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "dag/graph.h"
#include "emit/math/notation.h"
#include "model/robot.h"

namespace qvgen::emit {

/// One term of a joint force in the arrangement of the thesis (5.47-5.49): coefficient times accelerations or
/// rates.
struct ForceTerm {
  std::size_t joint = 0;  ///< whose force
  std::string motion;     ///< "theta1''", "theta1'*theta2'", "theta2'^2", or empty for what stands at rest
  dag::Function coefficient;  ///< one output, what its terms have in common taken out
};

/// The joint forces written out, zero terms left out. Sizes grow exponentially: std::domain_error beyond
/// three joints.
std::vector<ForceTerm> dynamics_closed_form(const model::Robot& robot);

/// theta1'*theta2' as it is, or \dot{\theta_1} \dot{\theta_2}.
std::string motion_formula(const std::string& motion, Notation notation);

/// Returns the closed form as text or an align* environment, a term a line or more.
std::vector<std::string> dynamics_closed_form_lines(const model::Robot& robot, Notation notation);

}  // namespace qvgen::emit
