// SPDX-License-Identifier: MIT
#pragma once

#include "algebra.h"

namespace qvgen::inverse::certified {

/// An arm and a pose that it is to reach.
struct Loop {
  bool revolute[joints];
  Vector axis[joints], point[joints];  ///< at the zero pose
  Turns turns[joints];
  Vector link[joints + 1];  ///< to the first axis's point, from point to point, to the tool
  Matrix tool;
  Vector place;
  Matrix goal;
  Vector goal_place;
};

Loop loop_of(const Arm& arm, const Pose<double>& pose);

/// Numbers of a size for which nothing in here can overflow, and a quaternion with a length.
bool is_moderate(const Arm& arm, const Pose<double>& pose);

/// The equations of the loop in its six joints, and their derivatives: p(x) - p, and of the rotation E that
/// is left, R(x) R^T = E, the three differences E_ik - E_ki, which are twice its axis times the sine of its
/// angle. They vanish where the pose is reached and where E is half a turn; half a turn has the trace -1.
struct Closure {
  Interval value[joints];
  Interval slope[joints][joints];  ///< [equation][joint]
  Interval trace;
};
Closure closure_at(const Loop& loop, const Interval (&x)[joints]);

/// A box around a row in which exactly one solution lies.
struct Enclosure {
  Interval solution[joints];
};

/// See proof.h.
RowProof prove_row(const Loop& loop, const double (&row)[joints], double farthest, Enclosure& enclosure);

}  // namespace qvgen::inverse::certified
