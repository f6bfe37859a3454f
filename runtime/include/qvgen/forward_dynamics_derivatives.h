// SPDX-License-Identifier: MIT
// Derivatives of accelerations, from those of forces at the accelerations that the forces make: with
// M qdd + bias = torque, d qdd = M^-1 (d torque - by_position dq - by_rate dqd). For a base that floats, dq
// is a step on the manifold (floating_base.h).
//
//     const qvgen::BranchFactorisation mass(robot::mass_matrix(at), robot::mass_matrix_parents);
//     const auto qdd = mass.solve(torque - bias);                        // or robot::forward_dynamics
//     const auto forces = robot::inverse_dynamics_derivatives(at, qd, qdd);
//     const auto d = qvgen::forward_dynamics_derivatives(mass, forces);
//
// An arm, whose joints carry one another, has qvgen::Chain<dof>() for parents.
#pragma once

#include <type_traits>

#include <qvgen/branch_factorisation.h>

namespace qvgen {

/// Row i, column k: derivative of acceleration i by position, rate or force k.
template <class Scalar, int size>
struct ForwardDynamicsDerivatives {
  using Matrix = Eigen::Matrix<Scalar, size, size>;
  Matrix by_position, by_rate, by_torque;
};

namespace detail {

/// Stores -M^-1 F for one column of F, whose numbers in rows other than `row` are zero.
template <class Mass, class Scalar, int... row>
void accelerations(const typename Mass::Padded& inverse, const Scalar* forces,
                   std::integer_sequence<int, row...>, Scalar* to) {
  typename Mass::Registers sum;
  (sum.subtract(forces[row], inverse.data() + row * Mass::lanes), ...);
  sum.template store_first<Mass::size>(to);
}

/// True for a column of numbers that are zero, without derivatives of their own.
template <class Column>
bool is_zero(const Column& column) {
  if constexpr (std::is_arithmetic_v<typename Column::Scalar>)
    return column.cwiseAbs().sum() == 0;
  else
    return false;
}

}  // namespace detail

/// `of_forces`: inverse_dynamics_derivatives of the robot, at the accelerations of forward_dynamics.
template <class Scalar, class Branches, class InverseDynamicsDerivatives>
ForwardDynamicsDerivatives<Scalar, Branches::size> forward_dynamics_derivatives(
    const BranchFactorisation<Scalar, Branches>& mass, const InverseDynamicsDerivatives& of_forces) {
  constexpr int size = Branches::size;
  using Mass = BranchFactorisation<Scalar, Branches>;
  ForwardDynamicsDerivatives<Scalar, size> result;
  const auto inverse = mass.padded_inverse();
  result.by_torque = inverse.template topRows<size>();
  for_each_row(std::make_integer_sequence<int, size>(), [&](auto k) {
    constexpr int column = k;
    const auto rows = RowsOnABranchWith<Branches, column>();
    const auto solve = [&](const auto& from, auto& to) {
      detail::accelerations<Mass>(inverse, from.data() + column * size, rows, to.data() + column * size);
    };
    // The place of a base makes no difference, nor does the turn of an upright first joint.
    if (column < 3 && detail::is_zero(of_forces.by_position.col(column)))
      result.by_position.col(column).setZero();
    else
      solve(of_forces.by_position, result.by_position);
    solve(of_forces.by_rate, result.by_rate);
  });
  return result;
}

}  // namespace qvgen
