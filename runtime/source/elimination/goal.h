// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/pose.h>

#include "gathered.h"

namespace qvgen::inverse::elimination {

/// A pose in the frame of the first axis.
inline Goal goal_of(const Chain& chain, const Pose<double>& pose) {
  using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Map<const Rotation> to_base(chain.to_base.rotation);
  Goal goal;
  Eigen::Map<Rotation>(goal.rotation).noalias() = to_base * pose.normalised().rotation_matrix();
  Eigen::Map<Vector3<double>>(goal.translation) =
      to_base * pose.position + Eigen::Map<const Vector3<double>>(chain.to_base.translation);
  return goal;
}

}  // namespace qvgen::inverse::elimination
