// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "case.h"

namespace qvgen::test {

/// Expected result of a pose.
enum class Expect {
  joints,       ///< the sampled joints are among the solutions, or on a marked continuum
  clean,        ///< whatever is returned is right; nothing need be
  unreachable,  ///< Status::unreachable
  invalid       ///< Status::invalid
};

struct Sample {
  Pose<double> pose;         ///< what the solver gets
  Eigen::Isometry3d target;  ///< what its rows have to reach
  Eigen::VectorXd q;         ///< sampled joints
  Expect expect = Expect::joints;
};

/// A set of poses, at ordinary places and at those where solvers fail.
struct PoseSet {
  std::string name;
  /// The i-th pose; nothing if the arm has no such pose (then it has none for any i) or the search for it
  /// failed.
  std::function<std::optional<Sample>(Case&, int i)> draw;
  /// True if an arm must have such poses; others may.
  std::function<bool(const Case&)> is_for = [](const Case&) { return true; };
};

const std::vector<PoseSet>& pose_sets();
const PoseSet& pose_set(const std::string& name);

/// Draws the i-th pose of an arm with two singularities at once, or next to both: two joints are each off by
/// 10^-u, u in [2, 14], or not at all. None if the joints that are tried have no such place.
std::optional<Sample> at_two_singularities(Case& test, int i);

/// A pose that the sampled joints reach.
Sample sample_at(Case& test, const Eigen::VectorXd& q);

}  // namespace qvgen::test
