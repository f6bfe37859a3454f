// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <qvgen/detail/least_squares_within.h>
#include <qvgen/inverse_velocity.h>

/// Joint rates for a twist that respect limits of the rates, in two ways: `scaled_to_limits` keeps the
/// direction and takes the speed that the slowest joint allows; `inverse_velocity_within` comes as near to
/// the twist as rates within limits can, and so leaves the direction where it must.
namespace qvgen {

/// Lowest and greatest joint rates, rad/s or m/s; infinite where there are none. Not symmetric next to a
/// limit of the joint itself, where only the way back is free.
template <class Scalar, int Joints>
struct RateLimits {
  Eigen::Matrix<Scalar, Joints, 1> lower, upper;

  static RateLimits symmetric(const Eigen::Matrix<Scalar, Joints, 1>& greatest) {
    return {-greatest, greatest};
  }
  /// True if some rates are within them: NaN and lower above upper admit nothing.
  [[nodiscard]] bool admit_something() const { return (lower.array() <= upper.array()).all(); }
  /// True if they allow to stand still.
  [[nodiscard]] bool admit_rest() const {
    return (lower.array() <= Scalar(0)).all() && (upper.array() >= Scalar(0)).all();
  }
};

/// Joint rates scaled down.
template <class Scalar, int Joints>
struct ScaledVelocity {
  VelocityStatus status = VelocityStatus::invalid_input;
  Eigen::Matrix<Scalar, Joints, 1> qd = Eigen::Matrix<Scalar, Joints, 1>::Zero();  ///< rad/s, m/s
  Scalar residual = Scalar(0);                                                     ///< |J qd - factor twist|
  Scalar factor = Scalar(0);  ///< in [0, 1]; 1 if the rates were within limits
};

/// Returns the rates times the largest factor up to 1 that brings all of them within limits. Limits have to
/// admit rest.
template <class Scalar, int Joints>
ScaledVelocity<Scalar, Joints> scaled_to_limits(const InverseVelocity<Scalar, Joints>& rates,
                                                const RateLimits<Scalar, Joints>& limits) {
  ScaledVelocity<Scalar, Joints> result;
  if (rates.status == VelocityStatus::invalid_input || !detail::all_finite(rates.qd) || !limits.admit_rest())
    return result;
  result.factor = Scalar(1);
  for (int i = 0; i < Joints; ++i) {
    const Scalar limit = rates.qd(i) < Scalar(0) ? limits.lower(i) : limits.upper(i);
    if (std::abs(rates.qd(i)) * result.factor > std::abs(limit))
      result.factor = std::abs(limit) / std::abs(rates.qd(i));
  }
  result.status = rates.status;
  result.residual = result.factor * rates.residual;
  // Rounding may leave a product one place above its limit.
  result.qd = (result.factor * rates.qd).cwiseMax(limits.lower).cwiseMin(limits.upper);
  return result;
}

/// Joint rates within limits.
template <class Scalar, int Joints>
struct VelocityWithin {
  VelocityStatus status = VelocityStatus::invalid_input;
  Eigen::Matrix<Scalar, Joints, 1> qd = Eigen::Matrix<Scalar, Joints, 1>::Zero();  ///< rad/s, m/s
  Scalar residual = Scalar(0);                                                     ///< |J qd - twist|
  bool limited = false;  ///< the rates without limits are not within them
};

namespace detail {

/// The square of the residual and what damping adds to it, halved; `steer` times the largest singular value
/// squared penalises motion that the tool does not see.
template <class Scalar, int Joints, int Size>
Quadratic<Scalar, Joints> damped_residual(const Eigen::Matrix<Scalar, 6, Joints>& jacobian,
                                          const Eigen::Matrix<Scalar, 6, 1>& twist,
                                          const Damping<Scalar, Size>& damping, Scalar steer) {
  Quadratic<Scalar, Joints> function{jacobian.transpose() * jacobian, jacobian.transpose() * twist};
  for (int i = 0; i < Size; ++i) {
    const Eigen::Matrix<Scalar, Joints, 1> direction = damping.directions.col(i).template head<Joints>();
    const Scalar steered = i < 6 ? Scalar(0) : steer * damping.largest * damping.largest;
    const Scalar weight = damping.damping(i) * damping.damping(i) + steered;
    if (weight > Scalar(0)) function.curvature += (weight * direction) * direction.transpose();
  }
  return function;
}

/// Returns the least of a damped residual within limits; with more than six joints, of all of them the one
/// with the smallest rates. There the function is not strictly convex: a small penalty on motion that the
/// tool does not see makes it so, and what the penalty takes from the residual is asked for again (the method
/// of multipliers). Where the joints that are left are singular together this converges slowly; the gradient
/// that remains is below the penalty's, the root of epsilon times the rates.
template <class Scalar, int Joints, int Size>
bool least_rates_within(const Eigen::Matrix<Scalar, 6, Joints>& jacobian,
                        const Eigen::Matrix<Scalar, 6, 1>& twist, const Damping<Scalar, Size>& damping,
                        const Bounds<Scalar, Joints>& bounds, Eigen::Matrix<Scalar, Joints, 1>& qd) {
  const Scalar steer = Joints > 6 ? std::sqrt(std::numeric_limits<Scalar>::epsilon()) : Scalar(0);
  Quadratic<Scalar, Joints> steered = damped_residual<Scalar, Joints, Size>(jacobian, twist, damping, steer);
  if (Joints <= 6) return minimise_within(steered, bounds, qd);
  const Quadratic<Scalar, Joints> wanted =
      damped_residual<Scalar, Joints, Size>(jacobian, twist, damping, Scalar(0));
  bool complete = true;
  for (int round = 0; round < 6 && complete; ++round) {
    complete = minimise_within(steered, bounds, qd);
    steered.slope -= wanted.gradient(qd);
  }
  return complete;
}

}  // namespace detail

/// Returns the joint rates within limits whose twist is nearest to the one wanted; with more than six joints
/// the smallest of those. Near singularities it is damped as `inverse_velocity` of the whole Jacobian is,
/// whose rates it returns if they are within limits. Limits need not admit rest.
///
/// Branches on values: plain floating-point types only. No heap, no exceptions, bounded work.
template <class Scalar, int Joints>
VelocityWithin<Scalar, Joints> inverse_velocity_within(const Eigen::Matrix<Scalar, 6, Joints>& jacobian,
                                                       const Eigen::Matrix<Scalar, 6, 1>& twist,
                                                       const RateLimits<Scalar, Joints>& limits,
                                                       const InverseVelocityOptions<Scalar>& options = {}) {
  constexpr int size = Joints > 6 ? Joints : 6;
  VelocityWithin<Scalar, Joints> result;
  if (!detail::all_finite(jacobian) || !detail::all_finite(twist) || !limits.admit_something()) return result;
  Eigen::Matrix<Scalar, size, 1> wanted = Eigen::Matrix<Scalar, size, 1>::Zero();
  wanted.template head<6>() = twist;
  Eigen::Matrix<Scalar, size, 1> rates;
  detail::Damping<Scalar, size> damping;
  const bool damped = detail::damped_solve<Scalar, size>(detail::made_square(jacobian), wanted,
                                                         Joints > 6 ? 6 : Joints, options, rates, &damping);
  const detail::Bounds<Scalar, Joints> bounds{limits.lower, limits.upper};
  const Eigen::Matrix<Scalar, Joints, 1> free = rates.template head<Joints>();
  if (!detail::all_finite(free)) return result;
  result.qd = bounds.nearest(free);
  result.limited = result.qd != free;
  result.status = damped ? VelocityStatus::damped : VelocityStatus::solved;
  if (result.limited &&
      !detail::least_rates_within<Scalar, Joints, size>(jacobian, twist, damping, bounds, result.qd))
    result.status = VelocityStatus::incomplete;
  result.residual = (jacobian * result.qd - twist).norm();
  return result;
}

}  // namespace qvgen
