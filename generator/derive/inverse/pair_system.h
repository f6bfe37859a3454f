// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "derive/inverse/block.h"

namespace qvgen::derive::inverse {

/// Both angles from two equations that hold both, x = Rot(±q_a) x0 the vector that joint a turns (Block::x0):
/// x out of two linear equations, then its length is a conic in (cos q_c, sin q_c). Empty, or why that fails.
std::string eliminate(Builder& builder, const Block& a, const Screw& c, const std::array<PairRow, 2>& rows);

}  // namespace qvgen::derive::inverse
