// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "canonical/arm.h"
#include "optimise/optimise.h"

namespace qvgen::optimise {

/// Forward kinematics of a canonical arm, and that arm.
struct Pose {
  canonical::Arm arm;
  Optimised function;  ///< in the arm's own joint variables
};

/// The canonical arms among which the cheapest forward kinematics is looked for: of a right-angled arm the
/// two zero poses that promise most by their forms.
std::vector<canonical::Arm> arms_for_pose(const model::Robot& described, const passes::CostModel& cost = {});

/// The cheapest forward kinematics of a described arm. Half angles, and so the quaternion's operations,
/// depend on where the joints have their zeros.
Pose forward_kinematics(const model::Robot& described, const OptimiseOptions& options = {});

}  // namespace qvgen::optimise
