// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "pose_sets.h"

namespace qvgen::test {

/// Faults of the solutions of one pose, and how exact they are.
struct Verdict {
  int rows = 0;
  Case::Miss miss;       ///< largest of all rows
  int bad = 0;           ///< rows that do not reach the pose within 1e-12
  int repeated = 0;      ///< rows within 1e-9 of another one
  bool missing = false;  ///< the sampled joints, and nothing is said of it
  bool told = false;     ///< they are missing, and the status says that solutions may be
  std::string fault;     ///< the first thing wrong, in words; empty if all is right
};

Verdict judge(const Case& test, const Sample& sample, const Found& found);

/// True if joints that reach a pose stand in its set: as a row (no further off than `close`), joined to one
/// by a curve all of whose points reach the pose, or, on a marked continuum, as the row that a seed brings
/// out.
bool contains(const Case& test, const Found& found, const Sample& sample, double close = 1e-6);

}  // namespace qvgen::test
