// SPDX-License-Identifier: MIT
// The guess that an identification begins with: the description's own numbers, or rods of one density along
// the links where it has none.
#pragma once

#include <optional>

#include "identify/consistent.h"
#include "model/robot.h"

namespace qvgen::identify {

/// Returns the prior of an arm; links whose description gives a body with mass keep it, the others are thick
/// rods from their joint to the next one, all of one mass. That mass fits the identified parameters best, or,
/// with `mass` (kg, of all links), what the described ones leave of it.
Prior prior_of(const model::Robot& robot, const ArmRegressor& arm, const Estimate& estimate,
               std::optional<double> mass);

/// Returns the description's own parameters, ten a link and four a drive, those of motors last, as
/// ArmRegressor::combination takes them; nothing if a link has none. Drives without numbers are zero.
std::optional<Eigen::VectorXd> described_parameters(const model::Robot& robot);

}  // namespace qvgen::identify
