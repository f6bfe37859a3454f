// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/pack_avx2.h>

namespace qvgen::inverse::avx2 {

/// A lane's number as a type.
template <int number>
struct Lane {
  static constexpr int value = number;
};

/// Writes lanes as rows, those that exist, one close behind the other: a row that does not exist is written too and
/// overwritten by the next, so that there is no jump.
template <int dof>
class LaneRows {
 public:
  [[gnu::always_inline]] explicit LaneRows(RowPlaces places) : next_(places.first), stride_(places.stride) {}

  [[gnu::always_inline]] RowCount count() const { return {rows_, continuum_}; }

  /// One row a lane, branches label, label + 1, ...
  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Branch<Pack>& branch, int label) {
    const int exist = bits(branch.exists);
    const int marked = bits(branch.continuum);
    each_lane([&](auto number) {
      constexpr int lane = decltype(number)::value;
      row<lane>(next_, q, label + lane, marked);
      next_ += stride_ & -static_cast<std::ptrdiff_t>(exist >> lane & 1);
    });
    add(exist, marked, 1);
  }

  /// Two rows a lane that exist or do not exist together.
  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Pack (&twin)[dof], const Branch<Pack>& branch, int label) {
    const int exist = bits(branch.exists);
    const int marked = bits(branch.continuum);
    each_lane([&](auto number) {
      constexpr int lane = decltype(number)::value;
      row<lane>(next_, q, label + 2 * lane, marked);
      row<lane>(next_ + stride_, twin, label + 2 * lane + 1, marked);
      next_ += (2 * stride_) & -static_cast<std::ptrdiff_t>(exist >> lane & 1);
    });
    add(exist, marked, 2);
  }

  /// Two rows a lane, each with its own branch.
  [[gnu::always_inline]] void append(const Pack (&q)[dof], const Branch<Pack>& branch, const Pack (&other)[dof], const Branch<Pack>& other_branch,
                                     int label) {
    const int exist[2] = {bits(branch.exists), bits(other_branch.exists)};
    const int marked[2] = {bits(branch.continuum), bits(other_branch.continuum)};
    each_lane([&](auto number) {
      constexpr int lane = decltype(number)::value;
      row<lane>(next_, q, label + 2 * lane, marked[0]);
      next_ += stride_ & -static_cast<std::ptrdiff_t>(exist[0] >> lane & 1);
      row<lane>(next_, other, label + 2 * lane + 1, marked[1]);
      next_ += stride_ & -static_cast<std::ptrdiff_t>(exist[1] >> lane & 1);
    });
    add(exist[0], marked[0], 1);
    add(exist[1], marked[1], 1);
  }

 private:
  template <class Function>
  [[gnu::always_inline]] static void each_lane(const Function& function) {
    function(Lane<0>{});
    function(Lane<1>{});
    function(Lane<2>{});
    function(Lane<3>{});
  }

  [[gnu::always_inline]] void add(int exist, int marked, int rows) {
    rows_ += rows * __builtin_popcount(static_cast<unsigned>(exist));
    continuum_ = continuum_ || (exist & marked) != 0;
  }

  /// Two joints of a lane stand next to each other once two registers are interleaved.
  template <int lane>
  [[gnu::always_inline]] static void pair(double* place, const Pack& a, const Pack& b) {
    const __m256d both = lane % 2 == 0 ? _mm256_unpacklo_pd(a.lanes, b.lanes) : _mm256_unpackhi_pd(a.lanes, b.lanes);
    _mm_storeu_pd(place, lane < 2 ? _mm256_castpd256_pd128(both) : _mm256_extractf128_pd(both, 1));
  }

  template <int lane>
  [[gnu::always_inline]] static void single(double* place, const Pack& a) {
    const __m128d half = lane < 2 ? _mm256_castpd256_pd128(a.lanes) : _mm256_extractf128_pd(a.lanes, 1);
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
  [[gnu::always_inline]] static void row(double* place, const Pack (&q)[dof], int label, int marked) {
    joints<lane, 0>(place, q);
    int* const branch = reinterpret_cast<int*>(place + dof);
    *branch = label;
    *reinterpret_cast<bool*>(branch + 1) = (marked >> lane & 1) != 0;
  }

  double* next_;
  std::ptrdiff_t stride_;
  int rows_ = 0;
  bool continuum_ = false;
};

}  // namespace qvgen::inverse::avx2
