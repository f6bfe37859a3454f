// SPDX-License-Identifier: MIT
#include "limits.h"

#include <array>

namespace qvgen::inverse::arm_angle {

namespace {

unsigned within(const Decomposition& joints, const Ranges& ranges) {
  unsigned bits = 0;
  for (int i = 0; i < joints.count; ++i)
    if (ranges.admit(joints.turns[i])) bits |= 1U << i;
  return bits;
}

}  // namespace

Fitting fitting(const ThreeTurns& three, const Ranges& ranges, const Matrix3<double>& rotation, double choice,
                double fold) {
  Fitting found{three.solve(rotation, choice, fold), 0};
  found.within = within(found.joints, ranges);
  if (!found.joints.free || found.within != 0) return found;
  // First and last angle move by the same or by opposite amounts: where both can be within their limits, they
  // can with one of them next to one of its own.
  constexpr double inside = 1e-9;
  const Turns& at = found.joints.turns[0];
  const double sense =
      turn_between(at.last, three.solve(rotation, choice + 1, fold).turns[0].last) < 0 ? -1 : 1;
  const auto from_last = [&](double last) { return choice + sense * (last - at.last); };
  const std::array<double, 4> candidates{ranges.first.lower + inside, ranges.first.upper - inside,
                                         from_last(ranges.last.lower + inside),
                                         from_last(ranges.last.upper - inside)};
  for (const double first : candidates) {
    if (!(std::abs(first) < 1e6)) continue;
    const Decomposition other = three.solve(rotation, first, fold);
    if (within(other, ranges) == 0) continue;
    found = {other, within(other, ranges)};
    break;
  }
  return found;
}

}  // namespace qvgen::inverse::arm_angle
