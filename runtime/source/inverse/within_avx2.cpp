// SPDX-License-Identifier: MIT
// Compiled with -mavx2; called only where the machine has it. Without Eigen, whose layouts change with the
// machine.
#include <qvgen/inverse/within_table.h>

#if defined(__AVX2__)
#include <cstring>

#include <immintrin.h>

namespace qvgen::inverse {
namespace {

/// Eight numbers, the last two of which may be nothing.
struct Eight {
  __m256d low, high;

  explicit Eight(const double* numbers) : low(_mm256_loadu_pd(numbers)), high(_mm256_loadu_pd(numbers + 4)) {}
  Eight(__m256d a, __m256d b) : low(a), high(b) {}

  [[nodiscard]] double sum() const {
    const __m256d four = _mm256_add_pd(low, high);
    const __m128d two = _mm_add_pd(_mm256_castpd256_pd128(four), _mm256_extractf128_pd(four, 1));
    return _mm_cvtsd_f64(_mm_add_sd(two, _mm_unpackhi_pd(two, two)));
  }
};

Eight operator+(const Eight& a, const Eight& b) {
  return {_mm256_add_pd(a.low, b.low), _mm256_add_pd(a.high, b.high)};
}
Eight operator-(const Eight& a, const Eight& b) {
  return {_mm256_sub_pd(a.low, b.low), _mm256_sub_pd(a.high, b.high)};
}
Eight operator*(const Eight& a, const Eight& b) {
  return {_mm256_mul_pd(a.low, b.low), _mm256_mul_pd(a.high, b.high)};
}
Eight larger(const Eight& a, const Eight& b) {
  return {_mm256_max_pd(a.low, b.low), _mm256_max_pd(a.high, b.high)};
}
Eight smaller(const Eight& a, const Eight& b) {
  return {_mm256_min_pd(a.low, b.low), _mm256_min_pd(a.high, b.high)};
}
bool all_within(const Eight& a, double most) {
  const __m256d sign = _mm256_set1_pd(-0.0);
  const __m256d farther = _mm256_max_pd(_mm256_andnot_pd(sign, a.low), _mm256_andnot_pd(sign, a.high));
  return _mm256_movemask_pd(_mm256_cmp_pd(farther, _mm256_set1_pd(most), _CMP_NLE_UQ)) == 0;
}

/// Reads the joints of a row, zeros behind them: in pairs, as they have just been written. A wider read would
/// wait until they are in memory.
template <int dof>
Eight joints_of(const double* row) {
  const __m256d low =
      _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(row)), _mm_loadu_pd(row + 2), 1);
  const __m128d last = dof == 7 ? _mm_load_sd(row + 6) : _mm_setzero_pd();
  return {low, _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(row + 4)), last, 1)};
}

/// Writes joints, and what stands behind them in the row that they come from.
template <int dof>
void put(const Eight& joints, const double* row, double* place) {
  _mm256_storeu_pd(place, joints.low);
  _mm_storeu_pd(place + 4, _mm256_castpd256_pd128(joints.high));
  if constexpr (dof == 7) _mm_store_sd(place + 6, _mm256_extractf128_pd(joints.high, 1));
  std::memcpy(place + dof, row + dof, sizeof *place);
}

/// Operation by operation as `Within::take`.
template <int dof>
int rows_within(const WithinTable<8>& table, const double* rows, int count, double* kept, double* squares) {
  const Eight lower(table.lower), upper(table.upper), seed(table.seed), middle(table.middle);
  const Eight turn(table.turn), per_turn(table.per_turn);
  const __m256d all_rounds = _mm256_set1_pd(0x1.8p52);
  const Eight rounds{all_rounds, all_rounds};
  int found = 0;
  for (int k = 0; k < count; ++k) {
    const Eight q = joints_of<dof>(rows + 8 * k);
    const Eight turns = (((middle - q) * per_turn) + rounds) - rounds;
    const Eight value = q + turn * turns;
    const Eight inside = smaller(larger(value, lower), upper);
    put<dof>(inside, rows + 8 * k, kept + 8 * found);
    const Eight off = inside - seed;
    squares[found] = (off * off).sum();
    found += static_cast<int>(all_within(inside - value, limit_tolerance));
  }
  return found;
}

int of_six_or_seven(const WithinTable<8>& table, int dof, const double* rows, int count, double* kept,
                    double* squares) {
  return dof == 6 ? rows_within<6>(table, rows, count, kept, squares)
                  : rows_within<7>(table, rows, count, kept, squares);
}

}  // namespace

extern const RowsWithin rows_within_avx2;
const RowsWithin rows_within_avx2 = &of_six_or_seven;

}  // namespace qvgen::inverse
#else
namespace qvgen::inverse {
extern const RowsWithin rows_within_avx2;
const RowsWithin rows_within_avx2 = nullptr;
}  // namespace qvgen::inverse
#endif
