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

/// What came of a path that was followed from its first joints on, each answer the seed of the next pose.
struct Followed {
  double jump = 0;    ///< the longest way of a joint from answer to answer beyond what is allowed, rad or m
  double miss = 0;    ///< of a pose, as a share of what is allowed
  std::string fault;  ///< the first thing wrong, in words; empty if all is right
};

/// One solution next to a seed; nothing if there is none.
using Nearest = std::function<std::optional<Eigen::VectorXd>(const Pose<double>&, double given,
                                                             const Eigen::VectorXd& seed)>;

/// Follows a path. A step may be as long as `factor` times the path's own, and by `slack` longer.
Followed follow(const Case& test, const Path& path, const Nearest& nearest);

}  // namespace qvgen::test
