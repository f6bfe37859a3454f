// SPDX-License-Identifier: MIT
#pragma once

#include "derive/form.h"
#include "model/robot.h"

namespace qvgen::derive {

/// Outputs of a 6 x n matrix: v1_1 ... v3_n (linear rows), w1_1 ... w3_n (angular rows); of a twist v1 ...
/// w3.
std::string jacobian_entry(std::size_t row, std::size_t column);
std::string twist_entry(std::size_t row);

/// 6 x n Jacobian in the base frame at the tool point.
Quantity jacobian(const model::Robot& robot);
/// The definition of the latter: `plain_jacobian`.
symbolic::Program jacobian_definition(const model::Robot& robot);
/// The lecture's three methods, each computing what `jacobian` computes; for comparison.
std::vector<Form> jacobian_methods(const model::Robot& robot);
/// The Jacobian in the tool frame.
Quantity tool_jacobian(const model::Robot& robot);
/// In the base frame at a point (point.x, point.y, point.z) of the tool frame.
Quantity jacobian_at(const model::Robot& robot);
/// Outputs of homogeneous_transform, then those of jacobian.
Quantity transform_and_jacobian(const model::Robot& robot);
/// Twist of the tool in the base frame for the joint rates rate_name(variable).
Quantity velocity(const model::Robot& robot);
/// d/dt of the Jacobian.
Quantity jacobian_rate(const model::Robot& robot);
/// (d/dt of the Jacobian) times the joint rates: the tool's acceleration at constant joint rates.
Quantity acceleration_bias(const model::Robot& robot);

}  // namespace qvgen::derive
