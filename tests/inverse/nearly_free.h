// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "case.h"

// Poses 10^-6 to 10^-16 off a singular one: a joint at a multiple of 90 degrees, two branches that meet, the
// wrist's centre or the tool on the first axis. Joints are known to few digits there, so a row stands for
// those that a pose was made from, or is marked.

namespace qvgen::test {

/// Calls by which the sampled joints of such poses are lost.
struct LostRows {
  int calls = 0;
  int told = 0;       ///< `Status::incomplete`
  int lost = 0;       ///< of the others: no row is near the sampled joints, and no marked row stands for them
  std::string first;  ///< the first of these, in words
};

/// Asks for all rows, for rows from another seed or within limits, and for the row near the sampled joints.
LostRows lost_next_to_singular(Case& test, int poses);

/// Asks for all rows where two singularities are at once. Solutions that rounding does not tell apart are one
/// row there: joints that a curve of solutions joins to any row are not lost.
LostRows lost_at_two_singularities(Case& test, int poses);

}  // namespace qvgen::test
