// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/elimination/arm.h>

namespace qvgen::inverse::elimination {

/// Axes 2' and 3' of a loop (see `Elimination`), whose line is what the equations are linear in. A slide's
/// axis lies at infinity, and meets the axis of a turn that is at right angles to it.
enum class Pair {
  skew,      ///< they neither meet nor are parallel: six independent equations
  repeats,   ///< one of the six equations depends on the others at every outer angle, whatever the pose
  confuses,  ///< two vectors that belong to no solution solve them at every outer angle
  slides     ///< there is none: two joints slide, and the turns alone make the orientation
};

/// Which way round the loop of an `Elimination` goes, and with which joint it begins.
struct Choice {
  bool backwards;
  int shift;  ///< 0, 1 or 2
};

/// The eliminations that serve an arm, or arms that differ in numbers only, the best first.
struct Choices {
  static constexpr int most = 6;
  int count = 0;
  Choice choice[most];
  int score = 0;  ///< of the first: the less, the fewer poses leave it in doubt
};

/// One way to eliminate: the loop J1' C1' ... J6' C6' = I is a cyclic shift of the arm's own, closed by the
/// pose, forwards or backwards. Joint 1' drops out, 2' and 3' are the pair that the equations are linear in,
/// the determinant is a polynomial in joint 4', the outer one. Lengths in units of the arm's size.
struct Elimination {
  bool backwards;
  int shift;       ///< 0, 1 or 2
  int joint[6];    ///< which of the arm's joints each of the loop's is
  bool slide[6];   ///< by the loop's order
  Motion link[6];  ///< C1' ... C6'; the pose's, number 5 - shift counted from 0, is left open
  Pair pair;
  /// Six equations (inner index) times 1, cos, sin of the outer angle: rows against the 15 functions of a
  /// line.
  double equations[18][15];
  double derived[18][15];     ///< their derivatives by a displacement that makes the pair skew; zero if it is
  double pair_values[4][15];  ///< cos 2', sin 2', cos 3', sin 3' (a slide's length, 0) from the 15 functions
};

inline constexpr int most_eliminations = 4;

/// Constants of an arm: all that does not depend on the pose.
struct Setup {
  Chain chain;
  Description description;
  int count = 0;  ///< eliminations, the best first; none: the arm cannot be solved this way
  Elimination eliminations[most_eliminations];
  Choices further;  ///< those that are set up when a pose is in doubt
};

/// Tries all eliminations on sampled poses of each of these arms; takes some milliseconds. None serves arms
/// that are singular everywhere or that have more than two slides.
Choices choose(const Description* arms, int count);

/// An arm, and joint values that lead to a pose of it, rad or m.
struct Sample {
  Description arm;
  double joints[elimination::joints];
};

/// Tries all eliminations on each of these poses alone: for arms that are set up with a pose, which not every
/// pose asks for.
Choices choose(const Sample* samples, int count);

/// Everything that can be known before a pose is, by the choices that are best for the arm.
Setup set_up(const Description& arm);
/// Everything by such choices.
Setup set_up(const Description& arm, const Choices& choices);
/// Computes the part of a setup that most poses need, in some tens of microseconds: the first of the choices
/// that the arm admits. It serves a geometry, or the value of a given joint, that is known only with the
/// pose. A given joint may bring axes together, so that the arm does not admit all choices.
Setup set_up_first(const Description& arm, const Choices& choices);

/// True if the equations of a choice are the same wherever the arm's last axis points: it stands behind the
/// outer joint.
constexpr bool holds_for_any_last_axis(const Choice& choice) {
  return choice.shift == 1 || choice.shift == (choice.backwards ? 2 : 0);
}
/// Returns the setup of an arm that differs in its last axis alone: that is at the tool point, along `axis`
/// of the tool's frame. Such arms share their equations, if the setup has no others than
/// `holds_for_any_last_axis` says or two slides.
Setup with_last_axis(const Setup& setup, const Triple<double>& axis);

/// One elimination alone, untried: what the generator states and what tests compare. False if the joints 1'
/// or 4' would be slides.
bool eliminate(const Chain& chain, bool backwards, int shift, Elimination& result);

Chain chain_of(const Description& arm);

}  // namespace qvgen::inverse::elimination
