// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/roots.h>
#include <qvgen/inverse/rows.h>
#include <qvgen/inverse/target.h>
#include <qvgen/unit_tolerance.h>

/// Test of a pose before any branch is followed: invalid, farther away than the arm is long, or open. It
/// costs less than the first equation, and needs neither Eigen nor a root.
namespace qvgen::inverse {

/// Answer that a pose alone allows, before any branch is followed.
enum class ReachTest {
  open,  ///< branches have to tell
  unreachable,
  invalid  ///< not a rotation, not finite, or too large to be squared
};

/// Returns the row count of lanes if no branch is followed.
[[gnu::always_inline]] inline RowCount no_rows(ReachTest reach_test) {
  return {reach_test == ReachTest::unreachable ? 0 : -1, false};
}

/// How far the square of a pose's quaternion is from 1.
[[gnu::always_inline]] inline double unit_excess(const PoseNumbers& pose) {
  const double* q = pose.quaternion;
  return ((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3])) - 1;
}

/// By the pose's quaternion, and by the distance that the arm's tool cannot exceed, rounding and tolerance
/// (up to 1) allowed for.
[[gnu::always_inline]] inline ReachTest reach_test(const PoseNumbers& pose, double excess, double farthest,
                                                   double tolerance) {
  constexpr double unit = unit_tolerance<double>();
  const double* p = pose.position;
  const double distance = (p[1] * p[1] + p[2] * p[2]) + p[0] * p[0];
  const double square = farthest * farthest;
  if (!(magnitude(excess) <= unit)) return ReachTest::invalid;
  if (distance <=
      square * (1 + tolerance::reach_rounding) + tolerance::reach_per_tolerance * square * tolerance)
    return ReachTest::open;
  return distance < std::numeric_limits<double>::infinity() ? ReachTest::unreachable : ReachTest::invalid;
}

}  // namespace qvgen::inverse
