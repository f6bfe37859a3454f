// SPDX-License-Identifier: MIT
// The full set of inertial parameters that a body can have and that gives the identified torques. Motions
// tell some forty combinations of a seven-joint arm's hundred parameters; the others are chosen nearest to a
// prior.
//
// Each link's pseudo-inertia [[int r r^T dm, m c], [m c^T, m]] has to be positive definite: then its mass is
// positive, and its moments belong to some distribution of mass (Wensing, Kim and Slotine 2018). Nearness is
// the Bregman divergence of the logarithm of the determinant, tr(P0^-1 P) - log det(P0^-1 P) - 4, which no
// choice of frames changes (Lee, Wensing and Park 2020). The problem is convex: Newton's method ends at its
// only minimum.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "identify/arm_regressor.h"
#include "identify/estimate.h"

namespace qvgen::identify {

using PseudoInertia = Eigen::Matrix4d;
using Standard = Eigen::Matrix<double, 10, 1>;

/// Convert between the standard parameters of a link and its pseudo-inertia.
PseudoInertia pseudo_inertia(const Standard& parameters);
Standard standard_of(const PseudoInertia& inertia);

/// Guess of the whole set, before any data.
struct Prior {
  std::vector<PseudoInertia> links;  ///< positive definite, a link each
  Eigen::VectorXd drives;            ///< four a joint, then four a motor, above 0
  std::optional<double> mass;        ///< of all links together, kg: holds exactly
};

struct FullSet {
  Eigen::VectorXd
      values;          ///< standard parameters of all links, then drive parameters of all joints and motors
  bool exact = false;  ///< the identified parameters come out to rounding
  /// Growth of the weighted sum of squared residuals; zero if exact. One is the noise of a single row.
  double distance = 0;
};

/// Returns the nearest full set to a prior among those with the identified parameters; if none of them can
/// be, the one whose torques fit best. Throws std::runtime_error if a prior is not positive.
FullSet closest_consistent(const ArmRegressor& arm, const Estimate& estimate, const Prior& prior);

}  // namespace qvgen::identify
