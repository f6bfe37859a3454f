// SPDX-License-Identifier: MIT
#include "reduction.h"

namespace qvgen::inverse::certified {
namespace {

/// Around each row; the least of their radii, 0 if a row has none that holds its solution.
double find_regions(const Equations& equations, const Centre* rows, int count, Region (&regions)[most_rows]) {
  double least = 1;
  for (int i = 0; i < count; ++i) {
    regions[i] = equations.region_around(rows[i].q);
    if (!(regions[i].radius > rows[i].within)) return 0;
    least = std::min(least, regions[i].radius);
  }
  return least;
}

}  // namespace

Reduction best_reduction(const Loop& loop, const Centre* rows, int count) {
  Reduction best, other;
  double largest = 0;
  for (int choice = 0; choice < choices(loop); ++choice) {
    other.equations.emplace(reduced(loop, choice));
    if (other.equations->unknowns() == 0) continue;
    const double least = find_regions(*other.equations, rows, count, other.regions);
    if (least > largest) {
      largest = least;
      best = other;
    }
  }
  return best;
}

}  // namespace qvgen::inverse::certified
