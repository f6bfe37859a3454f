// SPDX-License-Identifier: MIT
#include <qvgen/inverse/lanes.h>
#include <qvgen/inverse/within_table.h>

namespace qvgen::inverse {

#ifdef QVGEN_HAS_AVX2_KERNEL
extern const RowsWithin rows_within_avx2;
#endif

RowsWithin widest_rows_within() {
#ifdef QVGEN_HAS_AVX2_KERNEL
  if (machine_has_avx2()) return rows_within_avx2;
#endif
  return nullptr;
}

}  // namespace qvgen::inverse
