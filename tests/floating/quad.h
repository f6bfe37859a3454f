// SPDX-License-Identifier: MIT
// A compiled quadruped with a base that floats, random motions of it, and the reference: the same robot with
// six joints in place of the base, made from the description that `qvgen import` writes.
#pragma once

#include <random>
#include <string>

#include <gtest/gtest.h>
#include <qvgen/base_conventions.h>
#include <qvgen/branch_factorisation.h>
#include <qvgen/centroidal.h>
#include <qvgen/robots/quad/dynamics.h>
#include <qvgen/robots/quad/tips.h>

#include "base_motion.h"
#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"
#include "six_joints.h"

namespace qvgen::test::floating {

namespace quad = qvgen::robots::quad;
using At = quad::Configuration<double>;
using Rates = quad::Velocity<double>;  ///< or forces: what the robot's functions take
using Vector = Eigen::VectorXd;        ///< what is computed with, compiled once for all sizes
using Matrix = Eigen::MatrixXd;
using reference::product;

/// A motion of the robot, and that of the reference.
struct QuadMotion {
  explicit QuadMotion(unsigned seed) : base(seed) {
    std::mt19937 random(seed + 77);
    std::uniform_real_distribution<double> unit(-1.5, 1.5);
    const auto draw = [&] {
      return Eigen::VectorXd::NullaryExpr(quad::dof, [&] { return unit(random); }).eval();
    };
    const Eigen::VectorXd joints = draw(), rates = draw(), accelerations = draw();
    at.base = Pose<double>::from_matrix(base.rotation, base.q.head<3>());
    at.q = joints;
    qd << base.velocity, rates;
    qdd << base.acceleration, accelerations;
    force = Rates::NullaryExpr([&] { return 10 * unit(random); });
    q_of_joints = trees::joined(base.q, joints);
    qd_of_joints = trees::joined(base.qd, rates);
    qdd_of_joints = trees::joined(base.qdd, accelerations);
    back = reference::inverse(base.by_rates(quad::dof));
  }
  /// Forces of the reference's joints as those of the base and the robot's own joints.
  [[nodiscard]] Vector to_base(const Eigen::VectorXd& torque) const { return back.transpose() * torque; }

  trees::BaseMotion base;
  At at;
  Rates qd, qdd, force;
  Eigen::VectorXd q_of_joints, qd_of_joints, qdd_of_joints;
  Eigen::MatrixXd back;
};

inline const reference::Chain& reference_chain() {
  static const reference::Chain chain = reference::load_text(with_six_joints(text_of(QVGEN_QUAD)));
  return chain;
}

inline constexpr double g = 9.81;  ///< m/s^2, as the reference has it

inline void expect_close(const Matrix& a, const Matrix& b, double tolerance = 1e-12) {
  EXPECT_LE(reference::largest(a - b), tolerance * (1 + reference::largest(b)));
}

}  // namespace qvgen::test::floating
