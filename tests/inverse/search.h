// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "pose_sets.h"

namespace qvgen::test {

/// Levenberg-Marquardt, to rounding, since near a double root the joints are known to its root only; true if
/// it ends on the pose.
bool descend(const Case& test, Eigen::VectorXd& q, const Eigen::Isometry3d& target);

/// The distinct ends of a search that goes on until it has as many as were returned, and for a while beyond.
std::vector<Eigen::VectorXd> search(const Case& test, const Sample& sample, std::size_t returned,
                                    const std::function<Eigen::VectorXd()>& start);

/// True if two solutions nearly touch: then thousands of searches may all end on one of them.
bool nearly_singular(const Case& test, const Eigen::VectorXd& q);

}  // namespace qvgen::test
