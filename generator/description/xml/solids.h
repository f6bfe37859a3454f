// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "description/tree/rigid.h"

namespace qvgen::description::xml {

/// A body of uniform density, or a shell of uniform thickness, about its centre, with the z axis of a capsule
/// or cylinder along its length.
struct Solid {
  cln::cl_R volume;      ///< or surface
  tree::Vector moments;  ///< of a mass of 1
};

/// The solid of an MJCF's geom: `size` as there (radius; radius and half a length; half of each side).
/// Nothing for a type without volume. A shell of an ellipsoid is approximated as MuJoCo does.
std::optional<Solid> solid(const std::string& type, const tree::Vector& size, bool shell);

/// How many numbers its size has; 0 for a type without one.
std::size_t sizes_of(const std::string& type);

}  // namespace qvgen::description::xml
