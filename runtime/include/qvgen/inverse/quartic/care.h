// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/inverse/quartic/visited.h>
#include <qvgen/inverse/seed.h>
#include <qvgen/inverse/solutions.h>

namespace qvgen::inverse::quartic {

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

/// A pose, and how far the joint whose value is given, if there is one, is held from that value.
struct Place {
  Pose<double> pose;
  double further = 0;  ///< rad or m
};

/// A pose moved and turned a little, another way for every k: the fractional parts of multiples of square
/// roots of primes are spread evenly.
inline Place displaced(const Pose<double>& pose, double size, int k) {
  constexpr double share = 1e-4;
  constexpr double roots[] = {1.4142135623730951, 1.7320508075688772, 2.23606797749979, 2.6457513110645906,
                              3.3166247903554,    3.605551275463989,  4.123105625617661};
  double by[7];
  for (int i = 0; i < 7; ++i) {
    const double multiple = (k + 1) * roots[i];
    by[i] = share * (2 * (multiple - std::floor(multiple)) - 1);
  }
  Pose<double> moved = pose;
  moved.position += size * Vector3<double>(by[0], by[1], by[2]);
  moved.orientation = (Eigen::Quaterniond(1, by[3], by[4], by[5]) * pose.orientation).normalized();
  return {moved, by[6]};
}

/// Solves near singular poses. `follow(start, goal, visited, found)` is one pass over all branches that may
/// exist at one target, polished towards another; it returns whether it met something free, or nearly so:
/// what that is told to be may be noise, and out of reach for the joints after it, so that branches without a
/// solution are followed again with a choice in its place. What is then still missing is looked for from
/// poses nearby, where nothing is free, and, where a wrist cannot follow to what has been chosen or there is
/// nothing at all, with other choices. `aimed(place)` is the target of a pose. Whatever is chosen on the way,
/// the goal's preference stays the caller's: a continuum is to be left next to the seed. `held`: an arm with
/// a given joint has another structure at some of its values (axes that are parallel at zero), where the
/// elimination divides by zero; it does not at values nearby. `always`: an arm whose poses all come here, a
/// quartic's, of which the roots have to be polished.
template <int dof, class Aim, class Visited, int capacity, class Follow>
void solve_carefully(const Pose<double>& pose, const Aim& aimed, Visited visited, const Follow& follow,
                     Solutions<dof, capacity>& found, bool held, bool always) {
  auto goal = aimed(Place{pose});
  Preference<dof> preference = *goal.preference;
  const auto pass_from = [&](auto start, const Boundary& boundary, const Boundary& at_goal) {
    if (!visited.budget().pass()) return false;
    start.boundary = boundary;
    start.preference = &preference;
    goal.boundary = at_goal;
    return follow(start, goal, visited, found);
  };
  const auto pass = [&](const Boundary& boundary) { return pass_from(goal, boundary, boundary); };
  const Boundary careful = Boundary::careful(goal.tolerance);
  const Boundary choosing = Boundary::choosing(goal.tolerance);
  // If every pose comes here, the first pass says nothing about singular poses.
  const int regular = always ? 1 : 0;
  visited.budget().passes += regular;
  bool met_free = pass(careful);
  met_free = met_free || visited.left_any();
  if (met_free) pass(choosing);
  if (visited.left_any()) pass(Boundary::taking(goal.tolerance));
  if (visited.misses_any()) pass(Boundary::apart(goal.tolerance));
  if (has_continuum(found)) {
    visited.follow_again(true);
    pass(choosing.in_other_range());
    visited.follow_again(false);
  }
  const bool strays = visited.strays_any();
  const auto from_nearby = [&](int k, const Boundary& at_goal) {
    pass_from(aimed(displaced(pose, std::sqrt(goal.size_square), k)), careful, at_goal);
  };
  for (int k = 0; visited.strays_any() && k < 12; ++k) from_nearby(k, choosing);
  constexpr int few = 4;
  for (int k = 0; visited.shares_any() && k < few; ++k) from_nearby(k, choosing);
  visited.settle_shared();
  const bool divides_by_zero = held && found.empty();
  for (int k = 0; held && (found.empty() || visited.misses_any()) && k < few; ++k) from_nearby(k, choosing);
  const Boundary tolerant = Boundary::tolerant(goal.tolerance);
  if (visited.misses_any()) pass(tolerant);
  for (int k = 0; divides_by_zero && visited.misses_any() && k < few; ++k) from_nearby(k, tolerant);
  const bool is_free = met_free || strays;
  constexpr int choices = 16;
  for (int k = 0; (is_free && found.empty() && k < 60) || (visited.turned_back_any() && k < choices); ++k) {
    preference = quartic::next_choice(preference);
    from_nearby(k, choosing);
    pass(found.empty() && k < choices / 2 ? Boundary::reaching(goal.tolerance) : choosing);
  }
  found.effort = visited.budget().spent;
  found.effort.passes -= regular;
  number_apart(found);
  sort_by_branch(found);
}

}  // namespace qvgen::inverse::quartic
