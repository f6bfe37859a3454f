// SPDX-License-Identifier: MIT
#pragma once

#include "reference/chain.h"
#include "reference/expression.h"
#include "value.h"

namespace qvgen::test::sources {

/// All that chapters 3 and 4 of the thesis name, at one configuration of an arm with a wrist: the pairs Q_i
/// of the links, their product Q_16 with its parts s_16, v_i16, ..., p_z16; the products M_i = Q_i ... Q_6
/// and N_i = Q_i-1^-1 ... Q_1^-1 N_1 with their seven components M_i1 ... M_i7; the pose w, a, b, c, p_x,
/// p_y, p_z; lengths and joints. From the reference's frames: none of the printed formulas is
/// used.
Known arm_values(const reference::Chain& chain, const reference::Values& lengths, const Eigen::VectorXd& q);

}  // namespace qvgen::test::sources
