// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <cln/real.h>

#include "canonical/length.h"
#include "model/robot.h"

namespace qvgen::canonical {

/// A constant rotation in numbers of model::evaluation_digits digits, row by row.
using Rotation = std::array<std::array<cln::cl_R, 3>, 3>;

/// A constant placement x -> R x + t.
struct Placement {
  Rotation rotation;
  LengthVector translation;
};

Rotation identity();
Rotation about_x(const cln::cl_R& angle);
Rotation about_z(const cln::cl_R& angle);
Rotation operator*(const Rotation& a, const Rotation& b);
Rotation transpose(const Rotation& r);
LengthVector operator*(const Rotation& r, const LengthVector& v);
Placement operator*(const Placement& a, const Placement& b);

/// True if the rotation takes every coordinate axis to one: all entries 0, 1 or -1.
bool is_right_angled(const Rotation& r);

/// A rotation that takes +z to the axis, by right angles if the axis is a coordinate axis.
Rotation from_z_to(const model::Vector3& axis);

/// The placement that a description's displacement is; its turns must be known.
Placement to_placement(const model::Displacement& displacement, Definitions& definitions);

/// R = Rz(first) Rx(middle) Rz(last); first is 0 where middle is 0 or pi. The middle angle lies in [0, pi].
struct Euler {
  cln::cl_R first, middle, last;
  bool is_parallel = false;  ///< middle is 0 or pi
};
Euler euler(const Rotation& r);

/// Turns about z, x and z again; those by nothing are left out.
std::vector<model::Turn> to_turns(const Euler& angles);
/// The angle as an expression: a multiple of pi where it is one of pi/2, else a named constant; in (-pi, pi].
model::Expression to_angle(const cln::cl_R& radians);

/// Brought into (-pi, pi], and an angle next to a multiple of pi/2 made exactly that.
cln::cl_R wrapped(const cln::cl_R& radians);

}  // namespace qvgen::canonical
