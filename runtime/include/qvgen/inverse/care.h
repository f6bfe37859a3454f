// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/inverse/polish.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/target.h>

namespace qvgen::inverse {

/// Every preferred angle further by a 16th of a turn.
template <int dof>
Preference<dof> next_choice(Preference<dof> preference) {
  const Rotor<double> turn{0x1.d906bcf328d46p-1, 0x1.87de2a6aea963p-2};
  for (int i = 0; i < dof; ++i) {
    preference.choose(i, turn * preference.turn[i]);
    preference.angle[i] = angle(preference.turn[i]);
  }
  return preference;
}

/// Solves near singular poses. `follow(target, visited, found)` is one pass over all branches that may exist, polished;
/// it returns whether it met a free angle, or one that is nearly so: what that is told to be may be noise, and out of reach for the
/// joints after it, so that branches without a solution are followed again with a choice in its place. Branches that come to nothing from the ends of their ranges are followed again from
/// two places apart; and if there is nothing at all, the free angles are chosen anew, for joints after them may then be in reach.
template <int dof, class Target, class Visited, int capacity, class Follow>
void solve_carefully(Target t, Visited visited, const Follow& follow, Solutions<dof, capacity>& found) {
  constexpr int choices = 16;
  Preference<dof> preference = *t.preference;
  t.preference = &preference;
  for (int k = 0; k < choices && found.empty(); ++k) {
    t.boundary = Boundary::careful(t.tolerance);
    visited.begin_pass();
    const bool met_free = follow(t, visited, found);
    t.boundary = Boundary::choosing(t.tolerance);
    if (met_free) follow(t, visited, found);
    t.boundary = Boundary::apart(t.tolerance);
    if (visited.misses_any()) follow(t, visited, found);
    if (!met_free) break;
    preference = next_choice(preference);
  }
  sort_by_branch(found);
}

}  // namespace qvgen::inverse
