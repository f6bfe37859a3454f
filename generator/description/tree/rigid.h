// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <cln/real.h>

#include "model/robot.h"

/// Constant displacements without symbols put together, and bodies that they join.
namespace qvgen::description::tree {

/// Digits of what has no exact value here; far beyond what any generated scalar can tell.
inline constexpr long rounded_digits = 40;

/// The value if it is rational, else rounded to `rounded_digits` decimals.
cln::cl_RA rounded(const cln::cl_R& value);

/// R(turns) v: exact where the sines and cosines of the angles are roots, else rounded.
model::Vector3 turned(const std::vector<model::Turn>& turns, const model::Vector3& v);
/// x -> first(second(x)); turns about one axis that follow each other become one.
model::Displacement folded(const model::Displacement& first, const model::Displacement& second);
model::Displacement inverse(const model::Displacement& displacement);

using Vector = std::array<cln::cl_R, 3>;
using Matrix = std::array<Vector, 3>;  ///< rows

/// Returns the entries' values.
Vector values(const model::Vector3& v);

/// Inertial parameters in some frame: mass, centre of mass, tensor about the centre of mass.
struct Body {
  cln::cl_R mass = 0;
  Vector centre{0, 0, 0};
  Matrix inertia{Vector{0, 0, 0}, Vector{0, 0, 0}, Vector{0, 0, 0}};
};

/// The body as seen from the frame in which its own frame is displaced like this.
Body moved(const model::Displacement& frame, const Body& body);
/// The body with mass and tensor multiplied.
Body scaled(Body body, const cln::cl_R& factor);
/// Both bodies as one; where neither has mass the tensors are added.
Body joined(const Body& a, const Body& b);
model::Inertia inertia_of(const Body& body);

}  // namespace qvgen::description::tree
