// SPDX-License-Identifier: MIT
#include <qvgen/inverse/certified/certify.h>

namespace qvgen::inverse::certified {
namespace {

/// The product of two quaternions w, x, y, z, into b.
void turn_by(const Interval (&a)[4], Interval (&b)[4]) {
  const Interval w = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  const Interval x = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  const Interval y = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  const Interval z = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
  b[0] = w;
  b[1] = x;
  b[2] = y;
  b[3] = z;
}

}  // namespace

Arm without_joint(const ArmInBounds<joints + 1>& arm, int still, double value) {
  const Screw<Interval>& held = arm.joints[still];
  const SineCosine angle = sine_cosine(value), half = sine_cosine(value / 2);
  const Rotor<Interval> motion =
      held.revolute ? Rotor<Interval>{angle.cosine, angle.sine} : Rotor<Interval>{value, 0.0};
  Arm rest;
  for (int i = 0; i < joints; ++i) {
    Screw<Interval>& joint = rest.joints[i];
    joint = arm.joints[i < still ? i : i + 1];
    if (i < still) continue;
    if (held.revolute) joint.axis = turned(held, motion, joint.axis);
    joint.point = moved(held, motion, joint.point);
  }
  std::copy(arm.turn, arm.turn + 4, rest.turn);
  if (held.revolute)
    turn_by({half.cosine, half.sine * held.axis[0], half.sine * held.axis[1], half.sine * held.axis[2]},
            rest.turn);
  rest.place = moved(held, motion, arm.place);
  return rest;
}

}  // namespace qvgen::inverse::certified
