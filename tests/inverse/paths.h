// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "pose_sets.h"

namespace qvgen::test {

/// A path through a singular pose: joints from pose to pose, and the poses that they reach.
struct Path {
  std::vector<Eigen::VectorXd> joints;

  /// Joints q0 + s d + s² c about singular ones, d and c at random; s in even steps, which may or may not
  /// meet the singular pose itself, or halved and halved again until they are next to nothing, through zero,
  /// and on the other side the same way back.
  static Path through(Case& test, const Eigen::VectorXd& singular);
};

/// One solution next to a seed; nothing if there is none.
using Nearest = std::function<std::optional<Eigen::VectorXd>(const Pose<double>&, double given,
                                                             const Eigen::VectorXd& seed)>;

/// Follows a path from its first joints on, each answer the seed of the next pose: the first thing wrong, in
/// words; empty if all is right. A step is a jump if it is too long and stays so in halves of halves.
std::string fault_along(const Case& test, const Path& path, const Nearest& nearest);

}  // namespace qvgen::test
