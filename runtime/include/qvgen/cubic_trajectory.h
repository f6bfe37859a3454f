// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <qvgen/inverse/solutions.h>

/// Trajectories of one joint, or of anything else with one number, by cubic polynomials of time (Jacobian
/// lecture, examples 5.4 and 5.5).
namespace qvgen {

/// Position, rate and acceleration at a time; rad or m, and s.
template <class Scalar>
struct Motion {
  Scalar position;
  Scalar rate;
  Scalar acceleration;
};

/// c0 + c1 t + c2 t² + c3 t³, t in s from the beginning of the segment.
template <class Scalar>
struct Cubic {
  std::array<Scalar, 4> c{};

  /// Also beyond the segment that it was made for.
  [[nodiscard]] Motion<Scalar> at(Scalar t) const {
    return {c[0] + t * (c[1] + t * (c[2] + t * c[3])), c[1] + t * (2 * c[2] + t * 3 * c[3]),
            2 * c[2] + 6 * t * c[3]};
  }
};

/// The cubic with given positions and rates at both ends, rates 0 if left out; `duration` > 0, otherwise NaN.
template <class Scalar>
Cubic<Scalar> cubic_between(Scalar begin, Scalar end, Scalar duration, Scalar begin_rate = 0,
                            Scalar end_rate = 0) {
  if (!(duration > 0)) duration = std::numeric_limits<Scalar>::quiet_NaN();
  const Scalar slope = (end - begin) / duration;
  return {{begin, begin_rate, (3 * slope - 2 * begin_rate - end_rate) / duration,
           (begin_rate + end_rate - 2 * slope) / (duration * duration)}};
}

/// Demands on a trajectory at one of its ends.
template <class Scalar>
struct EndCondition {
  enum class Kind { rate, acceleration };
  Kind kind = Kind::rate;
  Scalar value = 0;
};

/// The given rate, at rest if left out.
template <class Scalar>
EndCondition<Scalar> clamped(Scalar rate = 0) {
  return {EndCondition<Scalar>::Kind::rate, rate};
}

/// No acceleration.
template <class Scalar>
EndCondition<Scalar> natural() {
  return {EndCondition<Scalar>::Kind::acceleration, 0};
}

/// A trajectory through n via points, the first and the last among them: cubics from one to the next. No
/// heap.
template <class Scalar, std::size_t n>
class CubicTrajectory {
  static_assert(n >= 2, "a trajectory has a beginning and an end");

 public:
  using Points = std::array<Scalar, n>;

  /// Through the positions at the times with the given rates; accelerations jump at via points.
  static CubicTrajectory through(const Points& times, const Points& positions, const Points& rates) {
    CubicTrajectory result;
    result.times_ = times;
    bool finite = true;
    for (std::size_t i = 0; i < n; ++i)
      finite = finite && std::isfinite(times[i]) && std::isfinite(positions[i]) && std::isfinite(rates[i]);
    result.status_ = finite ? Status::solved : Status::invalid;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      if (!(times[i] < times[i + 1])) result.status_ = Status::invalid;
      result.segments_[i] =
          cubic_between(positions[i], positions[i + 1], times[i + 1] - times[i], rates[i], rates[i + 1]);
    }
    return result;
  }

  /// Through the positions at the times, with rates such that accelerations are continuous: the spline. At
  /// each end the rate is given (clamped) or the acceleration (natural). The rates are the solution of a
  /// tridiagonal system whose diagonal dominates, so it always has one.
  static CubicTrajectory smooth(const Points& times, const Points& positions,
                                EndCondition<Scalar> begin = clamped<Scalar>(),
                                EndCondition<Scalar> end = clamped<Scalar>()) {
    return through(times, positions, spline_rates(times, positions, begin, end));
  }

  /// invalid: the times do not ascend, or something is not finite.
  [[nodiscard]] Status status() const { return status_; }
  [[nodiscard]] const Cubic<Scalar>& segment(std::size_t i) const { return segments_[i]; }

  /// At rest at its ends before and behind them; NaN if the time is, or the trajectory is invalid.
  [[nodiscard]] Motion<Scalar> at(Scalar time) const {
    if (status_ != Status::solved || std::isnan(time)) {
      const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN();
      return {nan, nan, nan};
    }
    if (time < times_.front()) return {segments_.front().c[0], 0, 0};
    if (time > times_.back()) return {segments_.back().at(times_[n - 1] - times_[n - 2]).position, 0, 0};
    std::size_t i = 0;
    while (i + 2 < n && time >= times_[i + 1]) ++i;
    return segments_[i].at(time - times_[i]);
  }

 private:
  /// With h the durations and s the slopes of the segments, the acceleration is continuous at point i if
  /// r[i-1]/h[i-1] + 2 r[i] (1/h[i-1] + 1/h[i]) + r[i+1]/h[i] = 3 (s[i-1]/h[i-1] + s[i]/h[i]).
  /// At an end one side is missing, and the acceleration stands in its place.
  static Points spline_rates(const Points& times, const Points& positions, EndCondition<Scalar> begin,
                             EndCondition<Scalar> end) {
    using Kind = typename EndCondition<Scalar>::Kind;
    Points diagonal{}, above{}, right{};
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const Scalar inverse = 1 / (times[i + 1] - times[i]);
      const Scalar pull = 3 * inverse * inverse * (positions[i + 1] - positions[i]);
      diagonal[i] += 2 * inverse;
      diagonal[i + 1] += 2 * inverse;
      above[i] = inverse;
      right[i] += pull;
      right[i + 1] += pull;
    }
    right[0] -= begin.kind == Kind::acceleration ? begin.value / 2 : Scalar(0);
    right[n - 1] += end.kind == Kind::acceleration ? end.value / 2 : Scalar(0);
    Points below = above;  // of row i + 1
    if (begin.kind == Kind::rate) {
      diagonal[0] = 1;
      above[0] = 0;
      right[0] = begin.value;
    }
    if (end.kind == Kind::rate) {
      diagonal[n - 1] = 1;
      below[n - 2] = 0;
      right[n - 1] = end.value;
    }
    for (std::size_t i = 1; i < n; ++i) {
      const Scalar factor = below[i - 1] / diagonal[i - 1];
      diagonal[i] -= factor * above[i - 1];
      right[i] -= factor * right[i - 1];
    }
    Points rates{};
    rates[n - 1] = right[n - 1] / diagonal[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) rates[i] = (right[i] - above[i] * rates[i + 1]) / diagonal[i];
    return rates;
  }

  Points times_{};
  std::array<Cubic<Scalar>, n - 1> segments_{};
  Status status_ = Status::invalid;
};

}  // namespace qvgen
