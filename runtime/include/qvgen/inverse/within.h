// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <qvgen/inverse/within_table.h>

/// Joint limits, made ready to be compared with many rows.
///
/// A revolute joint at q may as well be at q + 2 pi k. Wanted is the k that brings it inside and, if several
/// do, nearest to a seed. That is always the whole number next to (m - q) / 2 pi for one angle m of the
/// joint:
///
///     limits less than a turn apart:   m in the middle: nothing else can be inside
///     else:                            m is the seed, moved half a turn away from the limits if it is
///     nearer:
///
///         lower    seed     m                        upper
///           |-------+-------+--------------------------|
///           <---- half ----> <---- half ---->             all within half a turn of m are inside
///
/// So one rounded quotient decides, without a jump, and several joints are compared at once.
namespace qvgen {

template <int dof>
using Joints = Eigen::Matrix<double, dof, 1>;

/// Which joints are revolute; generated code has it as `is_revolute`.
template <int dof>
using JointKinds = std::array<bool, static_cast<std::size_t>(dof)>;

/// Lower and upper bounds, rad or m; infinite where there is none. Generated code has the description's as
/// `Limits`.
template <int dof>
struct JointLimits {
  Joints<dof> lower;
  Joints<dof> upper;
};

namespace inverse {

/// The whole numbers next to some quotients of less than 2^51: adding and subtracting a large number rounds,
/// some thirty times as fast as std::rint where that is a call.
template <class Quotients>
auto nearest_whole(const Quotients& quotients) {
  constexpr double rounds = 0x1.8p52;
  return (quotients + rounds) - rounds;
}

/// Limits of an arm next to a seed.
template <int dof>
class Within {
 public:
  /// How many numbers a table has for each kind.
  static constexpr int size = dof <= 8 ? 8 : (dof + 1) / 2 * 2;

  template <std::size_t count>
  Within(const JointLimits<dof>& limits, const std::array<bool, count>& revolute, const Joints<dof>& seed) {
    for (int i = dof; i < size; ++i)
      table_.lower[i] = table_.upper[i] = table_.seed[i] = table_.middle[i] = table_.turn[i] =
          table_.per_turn[i] = 0;
    for (int i = 0; i < dof; ++i) {
      // Limits that are not a range admit nothing: no value is between these.
      const bool is_range =
          limits.lower[i] <= limits.upper[i] && limits.lower[i] < far && limits.upper[i] > -far;
      table_.lower[i] = is_range ? limits.lower[i] : far;
      table_.upper[i] = is_range ? limits.upper[i] : -far;
      const bool turns = revolute[static_cast<std::size_t>(i)];
      table_.turn[i] = turns ? whole_turn : 0;
      table_.per_turn[i] = turns ? 1 / whole_turn : 0;
    }
    look_from(seed);
  }

  /// Returns these limits next to another seed.
  [[nodiscard]] Within next_to(const Joints<dof>& seed) const {
    Within other = *this;
    other.look_from(seed);
    return other;
  }

  /// Puts the representative of a row that is inside and nearest to the seed in its place. Returns false if
  /// some joint has none; the row is then useless.
  [[gnu::always_inline]] bool take(Joints<dof>& q) const {
    double square = 0;
    return take(q, square);
  }
  /// Brings a row inside, as above, and sets the square of its distance from the seed.
  [[gnu::always_inline]] bool take(Joints<dof>& q, double& square) const {
    Row row;
    if constexpr (dof < pairs) row[pairs - 1] = 0;
    row.template head<dof>() = q.array();
    const Row value = row + of(table_.turn) * nearest_whole((of(table_.middle) - row) * of(table_.per_turn));
    const Row inside = value.max(of(table_.lower)).min(of(table_.upper));
    const Row off = (inside - of(table_.seed)).square();
    double sums[4] = {};
    for (int i = 0; i < pairs; ++i) sums[i % 4] += off[i];
    square = (sums[0] + sums[2]) + (sums[1] + sums[3]);
    q = inside.template head<dof>().matrix();
    return (inside - value).abs().maxCoeff() <= limit_tolerance;
  }

  [[nodiscard]] const WithinTable<size>& table() const { return table_; }

 private:
  /// Joints in pairs, for vectors of two.
  static constexpr int pairs = (dof + 1) / 2 * 2;
  using Row = Eigen::Array<double, pairs, 1>;

  static Eigen::Map<const Row> of(const double (&numbers)[size]) { return Eigen::Map<const Row>(numbers); }

  /// Farther than any joint, and small enough to be added.
  static constexpr double far = tolerance::farthest_joint;

  [[gnu::always_inline]] void look_from(const Joints<dof>& seed) {
    std::copy(seed.data(), seed.data() + dof, table_.seed);
    constexpr double half = 0.5 * whole_turn - limit_tolerance;
    const auto lower = of(table_.lower), upper = of(table_.upper);
    const Row centre = 0.5 * (lower.max(-far) + upper.min(far));
    const Row least = (lower + half).min(centre);
    const Row most = (upper - half).max(centre);
    const Row from = seed.allFinite() ? Row(of(table_.seed)) : Row(Row::Zero());
    Eigen::Map<Row>(table_.middle) = from.max(least).min(most);
  }

  WithinTable<size> table_;
};

}  // namespace inverse
}  // namespace qvgen
