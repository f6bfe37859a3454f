// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/certified/tube.h>

#include "bent.h"
#include "closure.h"

/// The poses of a way as the goal of a loop: bounds of all poses of a stretch take the place of one pose.
namespace qvgen::inverse::certified {

class Goals {
 public:
  /// Keeps a reference to the way.
  Goals(const Arm& arm, const Way& way);

  /// Sets the goal to all poses of a stretch; at its ends the samples are among them.
  const Loop& to(double from, double to);
  /// Sets the goal to one pose: a sample, or the way's.
  const Loop& at(double u);

 private:
  const Loop& to_sample(const Matrix& turn, const Vector& place);

  const Way& way_;
  Loop loop_;
  Matrix start_, end_;  ///< turns of both ends
  Matrix base_;         ///< turn with which the way begins before it is bent
  Vector base_place_;
};

/// Widens the goal of a loop by poses.
void include_goal(Loop& loop, const Matrix& turn, const Vector& place);

/// True if a way's numbers are of a size for which nothing can overflow.
bool is_moderate(const Arm& arm, const Way& way);

}  // namespace qvgen::inverse::certified
