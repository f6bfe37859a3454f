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

/// Stores -M^-1 F for one column of F, whose numbers in rows other than `first` and `row` are zero.
template <class Mass, class Scalar, int first, int... row>
void accelerations(const typename Mass::Padded& inverse, const Scalar* forces,
                   std::integer_sequence<int, first, row...>, Scalar* to) {
  typename Mass::Registers sum(inverse.data() + first * Mass::lanes);
  sum.scale(-forces[first]);
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

template <class Derivatives, class = void>
struct HasFloatingBase : std::false_type {};
template <class Derivatives>
struct HasFloatingBase<Derivatives, std::void_t<decltype(Derivatives::has_floating_base)>>
    : std::bool_constant<Derivatives::has_floating_base> {};

/// The columns of a base that floats which need no solution: its place makes no difference; its turn in
/// gravity and its linear velocity change its acceleration, and no other (Galileo). Forces are then the first
/// three columns of M times that change, and those columns begin with the whole mass.
template <class Scalar, class Derivatives, class Result>
void accelerate_freely(const Scalar& whole_mass, const Derivatives& of_forces, Result& result) {
  const Scalar factor = Scalar(-1) / whole_mass;
  result.by_position.template leftCols<6>().setZero();
  result.by_rate.template leftCols<3>().setZero();
  result.by_position.template block<3, 3>(0, 3) = of_forces.by_position.template block<3, 3>(0, 3) * factor;
  result.by_rate.template block<3, 3>(0, 0) = of_forces.by_rate.template block<3, 3>(0, 0) * factor;
}

/// Inverts M to `by_torque`, and to `room` where columns do not fill registers. Returns the one that does.
template <class Mass>
const typename Mass::Padded& inverse_of(const Mass& mass, typename Mass::Matrix& by_torque,
                                        typename Mass::Padded& room) {
  if constexpr (Mass::lanes == Mass::size) {
    mass.invert(by_torque);
    return by_torque;
  } else {
    mass.invert(room);
    by_torque = room.template topRows<Mass::size>();
    return room;
  }
}

}  // namespace detail

/// `of_forces`: inverse_dynamics_derivatives of the robot, at the accelerations of forward_dynamics.
template <class Scalar, class Branches, class InverseDynamicsDerivatives>
ForwardDynamicsDerivatives<Scalar, Branches::size> forward_dynamics_derivatives(
    const BranchFactorisation<Scalar, Branches>& mass, const InverseDynamicsDerivatives& of_forces) {
  constexpr int size = Branches::size;
  constexpr bool floats = detail::HasFloatingBase<InverseDynamicsDerivatives>::value;
  using Mass = BranchFactorisation<Scalar, Branches>;
  ForwardDynamicsDerivatives<Scalar, size> result;
  typename Mass::Padded room;
  const auto& inverse = detail::inverse_of(mass, result.by_torque, room);
  if constexpr (floats) detail::accelerate_freely(mass.first_entry(), of_forces, result);
  for_each_row(std::make_integer_sequence<int, size>(), [&](auto k) {
    constexpr int column = k;
    const auto solve = [&](const auto& from, auto& to) {
      detail::accelerations<Mass>(inverse, from.data() + column * size, RowsOnABranchWith<Branches, column>(),
                                  to.data() + column * size);
    };
    if constexpr (!floats || column >= 6) {
      // The turn of an upright first joint makes no difference, nor does the place of a base.
      if (column < 3 && detail::is_zero(of_forces.by_position.col(column)))
        result.by_position.col(column).setZero();
      else
        solve(of_forces.by_position, result.by_position);
    }
    if constexpr (!floats || column >= 3) solve(of_forces.by_rate, result.by_rate);
  });
  return result;
}

}  // namespace qvgen
