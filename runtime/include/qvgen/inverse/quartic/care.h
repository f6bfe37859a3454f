// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include <qvgen/inverse/nearby.h>
#include <qvgen/inverse/passes.h>
#include <qvgen/inverse/quartic/visited.h>
#include <qvgen/inverse/seed.h>
#include <qvgen/inverse/solutions.h>

namespace qvgen::inverse::quartic {

/// Choices that are made for wrists that cannot follow: all around by sixteenths of a turn.
inline constexpr int most_choices = 16;

using inverse::Place;

/// A search for all solutions of a pose. `follow(start, goal, tracker, found)` is one pass over all branches
/// that may exist at one target, polished towards another; it returns whether it met something free, or
/// nearly so. `aimed(place)` is the target of a pose.
template <int dof, class Target, class Visited, int capacity, class Follow, class Aim>
struct CarefulSearch {
  const Pose<double>& pose;
  const Aim& aimed;
  const Follow& follow;
  Solutions<dof, capacity>& found;
  bool held;
  Target goal;
  Visited tracker;
  Preference<dof> preference = *goal.preference;
  double fold = 0;  ///< see `solve_near_singular`
  bool met_free = false;
  bool strays = false;           ///< a branch came near a continuum, and to no solution of its own on it
  bool divides_by_zero = false;  ///< at the given joint's value, where nothing has been found

  bool pass_from(Target start, const Boundary& boundary, const Boundary& at_goal) {
    if (!tracker.budget().pass()) return false;
    start.boundary = boundary;
    start.preference = &preference;
    goal.boundary = at_goal.folded_by(fold);
    return follow(start, goal, tracker, found);
  }
  bool pass(const Boundary& boundary) { return pass_from(goal, boundary, boundary); }
  void pass_from_nearby(int k, const Boundary& at_goal) {
    pass_from(aimed(displaced(pose, std::sqrt(goal.size_square), k)), Boundary::careful(goal.tolerance),
              at_goal);
  }
};

/// Searches at the pose, then from poses nearby, where nothing is free: near a continuum the joints of a
/// branch may be noise, and the joints after it may be out of reach.
///
/// QuarticPasses.FindWhatOthersLose (tests/inverse/families) fails without `chosen`, and without `other`.
template <class Search>
inline constexpr PlannedPass<Search> first_passes[] = {
    {"ends", 1, [](const Search&, int) { return true; },
     [](Search& search, int) {
       const bool met_free = search.pass(Boundary::careful(search.goal.tolerance));
       search.met_free = met_free || search.tracker.left_any();
     }},
    {"chosen", 1, [](const Search& search, int) { return search.met_free; },
     [](Search& search, int) { search.pass(Boundary::choosing(search.goal.tolerance)); }},
    {"taken", 1, [](const Search& search, int) { return search.tracker.left_any(); },
     [](Search& search, int) { search.pass(Boundary::taking(search.goal.tolerance)); }},
    {"apart", 1, [](const Search& search, int) { return search.tracker.misses_any(); },
     [](Search& search, int) { search.pass(Boundary::apart(search.goal.tolerance)); }},
    {"other", 1, [](const Search& search, int) { return has_continuum(search.found); },
     [](Search& search, int) { pass_in_other_range(search, Boundary::choosing(search.goal.tolerance)); }},
    {"nearby, astray", 12, [](const Search& search, int) { return search.tracker.strays_any(); },
     [](Search& search, int k) {
       search.strays = true;
       search.pass_from_nearby(k, Boundary::choosing(search.goal.tolerance));
     }},
    {"nearby, shared", 4, [](const Search& search, int) { return search.tracker.shares_any(); },
     [](Search& search, int k) { search.pass_from_nearby(k, Boundary::choosing(search.goal.tolerance)); }},
};

/// Once branches that share a solution are left at that. `held`: an arm with a given joint has another
/// structure at some of its values (axes that are parallel at zero), where the elimination divides by zero;
/// it does not at values nearby. QuarticPasses.FindWhatOthersLose fails without `turned`.
template <class Search>
inline constexpr PlannedPass<Search> further_passes[] = {
    {"nearby, held", 4,
     [](const Search& search, int) {
       return search.held && (search.found.empty() || search.tracker.misses_any());
     },
     [](Search& search, int k) { search.pass_from_nearby(k, Boundary::choosing(search.goal.tolerance)); }},
    {"tolerant", 1, [](const Search& search, int) { return search.tracker.misses_any(); },
     [](Search& search, int) { search.pass(Boundary::tolerant(search.goal.tolerance)); }},
    {"nearby, tolerant", 4,
     [](const Search& search, int) { return search.divides_by_zero && search.tracker.misses_any(); },
     [](Search& search, int k) { search.pass_from_nearby(k, Boundary::tolerant(search.goal.tolerance)); }},
    // With other choices, where there is nothing at all, or a wrist cannot follow to what has been chosen.
    {"turned", 60,
     [](const Search& search, int k) {
       return ((search.met_free || search.strays) && search.found.empty()) ||
              (search.tracker.turned_back_any() && k < most_choices);
     },
     [](Search& search, int k) {
       const double tolerance = search.goal.tolerance;
       search.preference = next_choice(search.preference, sixteenth_step);
       search.pass_from_nearby(k, Boundary::choosing(tolerance));
       const bool reaches = search.found.empty() && k < most_choices / 2;
       search.pass(reaches ? Boundary::reaching(tolerance) : Boundary::choosing(tolerance));
     }},
};

/// Solves near singular poses. Whatever is chosen on the way, the goal's preference stays the caller's: a
/// continuum is to be left next to the seed. `always`: an arm whose poses all come here, a quartic's, of
/// which the roots have to be polished; the first pass then says nothing about singular poses. `fold`: as for
/// `solve_near_singular`.
template <int dof, class Aim, class Visited, int capacity, class Follow>
void solve_carefully(const Pose<double>& pose, const Aim& aimed, const Visited& visited, const Follow& follow,
                     Solutions<dof, capacity>& found, bool held, bool always, double fold = 0) {
  const auto goal = aimed(Place{pose});
  using Target = std::decay_t<decltype(goal)>;
  using Search = CarefulSearch<dof, Target, Visited, capacity, Follow, Aim>;
  Search search{pose, aimed, follow, found, held, goal, visited};
  search.fold = fold;
  const int regular = always ? 1 : 0;
  search.tracker.budget().passes += regular;
  run_passes(first_passes<Search>, search);
  search.tracker.settle_shared();
  search.divides_by_zero = held && found.empty();
  run_passes(further_passes<Search>, search);
  found.effort = search.tracker.budget().spent;
  // A branch that is next to a continuum, and nowhere on it: its solution may be one that rounding hides.
  found.effort.used_up = found.effort.used_up || search.tracker.strays_any();
  found.effort.passes -= regular;
  number_apart(found);
  sort_by_branch(found);
}

}  // namespace qvgen::inverse::quartic
