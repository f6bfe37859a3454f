// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <qvgen/inverse/joint_limits.h>

namespace qvgen::map {

/// Results at one position, over its targets: orientations, or what the arm is asked for instead.
struct Cell {
  std::uint64_t solutions = 0;  ///< of all targets
  std::uint32_t reached = 0;    ///< targets that have one
  std::uint32_t most = 0;       ///< solutions of one target
  double manipulability = 0;    ///< the largest of all solutions, product of the Jacobian's singular values
  /// The largest of all solutions (see `limit_distance`); NaN without solutions, or without limits.
  double limit_distance = std::numeric_limits<double>::quiet_NaN();

  void see(double volume, double distance) {
    manipulability = std::max(manipulability, volume);
    if (!(distance <= limit_distance)) limit_distance = distance;
  }
};
static_assert(sizeof(Cell) == 32, "cells go to files as they stand");

/// The ranges of the joints that have two limits; whole turns of a revolute joint count.
template <int dof>
class Ranges {
 public:
  Ranges(const std::array<double, dof>& lower, const std::array<double, dof>& upper,
         const std::array<bool, dof>& revolute)
      : revolute_(revolute) {
    for (std::size_t i = 0; i < dof; ++i) {
      middle_[i] = 0.5 * (lower[i] + upper[i]);
      half_[i] = 0.5 * (upper[i] - lower[i]);
      if (std::isfinite(half_[i])) some_ = true;
    }
  }
  [[nodiscard]] bool some() const { return some_; }

  /// How far the joints are from their limits, as shares of half their ranges, of the joint that is nearest
  /// to one: 1 in the middle of all, 0 at a limit, less beyond it. NaN if no joint has limits.
  template <class Joints>
  [[nodiscard]] double limit_distance(const Joints& q) const {
    double least = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < dof; ++i) {
      if (!std::isfinite(half_[i])) continue;
      const double off = q(i) - middle_[i];
      const double distance = 1 - std::abs(revolute_[i] ? without_turns(off) : off) / half_[i];
      if (!(distance >= least)) least = distance;
    }
    return least;
  }

 private:
  std::array<double, dof> middle_{}, half_{};
  std::array<bool, dof> revolute_;
  bool some_ = false;
};

}  // namespace qvgen::map
