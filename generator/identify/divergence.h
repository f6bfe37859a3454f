// SPDX-License-Identifier: MIT
// Distance of a full set of parameters from a prior: infinite where a body could not have them, smooth and
// convex elsewhere (identify/consistent.h).
#pragma once

#include <vector>

#include "identify/consistent.h"

namespace qvgen::identify {

/// Values are standard parameters of all links, then drive parameters of all joints and motors.
class Divergence {
 public:
  explicit Divergence(const Prior& prior);

  /// Returns the distance; infinity outside.
  [[nodiscard]] double at(const Eigen::VectorXd& values) const;
  /// Returns directions, a column each, in which the curvature at a place is one: of the links
  /// L S L^T with L the factor of the pseudo-inertia and S symmetric, of drives shares of their values.
  [[nodiscard]] Eigen::MatrixXd directions(const Eigen::VectorXd& values) const;
  /// Returns the slope along these directions.
  [[nodiscard]] Eigen::VectorXd slope(const Eigen::VectorXd& values) const;
  /// Values of the prior itself.
  [[nodiscard]] Eigen::VectorXd prior() const;

 private:
  [[nodiscard]] Eigen::Index links() const { return static_cast<Eigen::Index>(inverse_.size()); }
  [[nodiscard]] Eigen::Index drives() const { return prior_.drives.size(); }
  [[nodiscard]] static bool has_sign(Eigen::Index drive) { return drive % 4 != 3; }  ///< all but offsets

  Prior prior_;
  std::vector<PseudoInertia> inverse_;
};

}  // namespace qvgen::identify
