// SPDX-License-Identifier: MIT
// When the set of a pose is taken to be complete: arms two of whose joints slide.
#include "careful.h"

namespace qvgen::inverse::elimination {

/// Agreement of the passes so far.
struct Careful::Agreement {
  bool any_loud;    ///< the polynomial drowned in rounding: of some pass,
  bool all_loud;    ///< of all at the pose itself,
  bool ever_quiet;  ///< not of all, those nearby among them
  bool faint;       ///< what was looked at instead is known to few digits
  bool has_rows;    ///< a pass at the pose itself has led somewhere
  int times = 0;    ///< passes in a row that have led to the same rows

  /// Rows that only poses nearby lead to are asked for more often.
  [[nodiscard]] bool reached() const { return times >= (has_rows ? 1 : 3); }
};

void Careful::pass_of_slides(const Elimination& elimination, const Pose<double>& pose, bool exact,
                             Agreement& agreement) {
  Gathered more;
  eliminate(elimination, pose, more);
  ++effort_.passes;
  const int before = size_;
  for (int i = 0; i < size_; ++i) rows_[i].seen = false;
  strays_ = false;
  if (exact)
    settle(more);
  else
    settle_nearby(more);
  merge();
  // Poses near one at which two solutions meet may have none of them, and any place of a continuum.
  const bool all_seen = std::all_of(rows_, rows_ + size_, [&](const Row& row) {
    return row.seen || row.continuum || (!exact && is_singular(row));
  });
  agreement.any_loud = agreement.any_loud || more.loud;
  agreement.ever_quiet = agreement.ever_quiet || !more.loud;
  if (exact) {
    agreement.all_loud = agreement.all_loud && more.loud;
    agreement.faint = agreement.faint || more.faint;
    agreement.has_rows = agreement.has_rows || size_ > 0;
  }
  const bool same = size_ > 0 && size_ == before && all_seen && !(exact && strays_);
  agreement.times = same && agreement.ever_quiet ? agreement.times + 1 : 0;
}

/// Every outer angle leads to all solutions that stand there. So it takes two passes that lead to the same,
/// at least one of which has a polynomial: where something is free, that of a pose nearby.
void Careful::agree_on_slides(const Gathered& first) {
  Agreement agreement{first.loud, first.loud, !first.loud, first.faint, size_ > 0};
  while (!agreement.reached()) {
    const Elimination* elimination = next_elimination();
    if (elimination == nullptr) break;
    pass_of_slides(*elimination, pose_, true, agreement);
  }
  constexpr int most_poses = 8;
  for (int k = 0; !agreement.reached() && k < most_poses && !tracker_.budget().spent.used_up; ++k)
    pass_of_slides(setup_.eliminations[k % setup_.count], nearby(k), false, agreement);
  unsure_ = agreement.faint || (size_ > 0 ? !agreement.reached() || !is_even() : agreement.any_loud);
  // Neither regular nor on a continuum, and found by no polynomial: next to a continuum.
  for (int i = 0; agreement.all_loud && i < size_; ++i)
    unsure_ = unsure_ || (!rows_[i].continuum && is_singular(rows_[i]));
}

}  // namespace qvgen::inverse::elimination
