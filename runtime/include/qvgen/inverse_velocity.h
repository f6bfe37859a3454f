// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <qvgen/change_of_frame.h>
#include <qvgen/detail/square.h>

namespace qvgen {

enum class VelocityStatus {
  solved,         ///< the arm moves as asked (in the least squares sense if it has fewer than six joints)
  damped,         ///< near a singularity: the joint rates are kept small, the twist is not quite reached
  invalid_input,  ///< NaN or infinite, or limits that admit nothing: the joint rates are zero
  incomplete      ///< within limits, but not for sure the best rates: numbers overflow
};

template <class Scalar>
struct InverseVelocityOptions {
  /// Smallest singular value, relative to the largest, below which the solution is damped.
  Scalar threshold = Scalar(0.02);
  /// Damping at the singularity itself, relative to the largest singular value: joint rates stay below
  /// |twist| / (2 damping largest).
  Scalar damping = Scalar(0.02);
  /// m or rad: a largest singular value below this is taken to be this, so that an arm that can hardly move
  /// at all, its end in the middle of its axes, is not asked to.
  Scalar scale = Scalar(0.05);
};

template <class Scalar, int Joints>
struct InverseVelocity {
  VelocityStatus status = VelocityStatus::invalid_input;
  Eigen::Matrix<Scalar, Joints, 1> qd = Eigen::Matrix<Scalar, Joints, 1>::Zero();  ///< rad/s, m/s
  Scalar residual = Scalar(0);                                                     ///< |J qd - twist|
};

namespace detail {

template <class Scalar>
using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;
template <class Scalar>
using Vector6 = Eigen::Matrix<Scalar, 6, 1>;

template <class Vector>
bool all_finite(const Vector& v) {
  const auto difference = (v - v).eval();
  return (difference.array() == typename Vector::Scalar(0)).all();
}

/// Penalty of a damped system beside its residual: the square of damping(i) times the part of x along
/// directions.col(i). Directions behind the rank have the damping of the last one before them, since at a
/// singularity nothing tells them apart.
template <class Scalar, int Size>
struct Damping {
  Eigen::Matrix<Scalar, Size, Size> directions;  ///< orthonormal, the system's right singular vectors
  Eigen::Matrix<Scalar, Size, 1> damping;        ///< zero where the system is regular
  Scalar largest;                                ///< singular value, at least options.scale
};

/// Damped least squares by singular values: sum of sigma / (sigma^2 + lambda^2) v u^T, with lambda rising
/// from 0 at the threshold to its full size at sigma = 0, over the first `rank` ones: the others belong to
/// rows and columns that only make the matrix square. Returns true if it had to be damped; tells how, if
/// asked.
template <class Scalar, int Size>
bool damped_solve(const Eigen::Matrix<Scalar, Size, Size>& a, const Eigen::Matrix<Scalar, Size, 1>& b,
                  Eigen::Index rank, const InverseVelocityOptions<Scalar>& options,
                  Eigen::Matrix<Scalar, Size, 1>& x, Damping<Scalar, Size>* told = nullptr) {
  const Eigen::JacobiSVD<Eigen::Matrix<Scalar, Size, Size>> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const auto& values = svd.singularValues();
  const Scalar largest = values(0) > options.scale ? values(0) : options.scale;
  const Scalar bound = options.threshold * largest;
  x.setZero();
  bool damped = false;
  const auto damping_of = [&](Scalar sigma) {
    return sigma < bound ? (Scalar(1) - sigma / bound) * options.damping * largest : Scalar(0);
  };
  for (Eigen::Index i = 0; i < rank; ++i) {
    const Scalar sigma = values(i);
    const Scalar lambda = damping_of(sigma);
    damped = damped || sigma < bound;
    x += sigma / (sigma * sigma + lambda * lambda) * svd.matrixU().col(i).dot(b) * svd.matrixV().col(i);
  }
  if (told == nullptr) return damped;
  *told = {svd.matrixV(), values.unaryExpr(damping_of), largest};
  told->damping.tail(Size - rank).setConstant(damping_of(values(rank - 1)));
  return damped;
}

// In the library: the decomposition takes a second to compile.
extern template bool damped_solve(const Matrix3<double>&, const Vector3<double>&, Eigen::Index,
                                  const InverseVelocityOptions<double>&, Vector3<double>&,
                                  Damping<double, 3>*);
extern template bool damped_solve(const Matrix3<float>&, const Vector3<float>&, Eigen::Index,
                                  const InverseVelocityOptions<float>&, Vector3<float>&, Damping<float, 3>*);
extern template bool damped_solve(const Matrix6<double>&, const Vector6<double>&, Eigen::Index,
                                  const InverseVelocityOptions<double>&, Vector6<double>&,
                                  Damping<double, 6>*);
extern template bool damped_solve(const Matrix6<float>&, const Vector6<float>&, Eigen::Index,
                                  const InverseVelocityOptions<float>&, Vector6<float>&, Damping<float, 6>*);

/// A 3 x 3 system by cofactors where it is far from singular: |det| against the product of the columns'
/// lengths.
template <class Scalar>
bool solve_3x3(const Matrix3<Scalar>& a, const Vector3<Scalar>& b,
               const InverseVelocityOptions<Scalar>& options, Vector3<Scalar>& x) {
  using std::abs;
  const Scalar size = a.colwise().norm().prod();
  // For unit columns the smallest singular value is at least |det| / 3.
  const Scalar largest = a.colwise().norm().maxCoeff();
  const Scalar least = a.colwise().norm().minCoeff();
  const bool regular = abs(a.determinant()) > Scalar(3) * options.threshold * size &&
                       least > Scalar(4) * options.threshold * largest;
  if (regular && least > options.scale) {
    x = a.inverse() * b;
    return false;
  }
  return damped_solve<Scalar, 3>(a, b, 3, options, x);
}

}  // namespace detail

/// Joint rates for a twist: the inverse of a square Jacobian, the smallest joint rates for an arm with more
/// joints than six, least squares for one with fewer; damped near singularities. Linear and angular rows are
/// weighed as they stand.
///
/// Branches on values: plain floating-point types only. No heap, no exceptions.
template <class Scalar, int Joints>
InverseVelocity<Scalar, Joints> inverse_velocity(const Eigen::Matrix<Scalar, 6, Joints>& jacobian,
                                                 const Eigen::Matrix<Scalar, 6, 1>& twist,
                                                 const InverseVelocityOptions<Scalar>& options = {}) {
  InverseVelocity<Scalar, Joints> result;
  if (!detail::all_finite(jacobian) || !detail::all_finite(twist)) return result;
  constexpr int size = Joints > 6 ? Joints : 6;
  constexpr int rank = Joints > 6 ? 6 : Joints;
  Eigen::Matrix<Scalar, size, 1> wanted = Eigen::Matrix<Scalar, size, 1>::Zero();
  wanted.template head<6>() = twist;
  Eigen::Matrix<Scalar, size, 1> rates;
  const bool damped =
      detail::damped_solve<Scalar, size>(detail::made_square(jacobian), wanted, rank, options, rates);
  result.qd = rates.template head<Joints>();
  result.status = damped ? VelocityStatus::damped : VelocityStatus::solved;
  result.residual = (jacobian * result.qd - twist).norm();
  return result;
}

/// Inverse velocity of six joints with a spherical wrist: at the wrist centre the last three joints give no
/// linear velocity, so the arm follows from the linear part alone and the wrist from what is left of the
/// angular part: two 3 x 3 systems. Near a singularity of one of them only that one is damped.
///
/// wrist_centre: from the tool point (to which Jacobian and twist belong) to the wrist centre, base frame, m.
template <class Scalar>
InverseVelocity<Scalar, 6> inverse_velocity_decoupled(const Eigen::Matrix<Scalar, 6, 6>& jacobian,
                                                      const Vector3<Scalar>& wrist_centre,
                                                      const Eigen::Matrix<Scalar, 6, 1>& twist,
                                                      const InverseVelocityOptions<Scalar>& options = {}) {
  InverseVelocity<Scalar, 6> result;
  if (!detail::all_finite(jacobian) || !detail::all_finite(twist) || !detail::all_finite(wrist_centre))
    return result;
  const Eigen::Matrix<Scalar, 6, 6> centred = moved_by(wrist_centre, jacobian);
  const Eigen::Matrix<Scalar, 6, 1> wanted = moved_by(wrist_centre, twist);
  Vector3<Scalar> arm;
  Vector3<Scalar> wrist;
  const bool arm_damped = detail::solve_3x3<Scalar>(centred.template topLeftCorner<3, 3>(),
                                                    wanted.template head<3>(), options, arm);
  const Vector3<Scalar> left = wanted.template tail<3>() - centred.template bottomLeftCorner<3, 3>() * arm;
  const bool wrist_damped =
      detail::solve_3x3<Scalar>(centred.template bottomRightCorner<3, 3>(), left, options, wrist);
  result.qd << arm, wrist;
  result.status = arm_damped || wrist_damped ? VelocityStatus::damped : VelocityStatus::solved;
  result.residual = (jacobian * result.qd - twist).norm();
  return result;
}

}  // namespace qvgen
