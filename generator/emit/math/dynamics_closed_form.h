// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "dag/graph.h"
#include "model/robot.h"

namespace qvgen::emit {

/// One term of a joint force in the arrangement of the thesis (5.47-5.49): coefficient times accelerations or
/// rates.
struct ForceTerm {
  std::size_t joint = 0;  ///< whose force
  std::string motion;     ///< "theta1''", "theta1'*theta2'", "theta2'^2", or empty for what stands at rest
  dag::Function coefficient;  ///< one output, expanded: even powers of cosines written with sines
};

/// The joint forces written out, zero terms left out. Sizes grow exponentially: std::domain_error beyond
/// three joints.
std::vector<ForceTerm> dynamics_closed_form(const model::Robot& robot);

/// The same as text, a line per term.
std::vector<std::string> dynamics_closed_form_lines(const model::Robot& robot);

}  // namespace qvgen::emit
