// SPDX-License-Identifier: MIT
// Logs that an arm does not explain are tried with the usual mistakes undone: columns of two joints swapped,
// a sign, a unit of time. The one that explains them best is said.
#pragma once

#include <string>
#include <vector>

#include "identify/equations.h"
#include "identify/estimate.h"

namespace qvgen::identify {

/// Returns a sentence on the mistake that explains the torques far better; empty if none does. The logs have
/// rates and accelerations; some thousand samples of each are tried, standing joints
/// among them.
std::string suspicion(const ArmRegressor& arm, const std::vector<MotionLog>& logs);

/// Returns sentences on parameters that no arm has: friction that drives, data that hardly tell anything
/// apart.
std::vector<std::string> oddities(const ArmRegressor& arm, const Estimate& estimate);

}  // namespace qvgen::identify
