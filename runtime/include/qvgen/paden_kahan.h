// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <qvgen/angle.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/quaternion.h>

/// The subproblems of Paden and Kahan: turns about given axes that take a point to a point or to a distance
/// from one. The steps of an inverse kinematics by products of exponentials.
namespace qvgen {

/// Which angles of a solution may have any value.
enum class FreeTurn {
  none,
  first,
  second,
  both,       ///< each for itself
  sum,        ///< parallel axes: only first + second matters
  difference  ///< opposite axes: only first - second matters
};

/// All solutions of a subproblem; angles in (-pi, pi], rad.
template <class Scalar, std::size_t turns>
struct Turns {
  /// `singular`: `free` is not none, and each row stands for a continuum, its free angle being 0.
  Status status = Status::unreachable;
  FreeTurn free = FreeTurn::none;
  bool touching = false;  ///< two solutions have become one
  int count = 0;
  std::array<std::array<Scalar, turns>, 2> rows{};

  [[nodiscard]] auto begin() const { return rows.begin(); }
  [[nodiscard]] auto end() const { return rows.begin() + count; }
};

/// A directed line. `direction` may have any length but zero.
template <class Scalar>
struct TurnAxis {
  Vector3<Scalar> direction;
  Vector3<Scalar> point;
};

/// By how much, relative to the longest vector from the axis' point, an equation may be missed: what a dozen
/// products have rounded.
template <class Scalar>
constexpr Scalar turn_tolerance = Scalar(1024) * std::numeric_limits<Scalar>::epsilon();

namespace detail {

/// A vector seen from an axis: its part along the axis, the rest, and the length of the rest.
template <class Scalar>
struct AroundAxis {
  Scalar along;
  Vector3<Scalar> across;
  Scalar radius;
};

template <class Scalar>
AroundAxis<Scalar> around(const Vector3<Scalar>& axis, const Vector3<Scalar>& v) {
  const Scalar along = axis.dot(v);
  const Vector3<Scalar> across = v - along * axis;
  return {along, across, across.norm()};
}

/// From one vector across the axis to another.
template <class Scalar>
Scalar turn_between(const Vector3<Scalar>& axis, const Vector3<Scalar>& from, const Vector3<Scalar>& to) {
  return wrap(std::atan2(axis.dot(from.cross(to)), from.dot(to)));
}

/// Both vectors in units of the longer one, so that no square overflows; false if one is not finite.
template <class Scalar>
bool scale_together(Vector3<Scalar>& u, Vector3<Scalar>& v, Scalar& scale) {
  if (!u.allFinite() || !v.allFinite()) return false;
  scale = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
  if (!(scale > 0)) scale = 1;
  u /= scale;
  v /= scale;
  return true;
}

template <class Scalar>
bool make_unit(Vector3<Scalar>& direction) {
  const Scalar largest = direction.cwiseAbs().maxCoeff();
  if (!direction.allFinite() || !(largest > 0)) return false;
  direction = Vector3<Scalar>(direction / largest).normalized();
  return true;
}

}  // namespace detail

/// Subproblem 1: the turn about `axis` that takes `from` to `to`; at most one.
///
/// unreachable: the points differ in height along the axis or in distance from it. singular: both are on the
/// axis. invalid: an argument is not finite, or the direction zero.
template <class Scalar>
Turns<Scalar, 1> paden_kahan_1(TurnAxis<Scalar> axis, const Vector3<Scalar>& from, const Vector3<Scalar>& to,
                               Scalar tolerance = turn_tolerance<Scalar>) {
  Turns<Scalar, 1> result;
  Vector3<Scalar> u = from - axis.point;
  Vector3<Scalar> v = to - axis.point;
  Scalar scale;
  if (!detail::make_unit(axis.direction) || !detail::scale_together(u, v, scale)) {
    result.status = Status::invalid;
    return result;
  }
  const auto begin = detail::around<Scalar>(axis.direction, u);
  const auto end = detail::around<Scalar>(axis.direction, v);
  if (!(std::hypot(begin.along - end.along, begin.radius - end.radius) <= tolerance)) return result;
  result.count = 1;
  const bool on_axis = std::max(begin.radius, end.radius) <= tolerance;
  result.status = on_axis ? Status::singular : Status::solved;
  result.free = on_axis ? FreeTurn::first : FreeTurn::none;
  if (!on_axis) result.rows[0][0] = detail::turn_between<Scalar>(axis.direction, begin.across, end.across);
  return result;
}

namespace detail {

/// Subproblem 2 where only the sum (sign 1) or the difference (sign -1) of the angles matters.
template <class Scalar>
Turns<Scalar, 2> turns_about_one_axis(const Vector3<Scalar>& first, const Vector3<Scalar>& u,
                                      const Vector3<Scalar>& v, bool same_sense, Scalar tolerance) {
  const auto one = paden_kahan_1<Scalar>({first, Vector3<Scalar>::Zero()}, u, v, tolerance);
  Turns<Scalar, 2> result;
  result.status = one.count > 0 ? Status::singular : one.status;
  result.count = one.count;
  result.free = one.count == 0                ? FreeTurn::none
                : one.free == FreeTurn::first ? FreeTurn::both
                : same_sense                  ? FreeTurn::sum
                                              : FreeTurn::difference;
  result.rows[0] = {one.rows[0][0], Scalar(0)};
  return result;
}

}  // namespace detail

/// Subproblem 2: turns about two axes through `point` that take `from` to `to`, the turn about `second` being
/// the first to act: R(first, row[0]) R(second, row[1]) (from - point) = to - point. At most two.
///
/// Between the turns the point is at z with z.first = to.first and z.second = from.second: on a line along
/// first x second, which meets the circle of `to` about `first` twice, once (touching) or not at all
/// (unreachable, as where `from` and `to` differ in distance from `point`). singular: `to` on the first axis,
/// `from` on the second, or the axes in line; `free` says which. invalid: as in subproblem 1.
template <class Scalar>
Turns<Scalar, 2> paden_kahan_2(Vector3<Scalar> first, Vector3<Scalar> second, const Vector3<Scalar>& point,
                               const Vector3<Scalar>& from, const Vector3<Scalar>& to,
                               Scalar tolerance = turn_tolerance<Scalar>) {
  constexpr Scalar rounding = 16 * std::numeric_limits<Scalar>::epsilon();
  Turns<Scalar, 2> result;
  Vector3<Scalar> u = from - point;
  Vector3<Scalar> v = to - point;
  Scalar scale;
  if (!detail::make_unit(first) || !detail::make_unit(second) || !detail::scale_together(u, v, scale)) {
    result.status = Status::invalid;
    return result;
  }
  const Vector3<Scalar> normal = first.cross(second);
  const Scalar sine = normal.norm();
  const Scalar cosine = first.dot(second);
  if (sine <= tolerance) return detail::turns_about_one_axis(first, u, v, cosine > 0, tolerance);

  const auto begin = detail::around<Scalar>(second, u);
  const auto end = detail::around<Scalar>(first, v);
  // By how much z would lie beyond the circle of `to`, as a miss in its height along the second axis.
  const Scalar beyond = std::abs(begin.along - cosine * end.along) - sine * end.radius;
  if (!(std::abs(u.norm() - v.norm()) <= tolerance) || !(beyond <= tolerance)) return result;

  const bool first_free = end.radius <= tolerance;
  const bool second_free = begin.radius <= tolerance;
  const Scalar side = (begin.along - cosine * end.along) / sine;
  const Scalar square = (end.radius - side) * (end.radius + side);
  result.touching = !first_free && !second_free && beyond >= -rounding;
  const Scalar height = result.touching ? Scalar(0) : std::sqrt(std::max(square, Scalar(0)));
  const bool single = first_free || second_free || result.touching;
  const Vector3<Scalar> across_first = (second - cosine * first) / sine;
  for (const Scalar sign : {Scalar(1), Scalar(-1)}) {
    const Vector3<Scalar> offset = side * across_first + sign * height / sine * normal;
    const Vector3<Scalar> z = first_free ? v : second_free ? u : Vector3<Scalar>(end.along * first + offset);
    std::array<Scalar, 2>& row = result.rows[static_cast<std::size_t>(result.count++)];
    const auto at_first = detail::around<Scalar>(first, z);
    const auto at_second = detail::around<Scalar>(second, z);
    row[0] = first_free ? Scalar(0) : detail::turn_between<Scalar>(first, at_first.across, end.across);
    row[1] = second_free ? Scalar(0) : detail::turn_between<Scalar>(second, begin.across, at_second.across);
    if (single) break;
  }
  result.status = first_free || second_free ? Status::singular : Status::solved;
  result.free = first_free && second_free ? FreeTurn::both
                : first_free              ? FreeTurn::first
                : second_free             ? FreeTurn::second
                                          : FreeTurn::none;
  return result;
}

/// Subproblem 3: the turns about `axis` that take `from` to the distance `distance` >= 0 from `to`; at most
/// two.
///
/// Turning moves the distance between a least and a greatest value: unreachable outside, touching at both.
/// The half angle comes from products of differences to these, not from an arccosine, which loses half of the
/// digits there. singular: one of the points is on the axis, and the distance is always the same. invalid: as
/// in subproblem 1, or the distance negative.
template <class Scalar>
Turns<Scalar, 1> paden_kahan_3(TurnAxis<Scalar> axis, const Vector3<Scalar>& from, const Vector3<Scalar>& to,
                               Scalar distance, Scalar tolerance = turn_tolerance<Scalar>) {
  constexpr Scalar rounding = 16 * std::numeric_limits<Scalar>::epsilon();
  Turns<Scalar, 1> result;
  Vector3<Scalar> u = from - axis.point;
  Vector3<Scalar> v = to - axis.point;
  Scalar scale;
  if (!detail::make_unit(axis.direction) || !detail::scale_together(u, v, scale) ||
      !(distance >= 0 && std::isfinite(distance))) {
    result.status = Status::invalid;
    return result;
  }
  distance /= scale;
  const auto begin = detail::around<Scalar>(axis.direction, u);
  const auto end = detail::around<Scalar>(axis.direction, v);
  const Scalar height = begin.along - end.along;
  const Scalar least = std::hypot(height, begin.radius - end.radius);
  const Scalar greatest = std::hypot(height, begin.radius + end.radius);
  if (!(distance >= least - tolerance && distance <= greatest + tolerance)) return result;
  result.count = 1;
  if (std::min(begin.radius, end.radius) <= tolerance) {
    result.status = Status::singular;
    result.free = FreeTurn::first;
    return result;
  }
  const Scalar above = distance - least <= rounding ? Scalar(0) : distance - least;
  const Scalar below = greatest - distance <= rounding ? Scalar(0) : greatest - distance;
  const Scalar middle = detail::turn_between<Scalar>(axis.direction, begin.across, end.across);
  const Scalar swing =
      2 * std::atan2(std::sqrt(above * (distance + least)), std::sqrt(below * (distance + greatest)));
  result.status = Status::solved;
  result.touching = above <= 0 || below <= 0;
  result.rows[0][0] = wrap(middle + swing);
  if (!result.touching) result.rows[static_cast<std::size_t>(result.count++)][0] = wrap(middle - swing);
  return result;
}

}  // namespace qvgen
