// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "exact/angle.h"
#include "model/robot.h"

namespace qvgen::derive::dynamics {

/// Elementary rotation about the x axis (0) or the z axis (2).
struct ElementaryRotation {
  std::size_t axis = 2;
  exact::Angle angle;
};

/// Product of elementary rotations, first to last.
using RotationSequence = std::vector<ElementaryRotation>;

/// A rotation that takes +z to the axis, of length one. An oblique axis gives constant angles with an exact
/// sine and cosine; std::domain_error for components that are not exact.
RotationSequence from_z_to(const model::Vector3& axis);
RotationSequence to_sequence(const std::vector<model::Turn>& turns);
RotationSequence inverse(const RotationSequence& sequence);
RotationSequence operator*(RotationSequence a, const RotationSequence& b);

/// Equal rotation with as few turns as right angles and half turns allow; two axes at a right angle or
/// parallel, with whatever in between, come out as z x z at most (Khalil and Kleinfinger 1986).
RotationSequence reduced(RotationSequence sequence);

/// A constant rotation as z x z, with constant angles if need be. Words with variables stay as they are.
RotationSequence recomposed(const RotationSequence& sequence);

/// The angle of a description: linear in symbols and pi; throws std::domain_error otherwise.
exact::Angle to_angle(const model::Expression& expression);

}  // namespace qvgen::derive::dynamics
