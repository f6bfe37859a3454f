// SPDX-License-Identifier: MIT
// Laws of the matrix of Coriolis forces of a robot whose base floats. Its velocities cannot be integrated to
// coordinates, so Christoffel symbols do not exist. The matrix must obey what it is for: C v are the forces
// of velocities, and M' - 2 C is skew-symmetric.
#pragma once

#include <vector>

#include "exact/point.h"
#include "model/robot.h"

namespace qvgen::optimise {

/// Returns the residuals of both laws: C v less the forces of velocities, and u C u less half of the rate of
/// u M u, for a random u, the accelerations at the point. `values`: the matrix, row by row.
std::vector<exact::Number> residuals_of_coriolis_laws(const model::Robot& robot,
                                                      const exact::ExactPoint& point,
                                                      const std::vector<exact::Number>& values);

}  // namespace qvgen::optimise
