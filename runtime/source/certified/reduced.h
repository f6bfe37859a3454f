// SPDX-License-Identifier: MIT
#pragma once

#include "closure.h"
#include "line.h"

/// The loop J1 ... J6 D = I that an arm and a pose close, without some of its joints.
///
/// Let X and Y be two of its joints: X A Y B = I, where A is what stands between them one way round, and
/// B the other way. Then A l = X^-1 B^-1 l for whatever Y leaves as it is, the line l of its axis with a
/// point on it; and what X leaves of such a line is the same for A l and for B^-1 l. Each side depends on the
/// angles between X and Y alone. Neither the angles of X nor of Y appear, nor the lengths of slides, which
/// are among what is dropped:
/// - no slide: X and Y are opposite. Of a line, X about z (origin on its axis) leaves z.p, z.l, p.p, p.l
///   and z.(p x l): 4 angles, and so it is below.
/// - one slide, X: it leaves l and what of p is across it. Y is opposite.
/// - two slides that are not neighbours, X and Y: X leaves the turn as a whole, and z.(p x l), where l is
///   Y's direction.
/// - two neighbours: they leave the turn, and of p what is along the normal of both.
/// - three slides: they leave the turn (3 angles).
///
/// Reduced equations of the loop. Two facts make them a proof. Every solution solves these equations; and two
/// solutions that agree in the angles that are left differ in motions of what was dropped that undo one
/// another. Turns about two axes do that only where the axes are in line, slides only where they are linearly
/// dependent: the arm's Jacobian is singular there, which no proven row's is. So where one solution of the
/// reduced equations is known that belongs to a proven row, and it is shown that there is no second one, no
/// solution is missing.
namespace qvgen::inverse::certified {

inline constexpr int most_functions = 7;
inline constexpr int most_unknown = 4;

/// g(a), or h(b).
struct Side {
  int angles = 0;
  int joint[most_angles] = {};
  Coefficients function[most_functions];
};

struct Reduced {
  int functions = 0;            ///< 0: the arm cannot be reduced (more than three slides)
  Side side[2];                 ///< equal where the pose is reached
  double unit[most_functions];  ///< about how large each of them is
};

/// In how many ways the loop can be reduced: of arms without slides any two opposite joints can be dropped.
int choices(const Loop& loop);

/// `choice`: less than `choices`.
Reduced reduced(const Loop& loop, int choice);

}  // namespace qvgen::inverse::certified
