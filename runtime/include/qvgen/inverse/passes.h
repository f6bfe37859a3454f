// SPDX-License-Identifier: MIT
#pragma once

// Tables of passes over the branches near a singular pose, as values: near_singular.h has that of closed
// forms, quartic/care.h that of arms with a quartic. A pass is run for the branches that no pass before has
// settled.

#include <cstddef>

#include <qvgen/inverse/boundary.h>

namespace qvgen::inverse {

/// One kind of pass. Its cost is bounded by `most` and by the search's `Budget`, which refuses what is
/// beyond.
template <class Search>
struct PlannedPass {
  const char* name;
  int most;                                       ///< times
  bool (*is_wanted)(const Search& found, int k);  ///< for the k-th time
  void (*run)(Search& search, int k);
};

/// Runs the passes of a table in their order, each as often as it is wanted.
template <class Search, std::size_t size>
void run_passes(const PlannedPass<Search> (&table)[size], Search& search) {
  for (const PlannedPass<Search>& each : table)
    for (int k = 0; k < each.most && each.is_wanted(search, k); ++k) each.run(search, k);
}

/// Runs a pass in which branches with a solution are followed again, with the choice in the other of two
/// ranges.
template <class Search>
void pass_in_other_range(Search& search, const Boundary& choosing) {
  search.tracker.follow_again(true);
  search.pass(choosing.in_other_range());
  search.tracker.follow_again(false);
}

}  // namespace qvgen::inverse
