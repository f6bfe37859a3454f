// SPDX-License-Identifier: MIT
#pragma once

#include "reference/chain.h"

/// Joint forces by Lagrange's equations, d/dt dL/dq' - dL/dq, from the energies of the links alone: no
/// acceleration of a body and no balance of forces occurs. The derivatives are automatic.
namespace lagrange {

/// `gravity` is the acceleration of free fall. Drives are left out.
Eigen::VectorXd forces(const reference::Chain& chain, const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                       const Eigen::VectorXd& qdd, const Eigen::Vector3d& gravity);

}  // namespace lagrange
