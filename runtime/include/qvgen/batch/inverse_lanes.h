// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/lanes.h>
#include <qvgen/inverse/lane_scalar.h>
#include <qvgen/inverse/reach_test.h>
#include <qvgen/inverse/target.h>

#define QVGEN_LANES [[gnu::always_inline]] inline

// One pose a lane for the blocks of the inverse kinematics. Only for sources that are compiled for the set.
namespace qvgen::inverse {

/// Single calls take them.
template <class Set>
inline constexpr bool leaves_singular_poses<simd::Lanes<double, Set>> = true;

}  // namespace qvgen::inverse

namespace qvgen::batch {

/// Lanes of doubles in the instruction set that this source is compiled for.
using Doubles = Lanes<double, Compiled>;

}  // namespace qvgen::batch

namespace qvgen::simd {
QVGEN_ARCTANGENTS_OF(batch::Doubles)
}  // namespace qvgen::simd

namespace qvgen::batch {

/// Poses side by side, one a lane: x, y, z, w of the quaternion, and the position.
template <class Lane>
struct LanePoses {
  Lane quaternion[4];
  Lane position[3];
};

// As for one pose (inverse/target.h, inverse/reach_test.h), operation by operation.

template <class Lane>
QVGEN_LANES Lane unit_excess(const LanePoses<Lane>& pose) {
  const Lane* q = pose.quaternion;
  return ((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3])) - Lane(1);
}
/// The branch that all begin with: it exists where the pose may be in reach, and is doubtful where the pose
/// is invalid.
template <class Lane>
QVGEN_LANES inverse::Branch<Lane> reach_test(const LanePoses<Lane>& pose, const Lane& excess, double farthest,
                                             double tolerance) {
  const Lane* p = pose.position;
  const Lane distance = (p[1] * p[1] + p[2] * p[2]) + p[0] * p[0];
  const double square = farthest * farthest;
  const auto is_unit = magnitude(excess) <= Lane(unit_tolerance<double>());
  const auto is_near = distance <= Lane(square * (1 + inverse::tolerance::reach_rounding) +
                                        inverse::tolerance::reach_per_tolerance * square * tolerance);
  const auto is_finite = distance < Lane(std::numeric_limits<double>::infinity());
  inverse::Branch<Lane> branch;
  branch.exists = is_unit & is_near;
  branch.doubtful = !(is_unit & is_finite);
  return branch;
}

}  // namespace qvgen::batch

namespace qvgen::inverse {

/// Mask of lanes whose value is out of range. `inverse::is_out_of_range` answers once for a whole pose; here
/// each lane has its own answer.
template <class Set>
QVGEN_LANES simd::Mask<double, Set> is_out_of_range(const simd::Lanes<double, Set>& middle,
                                                    const simd::Lanes<double, Set>& swing,
                                                    const Boundary& boundary) {
  using Lane = simd::Lanes<double, Set>;
  const Lane off = magnitude(middle - Lane(0.5));
  const Lane half = Lane(0.5 + tolerance::swing_at_double_root) + Lane(boundary.beyond);
  const Lane same_end = off - half;
  const Lane both_ends = off + half;
  return ((same_end > Lane(0.0)) & (same_end * same_end > swing)) | (both_ends * both_ends < swing);
}

}  // namespace qvgen::inverse

// The angle of a direction is turned from the nearest axis, beyond which it never goes: less than -pi it is
// nowhere, and -pi changes its sign as a whole.

namespace qvgen::simd {

QVGEN_LANES batch::Doubles output_angle(const inverse::Rotor<batch::Doubles>& rotor,
                                        const batch::Doubles& length, const batch::Doubles& pi) {
  const batch::Doubles value = arctangent(rotor.sine, rotor.cosine, length);
  return negated(value <= -pi, value);
}
QVGEN_LANES inverse::Opposites<batch::Doubles> output_angles(const inverse::Rotor<batch::Doubles>& rotor,
                                                             const batch::Doubles& length,
                                                             const batch::Doubles& pi) {
  const inverse::Opposites<batch::Doubles> value = opposite_arctangents(rotor.sine, rotor.cosine, length, pi);
  return {negated(value.one <= -pi, value.one), negated(value.other <= -pi, value.other)};
}
/// Returns the negative of an angle in [0, pi]; pi stays pi.
QVGEN_LANES batch::Doubles negative(const batch::Doubles& angle, const batch::Doubles& pi) {
  return negated(angle < pi, angle);
}

}  // namespace qvgen::simd

#undef QVGEN_LANES
