// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/robot.h"
#include "symbolic/program.h"

namespace qvgen::derive {

/// Velocity of the tool point and angular velocity of the tool.
struct Twist {
  symbolic::Vector linear;
  symbolic::Vector angular;
};

/// The tool's pose by the plain product of the joints' pairs, and the columns of its Jacobian in the base
/// frame by differentiation of that product: dp/dq_i, and the vector part of 2 (dq/dq_i) q^-1. Nothing
/// merged, nothing simplified: what every other way to compute a Jacobian is held against.
struct PlainJacobian {
  symbolic::Pair tool;
  std::vector<Twist> columns;
};
PlainJacobian plain_jacobian(const model::Robot& robot, symbolic::Program& program);

}  // namespace qvgen::derive
