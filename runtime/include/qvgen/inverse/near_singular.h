// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/branch_tracker.h>
#include <qvgen/inverse/nearby.h>
#include <qvgen/inverse/passes.h>
#include <qvgen/inverse/seed.h>
#include <qvgen/inverse/solutions.h>

/// Poses near singular ones, at which rounding would decide which solutions exist. Passes over the branches,
/// each for those that no pass before has settled:
///
///     pass    is run if                    follows branches              for
///     ends    -                            that may exist, from the      all; most poses need
///                                          ends of their ranges          no other pass
///     chosen  something was nearly free    with what is nearly free      continua of which rounding
///             and a branch is open         chosen as if it were free     picks a place out of reach
///     other   a row is on a continuum      all, with the choice in the   continua in two pieces, between
///                                          other of two ranges           which no joints can follow
///     turned  a wrist has turned back, or  the same with other choices;  continua of which the
///             something was nearly free    if there is no solution,      joints behind the choice
///             and a solution is missing,   stretched towards it          reach a part only, maybe in
///             or a branch on a continuum                                 several pieces
///     blurred there is no solution, and    all, with a choice where a    two singularities at once: what
///             half the steps are left      wrist has lost half the       a wrist's rounding decides is at
///                                          digits of its direction       the end of reach
///
/// The first three cost one pass each; `turned` takes what they leave of the budget, 8 passes in all, or 24
/// for arms that can follow a free joint for few of its angles (budget.h). `passes_of_closed_forms` is the
/// table as a value.
///
/// Tests fail without each: Inverse.BranchesThatMeet without `ends`,
/// NearSingular.ChoicesOutOfReachAreFollowedNextToTheSeed without `turned`,
/// TwoSingularities.OfAUr5HideNothing without `blurred`, NearSingular.EachPassHasItsBoundary without any.
///
/// The state of a branch (`BranchState`):
///
///     unseen ──its end is polished──> settled (on a solution) <──┐
///        └──no steps lead to the pose──> missed ──a later pass───┤
///     settled ──a wrist cannot follow──> turned_back ────────────┘
///
/// Passes and evaluations of the Jacobian are counted against a `Budget`, so that no pose takes longer than
/// the arm's structure says.
namespace qvgen::inverse {

/// A search for all solutions of one target. `follow(start, goal, tracker, found)` is one pass over the
/// branches, whose joints are polished towards the goal with the caller's preferences; it returns whether it
/// met something free, or nearly so.
template <int dof, class Target, class Tracker, int capacity, class Follow>
struct NearSingularSearch {
  Target goal;
  Tracker tracker;
  const Follow& follow;
  Solutions<dof, capacity>& found;
  Preference<dof> preference = *goal.preference;
  double fold = 0;  ///< see `solve_near_singular`
  bool met_free = false;
  bool has_both_ranges = false;  ///< rows in both ranges of a choice: they are all that there are

  bool pass(const Boundary& boundary) {
    if (!tracker.budget().pass()) return false;
    goal.boundary = boundary.folded_by(fold);
    Target start = goal;
    start.preference = &preference;
    return follow(start, goal, tracker, found);
  }

  [[nodiscard]] int passes_left() const { return tracker.budget().passes - tracker.budget().spent.passes; }
  /// True if the passes so far have left what they took.
  [[nodiscard]] bool may_begin_anew() const {
    return passes_left() > 0 && 2 * tracker.budget().spent.steps <= tracker.budget().steps;
  }
  [[nodiscard]] bool misses() const {
    return found.empty() || (tracker.budget().persists && tracker.any(BranchState::missed));
  }
  [[nodiscard]] bool is_in_pieces() const {
    return !has_both_ranges && has_continuum(found) && !tracker.all_settled();
  }
  /// True if another choice may lead to what is missing.
  [[nodiscard]] bool is_open() const {
    return (met_free && (misses() || is_in_pieces())) || tracker.any(BranchState::turned_back);
  }
};

template <class Search>
inline constexpr PlannedPass<Search> passes_of_closed_forms[] = {
    {"ends", 1, [](const Search&, int) { return true; },
     [](Search& search, int) { search.met_free = search.pass(Boundary::ends(search.goal.tolerance)); }},
    {"chosen", 1, [](const Search& search, int) { return search.met_free && !search.tracker.all_settled(); },
     [](Search& search, int) { search.pass(Boundary::chosen(search.goal.tolerance)); }},
    {"other", 1, [](const Search& search, int) { return search.met_free && has_continuum(search.found); },
     [](Search& search, int) {
       const int before = search.found.size();
       pass_in_other_range(search, Boundary::chosen(search.goal.tolerance));
       search.has_both_ranges = search.found.size() > before;
     }},
    // As many as the passes before leave; the first half stretched, as long as there is no solution.
    {"turned", most_passes,
     [](const Search& search, int) { return search.passes_left() > 0 && search.is_open(); },
     [](Search& search, int k) {
       const bool stretched = search.found.empty() && k < (k + search.passes_left()) / 2;
       search.preference = next_choice(search.preference, golden_step);
       search.pass(stretched ? Boundary::stretched(search.goal.tolerance)
                             : Boundary::chosen(search.goal.tolerance));
     }},
    {"blurred", 1, [](const Search& search, int) { return search.may_begin_anew() && search.found.empty(); },
     [](Search& search, int) { search.pass(Boundary::blurred(search.goal.tolerance)); }},
};

/// Solves near singular poses, see above. Whatever is chosen on the way, the goal's preference stays the
/// caller's: a continuum is to be left next to the seed. `fold`: so far outside a wrist is folded; the caller
/// finishes such rows, see `finish_folded`.
template <int dof, class Target, class Tracker, int capacity, class Follow>
void solve_near_singular(const Target& goal, const Tracker& tracker, const Follow& follow,
                         Solutions<dof, capacity>& found, double fold = 0) {
  using Search = NearSingularSearch<dof, Target, Tracker, capacity, Follow>;
  Search search{goal, tracker, follow, found};
  search.fold = fold;
  run_passes(passes_of_closed_forms<Search>, search);
  found.effort = search.tracker.budget().spent;
  number_apart(found);
  sort_by_branch(found);
}

}  // namespace qvgen::inverse
