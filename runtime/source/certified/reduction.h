// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "cover.h"

/// The reduced loop that suits some rows best: around each of them it has a region with no other solution.
namespace qvgen::inverse::certified {

inline constexpr int most_rows = 64;

/// Joint values, with a bound of how far the solutions that are meant may be from them.
struct Centre {
  double q[joints];
  double within;
};

struct Reduction {
  std::optional<Equations> equations;  ///< none: some row has no region, or the arm cannot be reduced
  Region regions[most_rows] = {};
};

/// Returns the reduction with the largest regions, of all that can be dropped of the loop.
Reduction best_reduction(const Loop& loop, const Centre* rows, int count);

}  // namespace qvgen::inverse::certified
