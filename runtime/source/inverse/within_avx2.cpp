// SPDX-License-Identifier: MIT
// Compiled with -mavx2; called only where the machine has it. Without Eigen, whose layouts change with the
// machine.
#include <qvgen/inverse/within_table.h>

#if defined(__AVX2__)
#include <cstring>

#include <qvgen/simd/lanes.h>

namespace qvgen::inverse {
namespace {

/// Joints of a row, the last two of which may be nothing.
using Eight = simd::Lanes<double, simd::Doubles<8>>;
using Four = simd::Lanes<double, simd::Doubles<4>>;

// Eight numbers are one register where everything is compiled for AVX-512.
template <int half>
Four half_of(const Eight& numbers) {
#if defined(__AVX512DQ__)
  return Four(_mm512_extractf64x4_pd(numbers.vector(), half));
#else
  return Four(numbers.vector().part[half]);
#endif
}
Eight of_halves(__m256d low, __m256d high) {
#if defined(__AVX512DQ__)
  return Eight(_mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1));
#else
  return Eight(Eight::Vector{{low, high}});
#endif
}
__m128d upper_half(const Four& numbers) { return _mm256_extractf128_pd(numbers.vector(), 1); }

double sum(const Eight& numbers) {
  const Four four = half_of<0>(numbers) + half_of<1>(numbers);
  const __m128d two = _mm_add_pd(_mm256_castpd256_pd128(four.vector()), upper_half(four));
  return _mm_cvtsd_f64(_mm_add_sd(two, _mm_unpackhi_pd(two, two)));
}
bool all_within(const Eight& a, double most) {
  const Four farther = larger(magnitude(half_of<0>(a)), magnitude(half_of<1>(a)));
  return all(farther <= Four(most));
}

/// Reads the joints of a row, zeros behind them: in pairs, as they have just been written. A wider read would
/// wait until they are in memory.
template <int dof>
Eight joints_of(const double* row) {
  const auto four = [](__m128d low, __m128d high) {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
  };
  const __m128d last = dof == 7 ? _mm_load_sd(row + 6) : _mm_setzero_pd();
  return of_halves(four(_mm_loadu_pd(row), _mm_loadu_pd(row + 2)), four(_mm_loadu_pd(row + 4), last));
}

/// Writes joints, and what stands behind them in the row that they come from.
template <int dof>
void put(const Eight& joints, const double* row, double* place) {
  const Four low = half_of<0>(joints), high = half_of<1>(joints);
  low.store(place);
  _mm_storeu_pd(place + 4, _mm256_castpd256_pd128(high.vector()));
  if constexpr (dof == 7) _mm_store_sd(place + 6, upper_half(high));
  std::memcpy(place + dof, row + dof, sizeof *place);
}

/// Operation by operation as `Within::take`.
template <int dof>
int rows_within(const WithinTable<8>& table, const double* rows, int count, double* kept, double* squares) {
  const Eight lower = Eight::load(table.lower), upper = Eight::load(table.upper);
  const Eight seed = Eight::load(table.seed), middle = Eight::load(table.middle);
  const Eight turn = Eight::load(table.turn), per_turn = Eight::load(table.per_turn), rounds = 0x1.8p52;
  int found = 0;
  for (int k = 0; k < count; ++k) {
    const Eight q = joints_of<dof>(rows + 8 * k);
    const Eight turns = (((middle - q) * per_turn) + rounds) - rounds;
    const Eight value = q + turn * turns;
    const Eight inside = smaller(larger(value, lower), upper);
    put<dof>(inside, rows + 8 * k, kept + 8 * found);
    const Eight off = inside - seed;
    squares[found] = sum(off * off);
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
