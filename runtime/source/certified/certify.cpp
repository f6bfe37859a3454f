// SPDX-License-Identifier: MIT
#include <qvgen/inverse/certified/certify.h>

#include "reduction.h"

namespace qvgen::inverse::certified {
namespace {

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

Reduction best_reduction(const Loop& loop, const Rows& rows) {
  Centre centres[most_rows];
  for (int i = 0; i < rows.count; ++i) {
    std::copy(rows.value[i], rows.value[i] + joints, centres[i].q);
    centres[i].within = rows.proof[i].within;
  }
  return best_reduction(loop, centres, rows.count);
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
