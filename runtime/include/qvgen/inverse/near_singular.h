// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/branch_tracker.h>
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

/// Every preferred angle further by the golden angle, which spreads any number of them evenly, and slides
/// elsewhere in reach.
template <int dof>
Preference<dof> next_choice(Preference<dof> preference) {
  const Rotor<double> turn{-0x1.798869e0de833p-1, 0x1.59d9dd253cc13p-1};
  for (int i = 0; i < dof; ++i) {
    preference.choose(i, turn * preference.turn[i]);
    preference.angle[i] = angle(preference.turn[i]);
  }
  const Rotor<double> half_of_it{0x1.731267372626dp-2, 0x1.dd335a962dc90p-1};
  preference.spread = half_of_it * preference.spread;
  return preference;
}

/// Solves near singular poses, see above. `follow(start, goal, tracker, found)` is one pass over the branches
/// of one target, whose joints are polished towards the same target with the caller's preferences; it returns
/// whether it met something free, or nearly so. Whatever is chosen on the way, the goal's preference stays
/// the caller's: a continuum is to be left next to the seed.
template <int dof, class Target, class Tracker, int capacity, class Follow>
void solve_near_singular(Target goal, Tracker tracker, const Follow& follow,
                         Solutions<dof, capacity>& found) {
  Preference<dof> preference = *goal.preference;
  const auto pass = [&](const Boundary& boundary) {
    if (!tracker.budget().pass()) return false;
    goal.boundary = boundary;
    Target start = goal;
    start.preference = &preference;
    return follow(start, goal, tracker, found);
  };
  const Boundary chosen = Boundary::chosen(goal.tolerance);
  const bool met_free = pass(Boundary::ends(goal.tolerance));
  if (met_free && !tracker.all_settled()) pass(chosen);
  const int in_one_range = found.size();
  if (met_free && has_continuum(found)) {
    tracker.follow_again(true);
    pass(chosen.in_other_range());
    tracker.follow_again(false);
  }
  // Choices that these passes leave.
  const int choices = tracker.budget().passes - tracker.budget().spent.passes;
  const bool persists = tracker.budget().persists;
  const auto misses = [&] { return found.empty() || (persists && tracker.any(BranchState::missed)); };
  // Rows in both ranges are all that there are.
  const bool is_in_ranges = found.size() > in_one_range;
  const auto in_pieces = [&] { return !is_in_ranges && has_continuum(found) && !tracker.all_settled(); };
  const auto is_open = [&] {
    return (met_free && (misses() || in_pieces())) || tracker.any(BranchState::turned_back);
  };
  for (int k = 0; k < choices && is_open(); ++k) {
    preference = next_choice(preference);
    pass(found.empty() && k < choices / 2 ? Boundary::stretched(goal.tolerance) : chosen);
  }
  found.effort = tracker.budget().spent;
  number_apart(found);
  sort_by_branch(found);
}

}  // namespace qvgen::inverse
