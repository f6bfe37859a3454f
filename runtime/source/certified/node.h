// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "row.h"

/// Pieces of which proofs of motions are made: small boxes at places of the way, and boxes around two of them
/// in which one motion leads from one to the other.
namespace qvgen::inverse::certified {

/// A place of the way with a small box in which its pose has exactly one solution.
struct Node {
  double q[joints];
  bool proven = false;
  Enclosure box;
};

/// Returns a place with the smallest box that is found, about joints that nearly solve the loop.
Node node_at(const Loop& loop, const double (&q)[joints]);

/// Brings joints to the loop's pose by a few of Newton's steps; false if these are long or many.
bool settle(const Loop& loop, double (&q)[joints]);

/// A box that holds exactly one solution for each pose of a stretch.
struct TubeBox {
  double middle[joints], radius[joints];
  Enclosure solution;  ///< all solutions of the stretch lie in it

  [[nodiscard]] double narrowest() const { return *std::min_element(radius, radius + joints); }
};

/// True if a box is found that holds exactly one solution for each pose of a loop's goal, and the boxes of
/// both ends of the stretch: one continuous motion leads from one to the other.
bool has_one_motion(const Loop& stretch, const Node& from, const Node& to, TubeBox& box);

}  // namespace qvgen::inverse::certified
