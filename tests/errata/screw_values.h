// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>

#include "reference/chain.h"
#include "reference/expression.h"
#include "value.h"

namespace qvgen::test::sources {

/// All that the document on Paden-Kahan subproblems names, at one configuration of its arm. `of` is "arm" as
/// it stands, "shifted" by d1 along the turned x axis behind the first joint, which is then where the names
/// e_i and T_1 belong. Exponentials e1, ..., e6 of the screws, points q_i on the axes and points p_i that
/// turns have moved, with "h" before the name as columns of four; a prime is an asterisk. From the
/// reference's axes: none of the printed formulas is used.
Known screw_values(const std::string& of, const reference::Chain& chain, const reference::Values& lengths,
                   const Eigen::VectorXd& q);

/// Subproblem 2 about random axes omega_4, omega_5 through a point: u_4 is turned into v_4, and z, the vector
/// between both turns, has the coefficients alpha, beta, gamma.
Known turned_twice(std::mt19937& engine);

}  // namespace qvgen::test::sources
