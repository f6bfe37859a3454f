// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/path/newton.h>

/// Places on the way of a solution at which a value is on a limit, a joint's or a motor's (coupling.h).
namespace qvgen::path {

/// Brings the point, which is at `a`, to where a limited value lies between those of `a` and `b`: joints
/// across its gradient and the place are unknown. False if Newton's steps lead to no point between them.
template <class Arm, class Coupling>
bool settle_on(const Equations<Arm>& equations, const Coupling& coupling, const Values& a, const Values& b,
               int limited, double value, double to, Point& at) {
  const double first = coupling.of(a)[limited], last = coupling.of(b)[limited];
  const double share = (value - first) / (last - first), from = at.u;
  if (!(share > 0 && share < 1)) return false;
  at = {a + share * (b - a), from + share * (to - from)};
  coupling.put(limited, value, at.q);
  const Values guess = at.q;
  Direction across = Direction::Zero();
  across.template head<6>() = coupling.gradient(limited);
  return equations.settle_across(at, across) && at.u >= from && at.u <= to &&
         (at.q - guess).cwiseAbs().maxCoeff() < (b - a).cwiseAbs().maxCoeff();
}

/// Returns the place where a limited value lies between its values at two places; the first one if it was
/// there within the slack.
template <class Coupling, class Solve>
double place_on(const Coupling& coupling, const Values& a, const Values& b, int limited, double value,
                const Solve& solve, double from, double to) {
  double low = from, high = to, at_low = coupling.of(a)[limited] - value,
         at_high = coupling.of(b)[limited] - value;
  if ((at_low > 0) == (at_high > 0)) return from;
  for (int i = 0; i < 80 && high - low > 1e-13; ++i) {
    const double secant = low + (high - low) * at_low / (at_low - at_high);
    const double place = i % 3 == 2 || !(secant > low && secant < high) ? 0.5 * (low + high) : secant;
    const Values guess = a + (place - from) / (to - from) * (b - a);
    const double off = coupling.of(solve(place, guess))[limited] - value;
    if (off == 0) return place;
    (off > 0) == (at_low > 0) ? (low = place, at_low = off) : (high = place, at_high = off);
  }
  return 0.5 * (low + high);
}

}  // namespace qvgen::path
