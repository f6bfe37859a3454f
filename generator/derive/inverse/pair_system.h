// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <string>

#include "derive/inverse/block.h"

namespace qvgen::derive::inverse {

/// Two equations that hold the angles of both outer joints: k·x of u and m·(cos, sin) of w.
using PairRows = std::array<PairRow, 2>;

/// Component along n of both points: the same.
PairRow same_height(const symbolic::Vector& n, const Block& u, const Block& w, const Scope& scope);
/// Distance of both points from a place: the same.
PairRow same_distance(const symbolic::Vector& from, const Block& u, const Block& w, const Scope& scope);

/// Both angles from two equations that hold both, x = Rot(±q_a) x0 the vector that joint a turns (Block::x0):
/// x out of two linear equations, then its length is a conic in (cos q_c, sin q_c). Empty, or why that fails.
std::string eliminate(Builder& builder, const Block& a, const Screw& c, const PairRows& rows);

/// Solves the system with one of two joints eliminated. `rows(u, w)` are the rows to eliminate u from. If
/// their determinant holds the pose, it vanishes at some poses, and all is noise: so the joint with a
/// constant determinant is eliminated, if only one has it.
std::string eliminate_one(Builder& builder, const Block& a, const Block& c,
                          const std::function<PairRows(const Block& u, const Block& w)>& rows);

}  // namespace qvgen::derive::inverse
