// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/dynamics/formulation.h"

namespace qvgen::derive::dynamics {

/// Joint forces, behind the wrench on a floating base, as a linear function of the base parameters, tau = Y
/// b, all inertias free.
struct Regressor {
  Formulation formulation;  ///< outputs y<row>_<column>: Y(q, q', q''), constants of the geometry and gravity
  dag::Function base_parameters;   ///< outputs b1 ...: b in standard parameters (linear) and geometry
  std::vector<std::string> names;  ///< of the base parameters: "Sxx2" (second moment), "hx2", "m3"; link
                                   ///< numbers from 1, floating base 0
};

/// Differentiates the inverse dynamics by every base parameter. Parameters that no joint force depends on (of
/// the first links) are left out; those that stay are independent if regroup() has found all dependencies,
/// which tests confirm.
Regressor regressor(const model::Robot& robot);

}  // namespace qvgen::derive::dynamics
