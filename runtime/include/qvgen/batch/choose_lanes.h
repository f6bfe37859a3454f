// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>

#include <qvgen/batch/inverse_lanes.h>
#include <qvgen/batch/wanted.h>
#include <qvgen/inverse/within_table.h>

#define QVGEN_INLINE [[gnu::always_inline]]

namespace qvgen::batch {

/// Limits and a seed for each lane, as `inverse::Within` has them. Operation by operation as there and in
/// lanes of branches (inverse/wanted_rows_avx2.h), so that rows have the bits and the order of single calls.
template <class Lane, int dof>
class LaneSeeds {
 public:
  using Truth = inverse::Mask<Lane>;

  QVGEN_INLINE explicit LaneSeeds(const WantedSolutions& wanted) {
    Lane sum = 0.0;
    for (int i = 0; i < dof; ++i) {
      seed_[i] = Lane::load(wanted.seeds.data + static_cast<std::size_t>(i) * wanted.seeds.stride);
      sum += Lane(0.0) * seed_[i];
      per_turn_[i] = wanted.revolute[i] ? 1 / inverse::whole_turn : 0;
      set_limits(i, wanted.lower[i], wanted.upper[i]);
    }
    is_finite_ = sum == Lane(0.0);
  }

  [[nodiscard]] QVGEN_INLINE const Truth& is_finite() const { return is_finite_; }

  /// Puts the representatives next to the seeds in place of a row, and the squares of their distances in
  /// `square`. Returns which are inside.
  QVGEN_INLINE Truth take(Lane (&q)[dof], Lane& square) const {
    const Lane rounds = 0x1.8p52, turn = inverse::whole_turn;
    Lane sums[4] = {0.0, 0.0, 0.0, 0.0}, farthest = 0.0;
    for (int i = 0; i < dof; ++i) {
      const Lane per_turn = per_turn_[i];
      const Lane middle = smaller(larger(seed_[i], Lane(least_[i])), Lane(most_[i]));
      const Lane value = q[i] + turn * ((((middle - q[i]) * per_turn) + rounds) - rounds);
      q[i] = smaller(larger(value, Lane(lower_[i])), Lane(upper_[i]));
      farthest = larger(farthest, magnitude(q[i] - value));
      const Lane off = q[i] - seed_[i];
      sums[i % 4] = sums[i % 4] + off * off;
    }
    square = (sums[0] + sums[2]) + (sums[1] + sums[3]);
    return farthest <= Lane(limit_tolerance);
  }

 private:
  QVGEN_INLINE void set_limits(int i, double lower, double upper) {
    constexpr double far = inverse::tolerance::farthest_joint,
                     half = 0.5 * inverse::whole_turn - limit_tolerance;
    const bool is_range = lower <= upper && lower < far && upper > -far;
    lower_[i] = is_range ? lower : far;
    upper_[i] = is_range ? upper : -far;
    const double bottom = lower_[i] > -far ? lower_[i] : -far, top = upper_[i] < far ? upper_[i] : far;
    const double centre = 0.5 * (bottom + top), least = lower_[i] + half, most = upper_[i] - half;
    least_[i] = least < centre ? least : centre;
    most_[i] = most > centre ? most : centre;
  }

  Truth is_finite_;
  Lane seed_[dof];
  double per_turn_[dof], lower_[dof], upper_[dof], least_[dof], most_[dof];
};

/// Puts the wanted rows of each lane in order, in their memory: `q` has `capacity` rows of `dof` joints,
/// those that exist in front. `labels` are put in order too, and `count` becomes what is wanted. Returns the
/// lanes whose poses have to be looked at alone.
template <class Lane, int dof, int capacity>
QVGEN_INLINE inline inverse::Mask<Lane> choose_rows(const WantedSolutions& wanted, const Batch<double>& q,
                                                    Lane (&labels)[capacity], Lane& count) {
  using Truth = inverse::Mask<Lane>;
  constexpr int lanes = Lane::size;
  const LaneSeeds<Lane, dof> seeds(wanted);
  double rows[capacity * dof * lanes], branches[capacity * lanes], places[capacity * lanes];
  Lane keys[capacity], kept = 0.0;
  const Lane nothing = std::numeric_limits<double>::quiet_NaN();
  for (int s = 0; s < capacity; ++s) {
    Lane row[dof], square;
    for (int i = 0; i < dof; ++i)
      row[i] = Lane::load(q.data + static_cast<std::size_t>(s * dof + i) * q.stride);
    const Truth stays = seeds.take(row, square) & (Lane(s) < count);
    for (int i = 0; i < dof; ++i) select(stays, row[i], nothing).store(rows + (s * dof + i) * lanes);
    select(stays, labels[s], Lane(-1.0)).store(branches + s * lanes);
    const Lane farthest = std::numeric_limits<double>::max(), none = std::numeric_limits<double>::infinity();
    keys[s] = select(stays, smaller(square, farthest), none);
    kept += select(stays, Lane(1.0), Lane(0.0));
  }
  for (int s = 0; s < capacity; ++s) {
    Lane place = 0.0;
    for (int k = 0; k < capacity; ++k) {
      if (k == s) continue;
      place += select(k < s ? keys[k] <= keys[s] : keys[k] < keys[s], Lane(1.0), Lane(0.0));
    }
    place.store(places + s * lanes);
  }
  double in_order[capacity * lanes];
  for (int s = 0; s < capacity; ++s)
    for (int lane = 0; lane < lanes; ++lane) {
      const int place = static_cast<int>(places[s * lanes + lane]);
      in_order[place * lanes + lane] = branches[s * lanes + lane];
      double* to = q.data + static_cast<std::size_t>(place * dof) * q.stride + lane;
      for (int i = 0; i < dof; ++i, to += q.stride) *to = rows[(s * dof + i) * lanes + lane];
    }
  for (int s = 0; s < capacity; ++s) labels[s] = Lane::load(in_order + s * lanes);
  // A solution may still be brought inside where there are some, none of them inside.
  const Truth is_empty = (kept == Lane(0.0)) & (Lane(0.0) < count);
  count = kept;
  return (!seeds.is_finite()) | is_empty;
}

}  // namespace qvgen::batch

#undef QVGEN_INLINE
