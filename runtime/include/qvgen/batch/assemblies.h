// SPDX-License-Identifier: MIT
// Assemblies of closed loops for many inputs: the rows, the order and the bits of the single calls, which are
// taken one by one. `in_threads` (batch/threads.h) shares the inputs among threads:
//
//     qvgen::in_threads(count, [&](std::size_t first, std::size_t part) {
//       bar::assemble(cranks.part(first, part), found.part(first, part));
//     });
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include <qvgen/assembly.h>
#include <qvgen/batch/inverse.h>
#include <qvgen/batch/view.h>

namespace qvgen {

/// The assemblies of many inputs, side by side; views, which own nothing. Those of input k are in their order
/// in the first count(0, k) places.
struct BatchOfAssemblies {
  /// capacity * dof rows: joint i of the s-th assembly stands in row s * dof + i; NaN behind the last one.
  Batch<double> q;
  Batch<int> count;      ///< one row: how many there are
  Batch<Status> status;  ///< one row
  Batch<int> branch;     ///< capacity rows, -1 behind the last assembly; may be left empty
  /// capacity rows: 1 if a joint of the assembly is free, plus 2 if another one meets it; may be left empty.
  Batch<unsigned char> marks;

  /// Those of the inputs first, first + 1, ..., at most `most` of them.
  [[nodiscard]] BatchOfAssemblies part(std::size_t first, std::size_t most) const {
    return {q.part(first, most), count.part(first, most), status.part(first, most), branch.part(first, most),
            marks.part(first, most)};
  }
};

namespace batch {

/// Writes the assemblies of a single call into a batch, at input `k`.
template <int dof, int capacity>
void put(const Assemblies<dof, capacity>& single, const BatchOfAssemblies& found, std::size_t k) {
  for (int s = 0; s < capacity; ++s) {
    const auto place = static_cast<std::size_t>(s);
    const bool is_row = s < single.size();
    for (int i = 0; i < dof; ++i)
      found.q(place * std::size_t(dof) + static_cast<std::size_t>(i), k) =
          is_row ? single[s].q[i] : std::numeric_limits<double>::quiet_NaN();
    if (found.branch.data != nullptr) found.branch(place, k) = is_row ? single[s].branch : -1;
    if (found.marks.data == nullptr) continue;
    const int mark = is_row ? (single[s].continuum ? 1 : 0) + (single.meets(single[s]) ? 2 : 0) : 0;
    found.marks(place, k) = static_cast<unsigned char>(mark);
  }
  found.count(0, k) = single.size();
  found.status(0, k) = single.status;
}

/// Calls `single(k)` for each input k that all batches have, and writes what it returns.
template <class Single>
void assemblies(std::size_t count, const BatchOfAssemblies& found, const Single& single) {
  count = std::min({count, found.q.count, found.count.count, found.status.count});
  if (found.branch.data != nullptr) count = std::min(count, found.branch.count);
  if (found.marks.data != nullptr) count = std::min(count, found.marks.count);
  for (std::size_t k = 0; k < count; ++k) put(single(k), found, k);
}

}  // namespace batch
}  // namespace qvgen
