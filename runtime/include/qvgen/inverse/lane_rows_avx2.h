// SPDX-License-Identifier: MIT
#pragma once

// Solution rows out of lanes: four branches of one pose, as they are solved.

#include <qvgen/inverse/wanted_rows_avx2.h>

namespace qvgen::inverse::avx2 {

/// A lane's number as a type.
template <int number>
struct Lane {
  static constexpr int value = number;
};

/// Numbers behind the joints of a row, the mark in the upper half's first byte.
[[gnu::always_inline]] inline Pack row_end(const Branch<Pack>& branch, int label, int apart) {
  const __m256i mark =
      _mm256_and_si256(reinterpret_cast<__m256i>(branch.continuum.lanes), _mm256_set1_epi64x(1LL << 32));
  const auto labels = reinterpret_cast<__m256i>(row_end(label, apart).vector());
  return Pack(reinterpret_cast<__m256d>(_mm256_or_si256(labels, mark)));
}

/// Writes lanes as rows, those that exist, one close behind the other: a row that does not exist is written
/// too and overwritten by the next, so that there is no jump.
template <int dof>
class LaneRows {
 public:
  using Places = RowPlaces;

  [[gnu::always_inline]] explicit LaneRows(Places places) : next_(places.first), stride_(places.stride) {}

  [[gnu::always_inline]] RowCount count(const Branch<Pack>& branch) const {
    return {any(branch.doubtful) ? -1 : rows_, continuum_};
  }

  /// One row a lane, branches label, label + 1, ...
  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Branch<Pack>& branch, int label) {
    const Pack end = row_end(branch, label, 1);
    const Steps steps = steps_over(branch, 1);
    each_lane([&](auto number) {
      constexpr int lane = decltype(number)::value;
      row<lane>(next_, q, end);
      next_ += steps.lane[lane];
    });
    add(branch, 1);
  }

  /// Two rows a lane that exist or do not exist together.
  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Pack (&twin)[dof],
                                     const Branch<Pack>& branch, int label) {
    const Pack end = row_end(branch, label, 2);
    const Pack twin_end = row_end(branch, label + 1, 2);
    const Steps steps = steps_over(branch, 2);
    each_lane([&](auto number) {
      constexpr int lane = decltype(number)::value;
      row<lane>(next_, q, end);
      row<lane>(next_ + stride_, twin, twin_end);
      next_ += steps.lane[lane];
    });
    add(branch, 2);
  }

  /// Two rows a lane, each with its own branch.
  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Branch<Pack>& branch,
                                     const Pack (&other)[dof], const Branch<Pack>& other_branch, int label) {
    const Pack end = row_end(branch, label, 2);
    const Pack other_end = row_end(other_branch, label + 1, 2);
    const Steps steps = steps_over(branch, 1);
    const Steps other_steps = steps_over(other_branch, 1);
    each_lane([&](auto number) {
      constexpr int lane = decltype(number)::value;
      row<lane>(next_, q, end);
      next_ += steps.lane[lane];
      row<lane>(next_, other, other_end);
      next_ += other_steps.lane[lane];
    });
    add(branch, 1);
    add(other_branch, 1);
  }

 private:
  template <class Function>
  [[gnu::always_inline]] static void each_lane(const Function& function) {
    function(Lane<0>{});
    function(Lane<1>{});
    function(Lane<2>{});
    function(Lane<3>{});
  }

  /// How far each lane's rows move the place of the next ones.
  struct Steps {
    std::ptrdiff_t lane[4];
  };
  [[gnu::always_inline]] Steps steps_over(const Branch<Pack>& branch, int rows) const {
    const __m256i all =
        _mm256_and_si256(reinterpret_cast<__m256i>(branch.exists.lanes), _mm256_set1_epi64x(rows * stride_));
    const __m128i low = _mm256_castsi256_si128(all);
    const __m128i high = _mm256_extracti128_si256(all, 1);
    return {{_mm_cvtsi128_si64(low), _mm_extract_epi64(low, 1), _mm_cvtsi128_si64(high),
             _mm_extract_epi64(high, 1)}};
  }

  [[gnu::always_inline]] void add(const Branch<Pack>& branch, int rows) {
    const unsigned exist = bits(branch.exists);
    rows_ += rows * __builtin_popcount(exist);
    continuum_ = continuum_ || (exist & bits(branch.continuum)) != 0;
  }

  /// Two joints of a lane stand next to each other once two registers are interleaved.
  template <int lane>
  [[gnu::always_inline]] static void pair(double* place, const Pack& a, const Pack& b) {
    const __m256d both = lane % 2 == 0 ? _mm256_unpacklo_pd(a.vector(), b.vector())
                                       : _mm256_unpackhi_pd(a.vector(), b.vector());
    _mm_storeu_pd(place, lane < 2 ? _mm256_castpd256_pd128(both) : _mm256_extractf128_pd(both, 1));
  }

  template <int lane>
  [[gnu::always_inline]] static void single(double* place, const Pack& a) {
    const __m128d half = lane < 2 ? _mm256_castpd256_pd128(a.vector()) : _mm256_extractf128_pd(a.vector(), 1);
    if (lane % 2 == 0)
      _mm_storel_pd(place, half);
    else
      _mm_storeh_pd(place, half);
  }

  template <int lane, int joint>
  [[gnu::always_inline]] static void joints(double* place, const Pack (&q)[dof]) {
    if constexpr (joint + 1 < dof) {
      pair<lane>(place + joint, q[joint], q[joint + 1]);
      joints<lane, joint + 2>(place, q);
    } else if constexpr (joint < dof) {
      single<lane>(place + joint, q[joint]);
    }
  }

  template <int lane>
  [[gnu::always_inline]] static void row(double* place, const Pack (&q)[dof], const Pack& end) {
    joints<lane, 0>(place, q);
    single<lane>(place + dof, end);
  }

  double* next_;
  std::ptrdiff_t stride_;
  int rows_ = 0;
  bool continuum_ = false;
};

}  // namespace qvgen::inverse::avx2
