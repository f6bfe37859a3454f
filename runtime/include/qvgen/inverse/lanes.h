// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <qvgen/inverse/rows.h>
#include <qvgen/inverse/solutions.h>

namespace qvgen::inverse {

/// True if this machine runs code for AVX2.
inline bool machine_has_avx2() {
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

/// The memory of a solution set's rows.
template <int dof, int capacity>
RowPlaces row_places(Solutions<dof, capacity>& found) {
  using Row = Solution<dof>;
  static_assert(sizeof(Row::q) == dof * sizeof(double) && sizeof(Row) % sizeof(double) == 0 &&
                sizeof(int) == 4 && sizeof(bool) == 1);
  Row& first = found[0];
  return {first.q.data(), sizeof(Row) / sizeof(double)};
}

/// Takes the rows that stand in the set's memory.
template <int dof, int capacity>
void conclude(Solutions<dof, capacity>& found, RowCount count) {
  found.truncate(count.rows);
  found.status = count.rows == 0 ? Status::unreachable : count.continuum ? Status::singular : Status::solved;
}

}  // namespace qvgen::inverse
