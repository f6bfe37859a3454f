// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "symbolic/algebra.h"

namespace qvgen::emit {

/// A homogeneous matrix: x -> rotation x + position, in full angles.
struct LinkMatrix {
  symbolic::Matrix3 rotation;
  symbolic::Vector position;
};
LinkMatrix matrix_of(const model::Displacement& displacement);
/// From the frame of a link to that of the link before it.
LinkMatrix matrix_of(const model::Joint& joint);

}  // namespace qvgen::emit
