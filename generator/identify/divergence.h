// SPDX-License-Identifier: MIT
// Distance of a full set of parameters from a prior: infinite where a body could not have them, smooth and
// convex elsewhere (identify/consistent.h).
#pragma once

#include <vector>

#include "identify/consistent.h"

namespace qvgen::identify {

/// Values are standard parameters of all links, then drive parameters of all joints.
class Divergence {
 public:
  explicit Divergence(const Prior& prior);

  /// Returns the distance; infinity outside.
  [[nodiscard]] double at(const Eigen::VectorXd& values) const;
  [[nodiscard]] Eigen::VectorXd gradient(const Eigen::VectorXd& values) const;
  /// Positive definite, a block of ten for each link, diagonal for the drives.
  [[nodiscard]] Eigen::MatrixXd hessian(const Eigen::VectorXd& values) const;
  /// Values of the prior itself.
  [[nodiscard]] Eigen::VectorXd prior() const;

 private:
  [[nodiscard]] Eigen::Index links() const { return static_cast<Eigen::Index>(inverse_.size()); }
  [[nodiscard]] static bool has_sign(Eigen::Index drive) { return drive % 4 != 3; }  ///< all but offsets

  Prior prior_;
  std::vector<PseudoInertia> inverse_;
};

}  // namespace qvgen::identify
