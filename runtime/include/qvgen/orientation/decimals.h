// SPDX-License-Identifier: MIT
#pragma once

// Orientations typed in with few digits, from a data sheet or a display: 0.7071 0 0.7071 0, or a matrix with
// four digits. Their length is off by more than rounding of double explains, but not by more than their
// digits explain. Numbers with all digits must be unit: a forgotten normalisation is still refused, with its
// reason.

#include <array>
#include <cmath>
#include <limits>

#include <qvgen/orientation/nearest_rotation.h>
#include <qvgen/pose.h>
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
  if (!q.coeffs().allFinite()) return {{}, OrientationDefect::not_finite};
  if (q.coeffs().isZero(0)) return {{}, OrientationDefect::no_length};
  const Scalar excess = abs(q.squaredNorm() - 1);
  if (!(excess <= unit_tolerance<Scalar>())) {
    const Scalar off = half_last_digit(q.coeffs().data(), 4);
    if (!(excess <= 2 * off * q.coeffs().cwiseAbs().sum() + 4 * off * off))
      return {{}, OrientationDefect::not_unit};
  }
  return {nearest_rotation(q).orientation, OrientationDefect::none};
}

/// Returns the unit quaternion of a rotation matrix: each entry of R^T R - 1 may be off by `unit_tolerance`,
/// or by what rounding to the digits given explains.
template <class Scalar>
ReadOrientation<Scalar> read_orientation(const Matrix3<Scalar>& r) {
  if (!r.allFinite()) return {{}, OrientationDefect::not_finite};
  if (r.isZero(0)) return {{}, OrientationDefect::no_length};
  const Matrix3<Scalar> error = (r.transpose() * r - Matrix3<Scalar>::Identity()).cwiseAbs();
  if (!(error.maxCoeff() <= unit_tolerance<Scalar>())) {
    // Entry i, j is a product of columns i and j, each number of which is off.
    const Scalar off = half_last_digit(r.data(), 9);
    const Vector3<Scalar> sums = r.cwiseAbs().colwise().sum().transpose();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (!(error(i, j) <= off * (sums[i] + sums[j]) + 3 * off * off))
          return {{}, OrientationDefect::not_unit};
  }
  if (r.determinant() < 0) return {{}, OrientationDefect::reflection};
  return {nearest_rotation(r).orientation, OrientationDefect::none};
}

}  // namespace qvgen
