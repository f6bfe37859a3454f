// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <qvgen/inverse/certified/interval.h>
#include <qvgen/path/time.h>

/// A motion along a spline under limits of joint jerk as well, made from the fastest one without (time.h).
///
/// Let s(t) be the fastest motion, which takes T. Its mean over a window, the integral of s from t - d to t
/// divided by d, goes from rest to rest in T + d. Its third derivative is (s''(t) - s''(t - d)) / d. Slowing
/// it down by a factor divides speeds by it, accelerations by its square and jerks by its cube; so some
/// factor keeps all limits. The window with the least time is taken. It is no optimum, but on a straight way
/// whose acceleration reaches its limit.
///
/// No limit is left anywhere. Between two times at which s'' jumps, now or a window ago, the motion is a
/// cubic polynomial. On halves of each such piece, speed, acceleration and jerk of the joints lie within
/// intervals computed from those of q', q'', q''' and of the motion. The factor is that of the largest bound.
namespace qvgen::path {

template <int dof>
class Smoothing {
 public:
  using Point = typename Timing<dof>::Point;

  /// A place of the motion: the way, and its derivatives by time.
  struct Place {
    double s = 0, speed = 0, acceleration = 0, jerk = 0;
  };

  /// `timing` has planned the motion of `points`, which all differ; `integrals` and `ways` have room for as
  /// many numbers. `jerks`: the largest of each joint, rad/s^3 or m/s^3, infinite for none.
  Smoothing(const Timing<dof>& timing, const Point* points, std::size_t count, const RateLimits<dof>& limits,
            const Joints<dof>& jerks, double* ways, double* integrals)
      : timing_(timing),
        points_(points),
        count_(count),
        limits_(limits),
        jerks_(jerks),
        ways_(ways),
        integrals_(integrals) {}

  /// Returns the time that the smoothed motion takes, s; NaN if a limit is not above zero or `whole`, the
  /// time of the fastest motion, is not finite.
  double run(double whole) {
    if (!std::isfinite(whole) || !(jerks_.array() > 0).all()) return std::numeric_limits<double>::quiet_NaN();
    if (!(whole > 0)) return 0;
    integrate();
    double best = whole;
    for (double window = whole; window > whole / 2000; window *= 0.7) take_better(window, best);
    for (double share = 0.85; share < 0.9999; share = std::sqrt(share)) {
      const double from = best;
      take_better(from * share, best);
      take_better(from / share, best);
    }
    set_window(best);
    return seconds();
  }

  /// Seconds of all, and its factor and window.
  [[nodiscard]] double seconds() const { return factor_ * (points_[count_ - 1].time + window_); }
  [[nodiscard]] double factor() const { return factor_; }
  [[nodiscard]] double window() const { return window_; }

  /// Returns the place at a time from 0 to `seconds`.
  [[nodiscard]] Place at(double time) const {
    Place place = smoothed(time / factor_);
    place.speed /= factor_;
    place.acceleration /= factor_ * factor_;
    place.jerk /= factor_ * factor_ * factor_;
    return place;
  }

  /// Returns the time at which the motion is at a point, by halving.
  [[nodiscard]] double time_of(std::size_t i) const {
    if (i == 0) return 0;
    double low = 0, high = seconds();
    if (i + 1 == count_) return high;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (at(middle).s < ways_[i] ? low : high) = middle;
    }
    return high;
  }

 private:
  using Interval = inverse::certified::Interval;

  /// Ways, and integrals of the way over time, at the points.
  void integrate() {
    double way = 0, integral = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      ways_[i] = way;
      integrals_[i] = integral;
      if (i + 1 == count_) break;
      integral += integral_behind(i, points_[i + 1].time - points_[i].time);
      way += points_[i].length;
    }
  }
  /// The integral of the way from a point on, for some time within its stretch.
  [[nodiscard]] double integral_behind(std::size_t i, double t) const {
    return t * (ways_[i] + t * (std::sqrt(points_[i].w) / 2 + t * points_[i].u / 6));
  }

  /// The stretch of a time within the motion.
  [[nodiscard]] std::size_t stretch_at(double t) const {
    const auto after = std::upper_bound(points_, points_ + count_, t,
                                        [](double time, const Point& point) { return time < point.time; });
    const auto index = static_cast<std::size_t>(after - points_);
    return std::min(index > 0 ? index - 1 : 0, count_ - 2);
  }

  /// Integral of the way, the way, speed and acceleration of the fastest motion, at rest before and behind
  /// it.
  [[nodiscard]] std::array<double, 4> fastest(double t) const {
    const double whole = points_[count_ - 1].time;
    if (t <= 0) return {0, 0, 0, 0};
    if (t >= whole)
      return {integrals_[count_ - 1] + (t - whole) * ways_[count_ - 1], ways_[count_ - 1], 0, 0};
    const std::size_t i = stretch_at(t);
    const double since = t - points_[i].time, speed = std::sqrt(points_[i].w);
    return {integrals_[i] + integral_behind(i, since), ways_[i] + since * (speed + since * points_[i].u / 2),
            speed + since * points_[i].u, points_[i].u};
  }

  /// The mean over the window, without the factor.
  [[nodiscard]] Place smoothed(double t) const {
    const auto now = fastest(t), before = fastest(t - window_);
    const auto mean = [&](std::size_t k) { return (now[k] - before[k]) / window_; };
    return {std::clamp(mean(0), 0.0, ways_[count_ - 1]), std::max(0.0, mean(1)), mean(2), mean(3)};
  }

  void take_better(double window, double& best) {
    set_window(best);
    const double before = seconds();
    set_window(window);
    if (seconds() < before) best = window;
  }

  void set_window(double window) {
    window_ = window;
    factor_ = 1;
    for_each_piece([&](double from, double to) {
      const double middle = 0.5 * (from + to);
      factor_ = std::max({factor_, factor_on(from, middle), factor_on(middle, to)});
    });
  }

  /// Calls with the times between jumps of s'', now and a window ago, in turn.
  template <class Take>
  void for_each_piece(const Take& take) const {
    double last = 0;
    for (std::size_t now = 0, before = 0; before < count_;) {
      const double behind = points_[before].time + window_;
      const bool is_now = now < count_ && points_[now].time <= behind;
      const double next = is_now ? points_[now].time : behind;
      (is_now ? now : before)++;
      if (next > last) take(last, next);
      last = std::max(last, next);
    }
  }

  /// The factor that a piece needs, which is a cubic polynomial.
  [[nodiscard]] double factor_on(double from, double to) const {
    const Place a = smoothed(from), b = smoothed(to);
    const double jerk = smoothed(0.5 * (from + to)).jerk,
                 bend = std::abs(jerk) * (to - from) * (to - from) / 8;
    const Interval speed(std::max(0.0, std::min(a.speed, b.speed) - bend), std::max(a.speed, b.speed) + bend);
    const Interval acceleration(std::min(a.acceleration, b.acceleration),
                                std::max(a.acceleration, b.acceleration));
    double factor = 1;
    for (std::size_t i = stretch_of(a.s); i + 1 < count_ && ways_[i] <= b.s; ++i) {
      const double low = std::clamp(a.s - ways_[i], 0.0, points_[i].length);
      const double high = std::clamp(b.s - ways_[i], 0.0, points_[i].length);
      factor = std::max(factor, factor_within(timing_.spline(i), low, high, {speed, acceleration, jerk}));
    }
    return factor;
  }

  /// The last stretch that begins before a way, and the one before where rounding might decide.
  [[nodiscard]] std::size_t stretch_of(double s) const {
    const double* after = std::upper_bound(ways_, ways_ + count_, s - 1e-12 * ways_[count_ - 1]);
    return after == ways_ ? 0 : static_cast<std::size_t>(after - ways_) - 1;
  }

  /// Bounds of the motion on a piece.
  struct Motion {
    Interval speed, acceleration, jerk;
  };

  /// The factor for joints on a part of a stretch.
  [[nodiscard]] double factor_within(const SplineStretch<dof>& on, double low, double high,
                                     const Motion& motion) const {
    const Interval square = inverse::certified::square(motion.speed);
    const Interval cube = square * motion.speed, mixed = Interval(3) * (motion.speed * motion.acceleration);
    double factor = 1;
    for (int k = 0; k < dof; ++k) {
      const double third = (on.bend[1][k] - on.bend[0][k]) / on.length;
      const double at_low = on.bend[0][k] + low * third, at_high = on.bend[0][k] + high * third;
      const double slope = on.slope[0][k] + low * (on.bend[0][k] + 0.5 * low * third);
      const double middle = slope + 0.5 * (high - low) * at_low, last = middle + 0.5 * (high - low) * at_high;
      const Interval first = force::range({slope, middle, last}), second = force::range({at_low, at_high});
      const double speed = (first * motion.speed).magnitude();
      const double acceleration = (first * motion.acceleration + second * square).magnitude();
      const double jerk = (Interval(third) * cube + second * mixed + first * motion.jerk).magnitude();
      factor = std::max({factor, speed / limits_.speed[k], std::sqrt(acceleration / limits_.acceleration[k]),
                         std::cbrt(jerk / jerks_[k])});
    }
    return factor == 1 ? 1 : factor * (1 + 1e-9);
  }

  const Timing<dof>& timing_;
  const Point* points_;
  std::size_t count_;
  RateLimits<dof> limits_;
  Joints<dof> jerks_;
  double *ways_, *integrals_;
  double window_ = 0, factor_ = 1;
};

}  // namespace qvgen::path
