// SPDX-License-Identifier: MIT
// Equations of the loops as functions of all joints, for rates and dynamics: what each closure leaves open
// (m), its derivative by every joint, and the part of its second derivative by time that rates alone make.
#pragma once

#include "derive/loops/assembly_plan.h"

namespace qvgen::derive::loops {

/// Programs in the symbols cos_x, sin_x or x of the joints, rate_x of their rates, and the geometry.
struct Constraints {
  std::size_t rows = 0;        ///< of the closures that the plan uses, as many as there are passive joints
  symbolic::Program gap;       ///< row by row, then those of redundant closures
  symbolic::Program jacobian;  ///< rows times joints, row by row
  symbolic::Program bias;      ///< row by row
  std::size_t redundant_rows = 0;
};

/// Returns the equations of a plan's closures, and those of all closures, solved or not; `robot` has private
/// names.
Constraints constraints_of(const AssemblyPlan& assembly);
Constraints constraints_of(const model::Robot& robot, const std::vector<Cycle>& cycles);

}  // namespace qvgen::derive::loops
