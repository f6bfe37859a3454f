// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

namespace qvgen {

/// pi rounded to Scalar. The double is 1.2e-16 smaller than pi, the float 8.7e-8 larger.
template <class Scalar>
constexpr Scalar pi = Scalar(3.141592653589793238462643383279502884L);

/// The angle in (-pi, pi] that differs from `angle`, rad, by whole turns; infinities and NaN give NaN.
///
/// Exact with respect to a turn of 2 pi<Scalar>: a double that has gone n turns is off by 2.4e-16 n.
template <class Scalar>
Scalar wrap(Scalar angle) {
  static_assert(std::is_floating_point_v<Scalar>);
  if (angle > -pi<Scalar> && angle <= pi<Scalar>) {
    return angle;
  }
  const Scalar rest = std::remainder(angle, 2 * pi<Scalar>);
  return rest == -pi<Scalar> ? pi<Scalar> : rest;
}

/// Distance of two angles on the circle, in [0, pi], rad.
template <class Scalar>
Scalar angle_distance(Scalar a, Scalar b) {
  return std::abs(wrap(a - b));
}

/// The representative of `angle`, i.e. angle + 2 pi k, that is nearest to `reference`.
template <class Scalar>
Scalar nearest_representative(Scalar angle, Scalar reference) {
  static_assert(std::is_floating_point_v<Scalar>);
  return angle + 2 * pi<Scalar> * std::round((reference - angle) / (2 * pi<Scalar>));
}

/// Equally spaced angles, one turn apart: first, first + 2 pi, ...
template <class Scalar>
struct Representatives {
  Scalar first = 0;
  int count = 0;
  [[nodiscard]] int size() const { return count; }
  [[nodiscard]] bool empty() const { return count == 0; }
  Scalar operator[](int i) const { return first + 2 * pi<Scalar> * static_cast<Scalar>(i); }
};

/// Every angle + 2 pi k within [lower - tolerance, upper + tolerance], ascending; none if an argument is NaN.
///
/// A joint without limits on both sides (infinite ones) has one: the angle itself; with a limit on one side
/// the one next to it. `tolerance`, rad, keeps a solution that lies on a limit and is off by rounding; pass a
/// few epsilons, or what the machine's limit switches tolerate.
template <class Scalar>
Representatives<Scalar> representatives(Scalar angle, Scalar lower, Scalar upper, Scalar tolerance = 0) {
  static_assert(std::is_floating_point_v<Scalar>);
  constexpr Scalar turn = 2 * pi<Scalar>;
  constexpr Scalar many = 1e6;
  const Scalar lowest = std::ceil((lower - tolerance - angle) / turn);
  const Scalar highest = std::floor((upper + tolerance - angle) / turn);
  const bool no_lower = std::isinf(lowest);
  const bool no_upper = std::isinf(highest);
  if (!(lower <= upper) || !(lowest <= highest) || !std::isfinite(angle) || (no_lower && lowest > 0) ||
      (no_upper && highest < 0)) {
    return {};
  }
  if (no_lower || no_upper) {
    const Scalar turns = no_lower && no_upper ? Scalar(0) : no_lower ? highest : lowest;
    return {angle + turn * turns, 1};
  }
  return {angle + turn * lowest, static_cast<int>(std::fmin(highest - lowest, many)) + 1};
}

}  // namespace qvgen
