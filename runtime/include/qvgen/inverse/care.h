// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/target.h>
#include <qvgen/inverse/visited.h>

namespace qvgen::inverse {

/// Every preferred angle further by a 16th of a turn, and slides elsewhere in reach.
template <int dof>
Preference<dof> next_choice(Preference<dof> preference) {
  const Rotor<double> turn{0x1.d906bcf328d46p-1, 0x1.87de2a6aea963p-2};
  for (int i = 0; i < dof; ++i) {
    preference.choose(i, turn * preference.turn[i]);
    preference.angle[i] = angle(preference.turn[i]);
  }
  const Rotor<double> half_of_it{0x1.f6297cff75cb0p-1, 0x1.8f8b83c69a60ap-3};
  preference.spread = half_of_it * preference.spread;
  return preference;
}

/// Solves near singular poses. `follow(target, visited, found)` is one pass over all branches that may exist, polished; it
/// returns whether it met a free angle, or one that is nearly so: what such an angle is told to be may be noise, and out of
/// reach for the joints after it, so that branches without a solution are followed again with a choice in its place. If there
/// is nothing at all the free angles are chosen anew.
template <int dof, class Target, class Visited, int capacity, class Follow>
void solve_carefully(Target t, Visited visited, const Follow& follow, Solutions<dof, capacity>& found) {
  constexpr int choices = 16;
  Preference<dof> preference = *t.preference;
  t.preference = &preference;
  const auto pass = [&](const Boundary& boundary) {
    t.boundary = boundary;
    visited.begin_pass();
    return follow(t, visited, found);
  };
  for (int k = 0; k < choices && found.empty(); ++k) {
    const bool met_free = pass(Boundary::careful(t.tolerance));
    if (met_free) pass(Boundary::choosing(t.tolerance));
    if (visited.misses_any()) pass(Boundary::apart(t.tolerance));
    if (visited.misses_any()) pass(Boundary::tolerant(t.tolerance));
    if (!met_free) break;
    preference = next_choice(preference);
    // What the arm has been brought to before may be where a wrist cannot follow: that settles nothing for other choices.
    visited = Visited();
  }
  sort_by_branch(found);
}

}  // namespace qvgen::inverse
