// SPDX-License-Identifier: MIT
#include <optional>

#include <qvgen/inverse/certified/certify.h>

#include "cover.h"

namespace qvgen::inverse::certified {
namespace {

constexpr int most_rows = 64;

struct Rows {
  int count = 0;
  RowProof* proof = nullptr;
  double value[most_rows][joints];
  Enclosure enclosure[most_rows];
};

/// True if each of them is proven.
bool prove(const Loop& loop, double farthest, Rows& rows) {
  bool all = true;
  for (int i = 0; i < rows.count; ++i) {
    rows.proof[i] = prove_row(loop, rows.value[i], farthest, rows.enclosure[i]);
    all = all && rows.proof[i].proven;
  }
  return all;
}

/// True if two joint values are certainly not the same; angles whole turns apart are.
bool differ(const Interval& a, const Interval& b, bool revolute) {
  if (!revolute) return are_apart(a, b);
  const Interval way = a - b;
  const SineCosine at = sine_cosine(Interval(0.5) * way);
  return at.sine.lower > 0 || at.sine.upper < 0;
}

bool are_different(const Loop& loop, const Rows& rows) {
  const auto differs = [&](int i, int j) {
    for (int k = 0; k < joints; ++k)
      if (differ(rows.enclosure[i].solution[k], rows.enclosure[j].solution[k], loop.revolute[k])) return true;
    return false;
  };
  for (int i = 0; i < rows.count; ++i)
    for (int j = 0; j < i; ++j)
      if (!differs(i, j)) return false;
  return true;
}

/// Around each row; the least of their radii, 0 if a row has none that holds its solution.
double find_regions(const Equations& equations, const Rows& rows, Region (&regions)[most_rows]) {
  double least = 1;
  for (int i = 0; i < rows.count; ++i) {
    regions[i] = equations.region_around(rows.value[i]);
    if (!(regions[i].radius > rows.proof[i].within)) return 0;
    least = std::min(least, regions[i].radius);
  }
  return least;
}

/// A reduced loop, and around each row a region in which it has no other solution.
struct Reduction {
  std::optional<Equations> equations;  ///< none: some row has no region, or the arm cannot be reduced
  Region regions[most_rows] = {};
};

/// Returns the reduction with the largest regions, of all that can be dropped of the loop.
Reduction best_reduction(const Loop& loop, const Rows& rows) {
  Reduction best, other;
  double largest = 0;
  for (int choice = 0; choice < choices(loop); ++choice) {
    other.equations.emplace(reduced(loop, choice));
    if (other.equations->unknowns() == 0) continue;
    const double least = find_regions(*other.equations, rows, other.regions);
    if (least > largest) {
      largest = least;
      best = other;
    }
  }
  return best;
}

}  // namespace

Count certify(const Arm& arm, const Pose<double>& pose, const double (*rows)[joints], int count,
              const Effort& effort, RowProof* proofs) {
  Count result;
  if (!is_moderate(arm, pose) || count > most_rows) return result;
  const Loop loop = loop_of(arm, pose);
  Rows all;
  all.count = count;
  all.proof = proofs;
  for (int i = 0; i < count; ++i) std::copy(rows[i], rows[i] + joints, all.value[i]);
  if (!prove(loop, effort.farthest, all) || !are_different(loop, all)) return result;
  const Reduction best = best_reduction(loop, all);
  if (best.equations && is_covered(*best.equations, best.regions, count, effort.boxes, result.boxes))
    result.proof = Proof::complete;
  return result;
}

}  // namespace qvgen::inverse::certified
