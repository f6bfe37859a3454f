// SPDX-License-Identifier: MIT
#pragma once

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <kdl/frames.hpp>
#include <kdl/jntarray.hpp>

#include "kdl.h"

namespace comparison {

/// KDL's two iterative inverse kinematics, which look for one solution from a start; types made once,
/// position and orientation sought to 1e-6.
class KdlInverse {
 public:
  explicit KdlInverse(const KDL::Chain& chain);
  KdlInverse(const KdlInverse&) = delete;
  KdlInverse& operator=(const KdlInverse&) = delete;

  /// Levenberg and Marquardt. Both return KDL's error code, 0 for success; the joints are in `result`.
  template <class Joints>
  int levenberg_marquardt(const Joints& start, const KDL::Frame& goal) {
    start_.data = start;
    return levenberg_marquardt_.CartToJnt(start_, goal, result_);
  }
  /// Newton and Raphson with the pseudo-inverse of the Jacobian.
  template <class Joints>
  int newton(const Joints& start, const KDL::Frame& goal) {
    start_.data = start;
    return newton_.CartToJnt(start_, goal, result_);
  }
  [[nodiscard]] const Eigen::VectorXd& result() const { return result_.data; }

 private:
  static constexpr double accuracy = 1e-6;
  KDL::Chain chain_;
  KDL::ChainFkSolverPos_recursive forward_;
  KDL::ChainIkSolverVel_pinv velocity_;
  KDL::ChainIkSolverPos_NR newton_;
  KDL::ChainIkSolverPos_LMA levenberg_marquardt_;
  KDL::JntArray start_, result_;
};

}  // namespace comparison
