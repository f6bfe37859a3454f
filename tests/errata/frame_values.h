// SPDX-License-Identifier: MIT
#pragma once

#include "reference/chain.h"
#include "reference/expression.h"
#include "value.h"

namespace qvgen::test::sources {

/// All that the Jacobian lecture names, of an arm in motion, the tool's frame being the one after the last
/// link's: T_ij, R_ij and P_ij from frame i to frame j, Z_0i the axis of joint i, omega_ij and v_ij the
/// velocities of frame j written in frame i, J_0v and J_0w the halves of the Jacobian J_0 at the tool, J_0xy
/// and J_0p its rows that a planar arm has (v_x, v_y, and omega_z), J_nxy those in the tool's frame n. From
/// the reference's frames and Jacobian.
Known frame_values(const reference::Chain& chain, const reference::Values& lengths, const Eigen::VectorXd& q,
                   const Eigen::VectorXd& qd);

}  // namespace qvgen::test::sources
