// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "emit/math/notation.h"
#include "model/robot.h"

namespace qvgen::emit {

/// How a link moves, in its own frame: its angular velocity, the velocity of its frame's origin. Formulas in
/// the joints' rates; where that is too long to be read, in the components for the link before it.
struct LinkVelocity {
  std::string link;  ///< "1", "2", ...; a tool that is not the last link's frame counts as one more
  std::array<std::string, 3> angular;
  std::array<std::string, 3> linear;
};

/// The velocities of the links one from the other, as the Jacobian lecture has them (section 5.4, iterative
/// method): omega_i = R_i^T omega_(i-1) + z_i q_i', v_i = R_i^T (v_(i-1) + omega_(i-1) x P_i) + s_i q_i'.
/// Certified: the tool's, turned into the base frame, are those of the plain product of the joints' pairs,
/// differentiated.
std::vector<LinkVelocity> link_velocities(const model::Robot& described, Notation notation);

/// "omega_2x": what a component is called in the formulas of the next link.
std::string component_name(const std::string& vector, const std::string& link, std::size_t component);

/// theta1' or \dot{\theta_{1}}
std::string rate_text(const std::string& variable, Notation notation);

}  // namespace qvgen::emit
