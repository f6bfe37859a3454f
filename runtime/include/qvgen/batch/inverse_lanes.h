// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/masks.h>
#include <qvgen/inverse/reach_test.h>
#include <qvgen/inverse/target.h>

#define QVGEN_LANES [[gnu::always_inline]] inline

// One pose a lane for the blocks of the inverse kinematics. Only for sources that are compiled for the set.
namespace qvgen::inverse {

template <class Set>
struct ScalarTraits<batch::Lanes<double, Set>> {
  using Mask = batch::LaneMask<Set>;
  [[gnu::always_inline]] static batch::Lanes<double, Set> epsilon() { return 0x1p-52; }
};

/// Single calls take them.
template <class Set>
inline constexpr bool leaves_singular_poses<batch::Lanes<double, Set>> = true;

}  // namespace qvgen::inverse

namespace qvgen::batch {

/// Lanes of doubles in the instruction set that this source is compiled for.
using Doubles = Lanes<double, Compiled>;

// No templates: GCC 12 does not always inline what those call.
QVGEN_LANES Doubles arctangent(const Doubles& y, const Doubles& x) {
  return inverse::polynomial::arctangent(y, x);
}

/// As inverse::polynomial::tangent; of `sign` the sign bit alone is read, so the other bits may be anything.
QVGEN_LANES inverse::polynomial::Tangent<Doubles> tangent(const Doubles& y, const Doubles& x,
                                                          const Doubles& length) {
  const Doubles height = magnitude(y);
  const Doubles width = magnitude(x);
  const Doubles steep = width - height;
  const Doubles axis = select_by_sign(steep, Doubles(0x1.921fb54442d18p+0),
                                      select_by_sign(x, Doubles(0x1.921fb54442d18p+1), Doubles(0.0)));
  return {with_sign_bit(axis, y), smaller(height, width) / (length + larger(height, width)),
          with_flips_of(with_flips_of(x, y), steep)};
}
QVGEN_LANES Doubles arctangent(const Doubles& y, const Doubles& x, const Doubles& length) {
  const auto found = tangent(y, x, length);
  return inverse::polynomial::TwiceArctangent<Doubles>(found).from(found.axis);
}
QVGEN_LANES inverse::Opposites<Doubles> opposite_arctangents(const Doubles& y, const Doubles& x,
                                                             const Doubles& length, const Doubles& pi) {
  const auto found = tangent(y, x, length);
  const inverse::polynomial::TwiceArctangent<Doubles> angle(found);
  return {angle.from(found.axis), angle.from(found.axis - with_sign_bit(pi, y))};
}
QVGEN_LANES Doubles acute_arctangent(const Doubles& y, const Doubles& x) {
  return inverse::polynomial::acute_arctangent(y, x);
}

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
  const auto is_near = distance <= Lane(square * (1 + 1e-6) + 80 * square * tolerance);
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
QVGEN_LANES batch::LaneMask<Set> is_out_of_range(const batch::Lanes<double, Set>& middle,
                                                 const batch::Lanes<double, Set>& swing,
                                                 const Boundary& boundary) {
  using Lane = batch::Lanes<double, Set>;
  const Lane off = magnitude(middle - Lane(0.5));
  const Lane half = Lane(0.5) + Lane(boundary.beyond);
  const Lane same_end = off - half;
  const Lane both_ends = off + half;
  return ((same_end > Lane(0.0)) & (same_end * same_end > swing)) | (both_ends * both_ends < swing);
}

}  // namespace qvgen::inverse

// The angle of a direction is turned from the nearest axis, beyond which it never goes: less than -pi it is
// nowhere, and -pi changes its sign as a whole.

namespace qvgen::batch {

QVGEN_LANES Doubles output_angle(const inverse::Rotor<Doubles>& rotor, const Doubles& length,
                                 const Doubles& pi) {
  const Doubles value = arctangent(rotor.sine, rotor.cosine, length);
  return negated(value <= -pi, value);
}
QVGEN_LANES inverse::Opposites<Doubles> output_angles(const inverse::Rotor<Doubles>& rotor,
                                                      const Doubles& length, const Doubles& pi) {
  const inverse::Opposites<Doubles> value = opposite_arctangents(rotor.sine, rotor.cosine, length, pi);
  return {negated(value.one <= -pi, value.one), negated(value.other <= -pi, value.other)};
}
/// Returns the negative of an angle in [0, pi]; pi stays pi.
QVGEN_LANES Doubles negative(const Doubles& angle, const Doubles& pi) { return negated(angle < pi, angle); }

}  // namespace qvgen::batch

#undef QVGEN_LANES
