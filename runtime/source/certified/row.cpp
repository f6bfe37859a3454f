// SPDX-License-Identifier: MIT
#include "row.h"

namespace qvgen::inverse::certified {
namespace {

/// The largest radius for which it is proven, to an eighth: from one for which it is.
double largest_alone(const Row& row, double radius) {
  constexpr double most = 1;
  Enclosure image;
  double good = radius, bad = most;
  for (double next = 16 * radius; next < most; next *= 16) {
    if (!row.has_one_within(next, image)) {
      bad = next;
      break;
    }
    good = next;
  }
  while (bad > 1.125 * good) {
    const double next = std::sqrt(good * bad);
    (row.has_one_within(next, image) ? good : bad) = next;
  }
  return good;
}

}  // namespace

RowProof prove_row(const Loop& loop, const double (&row)[joints], double farthest, Enclosure& enclosure) {
  RowProof proof;
  const Row start(loop, row);
  if (!start.is_moderate()) return proof;
  constexpr double smallest = 1e-15;
  double radius = std::max(2 * start.step(), smallest);
  while (radius <= farthest && !start.has_one_within(radius, enclosure)) radius *= 8;
  if (!(radius <= farthest)) return proof;
  proof.proven = true;
  proof.within = start.distance(enclosure);
  proof.alone_within = largest_alone(start, radius);
  return proof;
}

}  // namespace qvgen::inverse::certified
