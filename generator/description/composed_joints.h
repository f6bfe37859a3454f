// SPDX-License-Identifier: MIT
// Composed joints of TOML as what they are made of. A universal joint is two turns about x and y, a spherical
// one three about x, y and z, a planar one two slides along x and y and a turn about z, each in the frame
// that the part before has moved. type = "universal", variable = "hip" has the variables hip_x and hip_y.
#pragma once

#include "description/links.h"

namespace qvgen::description {

const std::vector<std::string>& composed_type_names();

/// True if the type of a [[joint]] has several parts.
bool is_composed(const Table& joint);

/// Adds the joint's parts, the link and its inertia to the last; reports its mistakes.
void read_composed(const Table& joint, const FreeParameters& free, model::Robot& robot);

}  // namespace qvgen::description
