// SPDX-License-Identifier: MIT
// The recursion's pass inward: the wrench that every link takes with all that it carries, from the tips to
// the base, and the generalised forces that are its components along the joints' ways.
#pragma once

#include <vector>

#include "derive/dynamics/link_motions.h"

namespace qvgen::derive::dynamics {

struct LinkWrenches {
  std::vector<Wrench> wrenches;  ///< by link, on it and all that it carries, in its frame
  std::vector<Scalar> forces;    ///< by coordinate, drives of the joints included
};

LinkWrenches link_wrenches(const Recursion& recursion, const LinkMotions& motions);

}  // namespace qvgen::derive::dynamics
