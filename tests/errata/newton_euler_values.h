// SPDX-License-Identifier: MIT
#pragma once

#include "reference/chain.h"
#include "reference/expression.h"
#include "value.h"

namespace qvgen::test::sources {

/// All that chapter 5 of the thesis names, of one arm in one state of motion: quaternions q_i, origins P_i
/// and centres of mass P_Ci, velocities omega_i, accelerations omega_i', v_i' and v_Ci' (gravity among them),
/// forces F_i, f_i, moments N_i, n_i, torques tau_i, their components in the link's frame, axes R_i and X_i,
/// Y_i, Z_i, tensors I_i. By the recursion in the base frame, turned into the links' frames at the end: the
/// printed one is in the links' frames.
Known newton_euler_values(const reference::Chain& chain, const reference::Values& constants,
                          const Eigen::VectorXd& q, const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd);

}  // namespace qvgen::test::sources
