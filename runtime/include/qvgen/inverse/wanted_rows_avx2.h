// SPDX-License-Identifier: MIT
#pragma once

// Wanted rows chosen in lanes. Four rows are compared with limits at once, joint by joint, with the
// operations of `Within::take` and in their order; then each row waits until all distances are known, and is
// written once, at its place in the wanted order.
//
// Only for files that are compiled for AVX2; they include no header with functions of other types, since the
// linker might take a copy made for AVX2 for everybody.

#include <cstring>
#include <limits>

#include <immintrin.h>
#include <qvgen/inverse/lane_scalar.h>
#include <qvgen/inverse/rows.h>
#include <qvgen/inverse/within_table.h>

namespace qvgen::inverse::avx2 {

/// AVX2 for single calls, which follow a branch in each lane.
struct Branches : simd::Avx2 {};
using Pack = simd::Lanes<double, Branches>;

}  // namespace qvgen::inverse::avx2

namespace qvgen::simd {
QVGEN_ARCTANGENTS_OF(inverse::avx2::Pack)
}  // namespace qvgen::simd

namespace qvgen::inverse::avx2 {

/// Numbers behind the joints of a row: the label in the lower half, in the upper one no mark.
[[gnu::always_inline]] inline Pack row_end(int label, int apart) {
  const __m256i labels = _mm256_setr_epi64x(label, label + apart, label + 2 * apart, label + 3 * apart);
  return Pack(reinterpret_cast<__m256d>(labels));
}

/// Numbers of joints, four at a time; the last four overlap those before, and three joints or fewer have
/// zeros behind them. They stand in the caller's room: in registers there is none for them, and an object
/// that has them keeps everything else of it in memory too.
template <int dof>
class OfJoints {
 public:
  static constexpr int parts = (dof + 3) / 4;
  static constexpr int size = 4 * parts;

  [[gnu::always_inline]] explicit OfJoints(double* room) : of_(room) {}

  [[gnu::always_inline]] static __m256d load(const double* numbers, int part) {
    if constexpr (dof >= 4) return _mm256_loadu_pd(numbers + first(part));
    const __m256i index = _mm256_setr_epi64x(0, 1, 2, 3);
    return _mm256_maskload_pd(numbers, _mm256_cmpgt_epi64(_mm256_set1_epi64x(dof), index));
  }
  /// All bits where a joint is revolute.
  [[gnu::always_inline]] static __m256d revolute(const bool* is, int part) {
    int bytes = 0;
    std::memcpy(&bytes, is + first(part), dof < 4 ? static_cast<std::size_t>(dof) : 4);
    const __m256i ones = _mm256_cvtepi8_epi64(_mm_cvtsi32_si128(bytes));
    return _mm256_castsi256_pd(_mm256_sub_epi64(_mm256_setzero_si256(), ones));
  }

  [[gnu::always_inline]] void set(int part, __m256d numbers) { _mm256_storeu_pd(of_ + first(part), numbers); }
  [[gnu::always_inline]] Pack operator[](int joint) const { return Pack(_mm256_broadcast_sd(of_ + joint)); }

 private:
  [[gnu::always_inline]] static int first(int part) {
    return dof >= 4 && 4 * part > dof - 4 ? dof - 4 : 4 * part;
  }

  double* of_;
};

/// Four rows as they are wanted.
template <int dof>
struct FourRows {
  Pack q[dof], square;  ///< representatives, and the squares of their distances from the seed
  Pack::Truth exists = false;
};

/// Limits and a seed as `Within` has them.
template <int dof>
class LaneWithin {
  using Numbers = OfJoints<dof>;

 public:
  static_assert(room_of_limits(dof) >= 5 * Numbers::size);

  [[gnu::always_inline]] explicit LaneWithin(const WantedRows& wanted)
      : lower_(wanted.room),
        upper_(wanted.room + Numbers::size),
        seed_(wanted.room + 2 * Numbers::size),
        middle_(wanted.room + 3 * Numbers::size),
        per_turn_(wanted.room + 4 * Numbers::size) {
    const __m256d turn = _mm256_set1_pd(1 / whole_turn);
    for (int part = 0; part < Numbers::parts; ++part) {
      const __m256d seed = Numbers::load(wanted.seed, part);
      seed_.set(part, seed);
      per_turn_.set(part, _mm256_and_pd(Numbers::revolute(wanted.revolute, part), turn));
      set_limits(part, Numbers::load(wanted.lower, part), Numbers::load(wanted.upper, part), seed);
    }
  }

  /// Takes rows of which all are known before any is written: some have joints in common.
  template <class... Rows>
  [[gnu::always_inline]] void take(const Rows&... rows) const {
    (take_inside(rows.first, rows.branch, rows.result), ...);
  }

  /// Four rows as they are solved, and the place for what of them is wanted.
  struct Rows {
    const Pack (&first)[dof];
    const Branch<Pack>& branch;
    FourRows<dof>& result;
  };

 private:
  /// Finds the representatives next to the seed; rows outside do not exist.
  [[gnu::always_inline]] void take_inside(const Pack (&q)[dof], const Branch<Pack>& branch,
                                          FourRows<dof>& rows) const {
    const Pack rounds = 0x1.8p52, turn = whole_turn;
    Pack squares[dof], farthest;
    for (int i = 0; i < dof; ++i) {
      const Pack turns = (((middle_[i] - q[i]) * per_turn_[i]) + rounds) - rounds;
      const Pack value = q[i] + turn * turns;
      rows.q[i] = smaller(larger(value, lower_[i]), upper_[i]);
      const Pack outside = magnitude(rows.q[i] - value);
      farthest = i == 0 ? outside : larger(farthest, outside);
      const Pack off = rows.q[i] - seed_[i];
      squares[i] = off * off;
    }
    rows.square = sum(squares);
    // Next to a seed that is not finite there is nothing.
    const Pack infinite = std::numeric_limits<double>::infinity();
    rows.exists = branch.exists & (farthest <= Pack(limit_tolerance)) & (rows.square < infinite);
  }

  [[gnu::always_inline]] static Pack sum(const Pack (&squares)[dof]) {
    Pack sums[4] = {0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < dof; ++i) sums[i % 4] = i < 4 ? squares[i] : sums[i % 4] + squares[i];
    return (sums[0] + sums[2]) + (sums[1] + sums[3]);
  }

  [[gnu::always_inline]] void set_limits(int part, __m256d lower, __m256d upper, __m256d seed) {
    const __m256d far = _mm256_set1_pd(tolerance::farthest_joint),
                  opposite = _mm256_set1_pd(-tolerance::farthest_joint);
    const __m256d half = _mm256_set1_pd(0.5 * whole_turn - limit_tolerance);
    const __m256d is_range = _mm256_and_pd(
        _mm256_cmp_pd(lower, upper, _CMP_LE_OQ),
        _mm256_and_pd(_mm256_cmp_pd(lower, far, _CMP_LT_OQ), _mm256_cmp_pd(upper, opposite, _CMP_GT_OQ)));
    const __m256d low = _mm256_blendv_pd(far, lower, is_range);
    const __m256d high = _mm256_blendv_pd(opposite, upper, is_range);
    const __m256d centre = _mm256_mul_pd(
        _mm256_set1_pd(0.5), _mm256_add_pd(_mm256_max_pd(low, opposite), _mm256_min_pd(high, far)));
    const __m256d least = _mm256_min_pd(_mm256_add_pd(low, half), centre);
    const __m256d most = _mm256_max_pd(_mm256_sub_pd(high, half), centre);
    lower_.set(part, low);
    upper_.set(part, high);
    middle_.set(part, _mm256_min_pd(_mm256_max_pd(seed, least), most));
  }

  Numbers lower_, upper_, seed_, middle_, per_turn_;
};

/// Numbers by which rows are put in order, a lane for each: the bits of squares, which have the order of the
/// numbers, since these are not negative. Rows that do not exist have the largest.
using Keys = __m256i;

[[gnu::always_inline]] inline Keys keys_of(const Pack::Truth& exists, const Pack& squares) {
  const __m256i absent = _mm256_set1_epi64x(0x7fff'ffff'ffff'ffff);
  return reinterpret_cast<Keys>(select(exists, squares, Pack(_mm256_castsi256_pd(absent))).vector());
}

/// Keys of which lane i has that of lane i + by; those that come from a lane in front of their own count as
/// smaller by `less`.
template <int by>
[[gnu::always_inline]] inline Keys turned(const Keys& keys, long long less = 0) {
  constexpr int order = by == 1 ? 0b00'11'10'01 : by == 2 ? 0b01'00'11'10 : 0b10'01'00'11;
  return _mm256_sub_epi64(_mm256_permute4x64_epi64(keys, order),
                          _mm256_setr_epi64x(0, by > 2 ? less : 0, by > 1 ? less : 0, less));
}

/// How many rows of a block of four stand before each of its own; of equal keys the earlier lane is first.
[[gnu::always_inline]] inline __m256i places_among(const Keys& keys) {
  const __m256i behind_next = _mm256_cmpgt_epi64(keys, turned<1>(keys, 1));
  const __m256i behind_opposite = _mm256_cmpgt_epi64(keys, turned<2>(keys, 1));
  const __m256i behind_previous = _mm256_cmpgt_epi64(keys, turned<3>(keys, 1));
  return _mm256_sub_epi64(_mm256_setzero_si256(),
                          _mm256_add_epi64(_mm256_add_epi64(behind_next, behind_opposite), behind_previous));
}

/// Adds to the places of two blocks how many rows of the other stand before each. Of equal keys the first
/// block's row is first but, with `less` 1, where its lane is the later one.
[[gnu::always_inline]] inline void place_apart(const Keys& first, const Keys& second, long long less,
                                               __m256i& first_places, __m256i& second_places) {
  const __m256i behind[4] = {
      _mm256_cmpgt_epi64(first, second), _mm256_cmpgt_epi64(first, turned<1>(second, less)),
      _mm256_cmpgt_epi64(first, turned<2>(second, less)), _mm256_cmpgt_epi64(first, turned<3>(second, less))};
  const __m256i of_first =
      _mm256_add_epi64(_mm256_add_epi64(behind[0], behind[1]), _mm256_add_epi64(behind[2], behind[3]));
  const __m256i of_second = _mm256_add_epi64(_mm256_add_epi64(behind[0], turned<3>(behind[1])),
                                             _mm256_add_epi64(turned<2>(behind[2]), turned<1>(behind[3])));
  first_places = _mm256_sub_epi64(first_places, of_first);
  second_places = _mm256_add_epi64(second_places, _mm256_add_epi64(of_second, _mm256_set1_epi64x(4)));
}

/// Rows that wait for their places, four in each block: their joints, what stands behind these, a key, by
/// which they are put in order, and how many rows that are known stand before each.
template <int dof>
class WaitingRows {
 public:
  [[gnu::always_inline]] explicit WaitingRows(double* room) : room_(room) {}

  /// Adds four rows, some of which exist, by their distance or else by their number, which is larger than
  /// those of all rows that have been added.
  [[gnu::always_inline]] void add(const FourRows<dof>& rows, const Pack& end, bool is_sorted) {
    const Keys key = keys(rows, is_sorted);
    __m256i places = places_among(key);
    compare_with_earlier(key, places);
    append(rows, end, key, places);
  }
  /// Adds eight rows, whose numbers alternate.
  [[gnu::always_inline]] void add(const FourRows<dof>& rows, const Pack& end, const FourRows<dof>& twins,
                                  const Pack& twin_end, bool is_sorted) {
    const Keys key = keys(rows, is_sorted), twin_key = keys(twins, is_sorted);
    __m256i places = places_among(key), twin_places = places_among(twin_key);
    place_apart(key, twin_key, 1, places, twin_places);
    compare_with_earlier(key, places);
    compare_with_earlier(twin_key, twin_places);
    append(rows, end, key, places);
    append(twins, twin_end, twin_key, twin_places);
  }

  /// Writes the rows by ascending keys, equal ones by branch, those that do not exist behind them.
  [[gnu::always_inline]] void write(double* first, std::ptrdiff_t stride) const {
    // Unrolled these loops are longer than what the solution leaves of the decoder's cache.
#pragma GCC unroll 1
    for (int block = 0; block < blocks_; ++block) {
      const double* rows = room_ + size * block;
      const __m256i offsets = _mm256_mul_epu32(integers(rows + places_at), _mm256_set1_epi64x(stride));
      const __m128i low = _mm256_castsi256_si128(offsets), high = _mm256_extracti128_si256(offsets, 1);
      double* const places[4] = {first + _mm_cvtsi128_si64(low), first + _mm_extract_epi64(low, 1),
                                 first + _mm_cvtsi128_si64(high), first + _mm_extract_epi64(high, 1)};
      put(places, rows);
    }
  }

 private:
  static constexpr int key_at = 4 * (dof + 1), places_at = key_at + 4, size = places_at + 4;

  [[gnu::always_inline]] static __m256i integers(const double* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  }
  [[gnu::always_inline]] static Keys keys(const FourRows<dof>& rows, bool is_sorted) {
    return keys_of(rows.exists, is_sorted ? rows.square : Pack(0.0));
  }

  [[gnu::always_inline]] void compare_with_earlier(const Keys& key, __m256i& places) const {
#pragma GCC unroll 1
    for (int block = 0; block < blocks_; ++block) {
      double* its = room_ + size * block;
      __m256i its_places = integers(its + places_at);
      place_apart(integers(its + key_at), key, 0, its_places, places);
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(its + places_at), its_places);
    }
  }

  [[gnu::always_inline]] void append(const FourRows<dof>& rows, const Pack& end, const Keys& key,
                                     const __m256i& places) {
    double* block = room_ + size * blocks_++;
    for (int i = 0; i < dof; ++i) _mm256_storeu_pd(block + 4 * i, rows.q[i].vector());
    _mm256_storeu_pd(block + 4 * dof, end.vector());
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(block + key_at), key);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(block + places_at), places);
  }

  /// Two numbers of each row at a time.
  template <int joint = 0>
  [[gnu::always_inline]] static void put(double* const (&places)[4], const double* from) {
    const double* numbers = from + 4 * joint;
    if constexpr (joint < dof) {
      const __m256d a = _mm256_loadu_pd(numbers), b = _mm256_loadu_pd(numbers + 4);
      const __m256d even = _mm256_unpacklo_pd(a, b), odd = _mm256_unpackhi_pd(a, b);
      _mm_storeu_pd(places[0] + joint, _mm256_castpd256_pd128(even));
      _mm_storeu_pd(places[1] + joint, _mm256_castpd256_pd128(odd));
      _mm_storeu_pd(places[2] + joint, _mm256_extractf128_pd(even, 1));
      _mm_storeu_pd(places[3] + joint, _mm256_extractf128_pd(odd, 1));
      put<joint + 2>(places, from);
    } else if constexpr (joint == dof) {
      for (int lane = 0; lane < 4; ++lane) places[lane][dof] = numbers[lane];
    }
  }

  double* room_;
  int blocks_ = 0;
};

/// Takes the place of LaneRows where not all rows are wanted. A pose that leaves something free is left to
/// who knows where it is preferred.
template <int dof>
class WantedLaneRows {
 public:
  using Places = const WantedRows&;

  [[gnu::always_inline]] explicit WantedLaneRows(Places wanted)
      : wanted_(wanted), within_(wanted), waiting_(wanted.room + limits_room) {}

  [[gnu::always_inline]] RowCount count(const Branch<Pack>& branch) const {
    waiting_.write(wanted_.places.first, wanted_.places.stride);
    return {any(branch.doubtful | free_) ? -1 : rows_, false, found_};
  }

  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Branch<Pack>& branch, int label) {
    FourRows<dof> rows;
    within_.take(Rows{q, branch, rows});
    add(rows, row_end(label, 1));
    look_at(branch);
  }
  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Pack (&twin)[dof],
                                     const Branch<Pack>& branch, int label) {
    FourRows<dof> rows, twins;
    within_.take(Rows{q, branch, rows}, Rows{twin, branch, twins});
    add(rows, row_end(label, 2), twins, row_end(label + 1, 2));
    look_at(branch);
  }
  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Branch<Pack>& branch,
                                     const Pack (&other)[dof], const Branch<Pack>& other_branch, int label) {
    FourRows<dof> rows, others;
    within_.take(Rows{q, branch, rows}, Rows{other, other_branch, others});
    add(rows, row_end(label, 2), others, row_end(label + 1, 2));
    look_at(branch);
    look_at(other_branch);
  }

 private:
  using Rows = typename LaneWithin<dof>::Rows;

  [[gnu::always_inline]] void add(const FourRows<dof>& rows, const Pack& end) {
    waiting_.add(rows, end, wanted_.is_sorted);
    rows_ += __builtin_popcount(bits(rows.exists));
  }
  [[gnu::always_inline]] void add(const FourRows<dof>& rows, const Pack& end, const FourRows<dof>& others,
                                  const Pack& other_end) {
    waiting_.add(rows, end, others, other_end, wanted_.is_sorted);
    rows_ += __builtin_popcount(bits(rows.exists)) + __builtin_popcount(bits(others.exists));
  }
  [[gnu::always_inline]] void look_at(const Branch<Pack>& branch) {
    found_ |= static_cast<int>(bits(branch.exists));
    free_ = free_ | (branch.exists & branch.continuum);
  }

  static constexpr std::size_t limits_room = room_of_limits(dof);

  const WantedRows& wanted_;
  LaneWithin<dof> within_;
  WaitingRows<dof> waiting_;
  Pack::Truth free_ = false;
  int rows_ = 0, found_ = 0;
};

}  // namespace qvgen::inverse::avx2
