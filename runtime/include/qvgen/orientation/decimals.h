// SPDX-License-Identifier: MIT
#pragma once

// Orientations typed in with few digits, from a data sheet or a display: 0.7071 0 0.7071 0, or a matrix with
// four digits. Their length is off by more than rounding of double explains, but not by more than their
// digits explain. Numbers with all digits must be unit: a forgotten normalisation is still refused, with its
// reason.

#include <cmath>
#include <limits>

#include <qvgen/quaternion.h>
#include <qvgen/unit_tolerance.h>

namespace qvgen {

/// Why numbers are no orientation.
enum class OrientationDefect {
  none,
  not_finite,  ///< a number is NaN or infinite
  no_length,   ///< all numbers are zero
  not_unit,   ///< the quaternion's length, or the matrix's columns, are off by more than their digits explain
  reflection  ///< the matrix has orthonormal columns and the determinant -1
};

/// Returns the defect in words, and what to do.
constexpr const char* reason(OrientationDefect defect) {
  switch (defect) {
    case OrientationDefect::none:
      return "an orientation";
    case OrientationDefect::not_finite:
      return "a number of the orientation is NaN or infinite";
    case OrientationDefect::no_length:
      return "all numbers of the orientation are zero";
    case OrientationDefect::not_unit:
      return "not unit by more than the digits given explain: normalise it with nearest_rotation";
    case OrientationDefect::reflection:
      return "a reflection, not a rotation: the determinant is -1";
  }
  return "";
}

/// The fewest digits behind the point that are taken as rounding.
inline constexpr int fewest_decimals = 3;
/// The most that are looked for: behind these the tolerance of all digits is as large.
inline constexpr int most_decimals = 6;

/// Returns the least n such that every number has n digits behind the point, numbers that went through float
/// included; -1 if that takes more than `most_decimals`.
template <class Scalar>
int decimals(const Scalar* numbers, int count) {
  using std::abs;
  using std::round;
  constexpr Scalar rounding = std::numeric_limits<float>::epsilon() / 2;
  Scalar unit = 1;
  for (int n = 0; n <= most_decimals; ++n, unit *= 10) {
    bool are_whole = true;
    for (int i = 0; i < count; ++i) {
      const Scalar scaled = numbers[i] * unit;
      are_whole = are_whole && abs(scaled - round(scaled)) <= rounding * abs(scaled);
    }
    if (are_whole) return n;
  }
  return -1;
}

/// Returns by how much each of the numbers may be off: half a unit of their last digit; zero if they have all
/// their digits, or fewer than `fewest_decimals`.
template <class Scalar>
Scalar half_last_digit(const Scalar* numbers, int count) {
  using std::pow;
  const int n = decimals(numbers, count);
  return n < fewest_decimals ? Scalar(0) : Scalar(0.5) * pow(Scalar(10), Scalar(-n));
}

/// True if rounding to the digits given explains how far the sum of squares is from 1: each number x is off
/// by e at most, and so its square by 2 |x| e + e^2.
template <class Scalar, int count>
bool is_unit_by_digits(const Eigen::Matrix<Scalar, count, 1>& numbers) {
  using std::abs;
  const Scalar off = half_last_digit(numbers.data(), count);
  const Scalar excess = abs(numbers.squaredNorm() - 1);
  return off > 0 && excess <= 2 * off * numbers.cwiseAbs().sum() + count * off * off;
}

/// An orientation that was read, or the reason why there is none.
template <class Scalar>
struct ReadOrientation {
  Quaternion<Scalar> orientation = Quaternion<Scalar>::Identity();
  OrientationDefect defect = OrientationDefect::none;
};

/// Returns the unit quaternion meant: |q|^2 may be off 1 by `unit_tolerance`, or by what rounding to the
/// digits given explains.
template <class Scalar>
ReadOrientation<Scalar> read_orientation(const Quaternion<Scalar>& q) {
  using std::abs;
  const Eigen::Matrix<Scalar, 4, 1>& numbers = q.coeffs();
  if (!numbers.allFinite()) return {{}, OrientationDefect::not_finite};
  if (numbers.isZero(0)) return {{}, OrientationDefect::no_length};
  if (!(abs(numbers.squaredNorm() - 1) <= unit_tolerance<Scalar>()) && !is_unit_by_digits(numbers))
    return {{}, OrientationDefect::not_unit};
  return {Quaternion<Scalar>(Eigen::Matrix<Scalar, 4, 1>(numbers / q.norm())), OrientationDefect::none};
}

/// True if every entry of R^T R - 1 is within `unit_tolerance`, or within what rounding to the digits given
/// explains: entry i, j is a product of columns i and j, each number of which is off.
template <class Scalar>
bool is_orthonormal_by_digits(const Matrix3<Scalar>& r) {
  const Matrix3<Scalar> error = (r.transpose() * r - Matrix3<Scalar>::Identity()).cwiseAbs();
  if (error.maxCoeff() <= unit_tolerance<Scalar>()) return true;
  const Scalar off = half_last_digit(r.data(), 9);
  const Vector3<Scalar> sums = r.cwiseAbs().colwise().sum().transpose();
  const Matrix3<Scalar> most = off * (sums.replicate(1, 3) + sums.transpose().replicate(3, 1));
  return ((error - most).array() <= 3 * off * off).all();
}

/// Returns the unit quaternion of the nearest rotation to a matrix, each entry of whose R^T R - 1 may be off
/// by `unit_tolerance`, or by what rounding to the digits given explains.
template <class Scalar>
ReadOrientation<Scalar> read_orientation(const Matrix3<Scalar>& r) {
  if (!r.allFinite()) return {{}, OrientationDefect::not_finite};
  if (r.isZero(0)) return {{}, OrientationDefect::no_length};
  if (!is_orthonormal_by_digits(r)) return {{}, OrientationDefect::not_unit};
  if (r.determinant() < 0) return {{}, OrientationDefect::reflection};
  // Newton's steps to the polar factor: the error is squared by each, and 1e-3 at the beginning.
  Matrix3<Scalar> rotation = r;
  for (int step = 0; step < 4; ++step)
    rotation = Matrix3<Scalar>((rotation + rotation.inverse().transpose()) / 2);
  return {from_rotation_matrix(rotation), OrientationDefect::none};
}

}  // namespace qvgen
