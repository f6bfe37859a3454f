// SPDX-License-Identifier: MIT
// Derivatives of accelerations, from those of forces at the accelerations that the forces make: with
// M qdd + bias = torque, d qdd = M^-1 (d torque - by_position dq - by_rate dqd). For a base that floats, dq
// is a step on the manifold (floating_base.h).
//
//     const qvgen::BranchFactorisation mass(robot::mass_matrix(at), robot::mass_matrix_parents);
//     const auto qdd = robot::forward_dynamics(at, qd, torque);
//     const auto d = qvgen::forward_dynamics_derivatives(mass, robot::inverse_dynamics_derivatives(at, qd,
//     qdd));
#pragma once

#include <qvgen/branch_factorisation.h>

namespace qvgen {

/// Row i, column k: derivative of acceleration i by position, rate or force k.
template <class Scalar, int size>
struct ForwardDynamicsDerivatives {
  using Matrix = Eigen::Matrix<Scalar, size, size>;
  Matrix by_position, by_rate, by_torque;
};

/// `of_forces`: inverse_dynamics_derivatives of the robot, at the accelerations of forward_dynamics.
template <class Scalar, int size, class InverseDynamicsDerivatives>
ForwardDynamicsDerivatives<Scalar, size> forward_dynamics_derivatives(
    const BranchFactorisation<Scalar, size>& mass, const InverseDynamicsDerivatives& of_forces) {
  ForwardDynamicsDerivatives<Scalar, size> result{-of_forces.by_position, -of_forces.by_rate, mass.inverse()};
  const auto column = [&](int k) {
    return k < size ? result.by_position.data() + k * size : result.by_rate.data() + (k - size) * size;
  };
  mass.solve_all(2 * size, column, column);
  return result;
}

}  // namespace qvgen
