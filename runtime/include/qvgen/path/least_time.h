// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <qvgen/path/arm.h>
#include <qvgen/path/jerk.h>
#include <qvgen/path/time.h>

/// Least times along one motion, for the program of paths. Points are added on the spline, since the motion's
/// acceleration along it is even between two: some hundred at least. Where forces are limited, more are added
/// until the bounds' margin takes a hundredth of the limits at most, and friction's tangents are near the
/// motion. Every round's answer keeps all limits; later ones are faster.
namespace qvgen::path {

/// Stands for the dynamics of an arm whose forces are not limited.
struct NoDynamics {
  static constexpr int forces = 0;
};

/// A joint that cannot bear its load at rest, or while it creeps against friction.
struct Overload {
  int joint = -1;       ///< of all joints; -1: none
  double s = 0;         ///< path coordinate
  double force = 0;     ///< at rest, N m or N
  bool is_sure = true;  ///< else the bounds cannot be brought below the limit there
};

/// One place of a motion, with its least time.
struct TimedPlace {
  double s, time;
  Values q;
};

struct LeastTimes {
  double seconds = std::numeric_limits<double>::quiet_NaN();  ///< of all; not finite if there is none
  Overload overload;
  std::vector<TimedPlace> places;  ///< those that were asked for, and points that were added
};

template <class Dynamics>
class LeastTime {
 public:
  static constexpr int forces = Dynamics::forces;

  LeastTime(const Dynamics& dynamics, const RateLimits<6>& rates, const ForceLimits<forces>& limits)
      : dynamics_(dynamics), rates_(rates), limits_(limits) {}

  /// Limits joint jerks, rad/s^3 or m/s^3, infinite for none. Only without limits of forces.
  void limit_jerks(const Values& jerks) { jerks_ = jerks; }

  /// Returns the times of the motion through the joints `q` at path coordinates `s`.
  LeastTimes run(const std::vector<double>& s, const std::vector<Values>& q) {
    take_points(s, q);
    LeastTimes least;
    std::vector<Point> points(q_.size());
    Time laid(q_.data(), q_.size(), rates_, points.data());
    if (!laid.lay()) return least;
    points_ = points;
    bounds_.assign(q_.size(), {});
    split(std::vector<int>(q_.size(),
                           static_cast<int>(fewest_points / std::max<std::size_t>(q_.size(), 1) + 1)));
    if constexpr (forces > 0) {
      bound(std::vector<char>(q_.size(), 1));
      least.overload = refine();
      if (least.overload.joint < 0) least.seconds = plan();
    } else {
      least.seconds = jerks_.minCoeff() < std::numeric_limits<double>::infinity() ? smooth(plan()) : plan();
    }
    const bool is_timed = std::isfinite(least.seconds);
    for (std::size_t i = 0; i < q_.size(); ++i)
      for (const double each : at_[i])
        least.places.push_back(
            {each, is_timed ? points_[i].time : std::numeric_limits<double>::quiet_NaN(), q_[i]});
    return least;
  }

  /// Returns the motion that was planned, to be asked at any place.
  [[nodiscard]] Timing<6, forces> timing() { return {q_.data(), q_.size(), rates_, points_.data()}; }

 private:
  using Time = Timing<6, forces>;
  using Point = typename Time::Point;
  static constexpr double wanted_margin = 0.01, same = 1e-9;
  static constexpr int most_rounds = 24;
  static constexpr std::size_t fewest_points = 300, most_points = 100000;

  /// Keeps points that differ, one more between two that are alone.
  void take_points(const std::vector<double>& s, const std::vector<Values>& q) {
    q_.clear();
    at_.clear();
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (!q_.empty() && (q[i] - q_.back()).norm() <= same) {
        at_.back().push_back(s[i]);
        continue;
      }
      q_.push_back(q[i]);
      at_.push_back({s[i]});
    }
    if (q_.size() != 2) return;
    q_.insert(q_.begin() + 1, 0.5 * (q_[0] + q_[1]));
    at_.insert(at_.begin() + 1, {0.5 * (at_[0].back() + at_[1].front())});
  }

  double plan() {
    Time time = timing();
    if constexpr (forces > 0) time.limit_forces(limits_, bounds_.data());
    return time.plan();
  }

  /// Smooths the motion that was planned, and sets the points' times; returns that of all.
  double smooth(double fastest) {
    std::vector<double> ways(q_.size()), integrals(q_.size()), times;
    const Timing<6> time(q_.data(), q_.size(), rates_, points_.data());
    Smoothing<6> smoothing(time, points_.data(), q_.size(), rates_, jerks_, ways.data(), integrals.data());
    const double seconds = smoothing.run(fastest);
    if (!(seconds > 0)) return seconds;
    for (std::size_t i = 0; i < q_.size(); ++i) times.push_back(smoothing.time_of(i));
    for (std::size_t i = 0; i < q_.size(); ++i) points_[i].time = times[i];
    return seconds;
  }

  /// Bounds the forces on some stretches; tangents stay.
  void bound(const std::vector<char>& wanted) {
    const Time time = timing();
    for (std::size_t i = 0; i + 1 < q_.size(); ++i) {
      if (wanted[i] == 0 || points_[i].length == 0) continue;
      const double tangent = bounds_[i].tangent;
      bounds_[i] = force_bounds(dynamics_, time.spline(i));
      bounds_[i].tangent = tangent;
    }
  }

  /// Adds points and moves tangents until the margin is small; returns the joint that is overloaded, if any.
  Overload refine() {
    Overload left;
    for (int round = 0; round < most_rounds; ++round) {
      set_tangents();
      left = overload();
      if (left.joint >= 0 && left.is_sure) return left;
      if (left.joint < 0) {
        if (!(plan() < std::numeric_limits<double>::infinity())) return left;
        move_tangents();
      }
      std::vector<int> pieces(q_.size(), 1);
      if (!choose_pieces(pieces, left.joint < 0) && round >= rounds_for_friction()) break;
      bound(split(pieces));
    }
    set_tangents();
    return overload();
  }

  [[nodiscard]] int rounds_for_friction() const { return limits_.viscous.maxCoeff() > 0 ? 4 : 0; }

  /// Into how many pieces each stretch is cut; false if none is.
  bool choose_pieces(std::vector<int>& pieces, bool is_planned) const {
    bool any = false;
    for (std::size_t i = 0; i + 1 < q_.size() && q_.size() < most_points; ++i) {
      if (points_[i].length == 0) continue;
      const double share = is_planned ? margin(i) / wanted_margin : is_overloaded(i) ? 4 : 0;
      if (!(share <= 1)) pieces[i] = share < 64 ? static_cast<int>(std::sqrt(share)) + 1 : 8;
      any = any || pieces[i] > 1;
    }
    return any;
  }

  /// The largest part of a limit that the bounds' errors take on a stretch.
  [[nodiscard]] double margin(std::size_t i) const {
    const Point& point = points_[i];
    const double end = point.w + 2 * point.u * point.length;
    const auto& error = bounds_[i].error;
    const typename ForceLimits<forces>::Vector force =
        error.by_u * std::abs(point.u) + error.by_w * std::max(point.w, end) + error.rest;
    return force.cwiseQuotient(limits_.most).maxCoeff();
  }

  [[nodiscard]] bool is_overloaded(std::size_t i) const { return overloaded(i) >= 0; }

  /// The joint whose lines on a stretch do not allow rest; -1 if none.
  [[nodiscard]] int overloaded(std::size_t i) const {
    int joint = -1;
    for_each_line(bounds_[i], limits_, points_[i].length, [&](int k, const ForceLine& line) {
      if (!(line.gamma > 0)) joint = k;
    });
    return joint;
  }

  /// Returns the first joint that is surely overloaded at a point, else one that may be on a stretch.
  [[nodiscard]] Overload overload() const {
    Overload found;
    for (std::size_t i = 0; i + 1 < q_.size(); ++i) {
      if (points_[i].length == 0) continue;
      const int joint = overloaded(i);
      if (joint < 0) continue;
      for (const bool end : {false, true}) {
        const double load = (end ? bounds_[i].end : bounds_[i].start).rest[joint];
        const bool is_sure = certain_load(i, joint, load) >= limits_.most[joint] * (1 - force::kept);
        if (is_sure || found.joint < 0) found = {joint, at_[i + (end ? 1 : 0)].front(), load, is_sure};
        if (is_sure) return found;
      }
    }
    return found;
  }

  /// The least force that a joint needs to creep at a point.
  [[nodiscard]] double certain_load(std::size_t i, int k, double load) const {
    const double way = bounds_[i].slope_low[k] >= 0 ? 1 : bounds_[i].slope_high[k] <= 0 ? -1 : 0;
    if (way == 0) return std::abs(load) - limits_.coulomb[k];
    return std::abs(load + way * limits_.coulomb[k]);
  }

  /// Moves friction's tangents so far down that rest is within the limits where it can be.
  void set_tangents() {
    for (std::size_t i = 0; i + 1 < q_.size(); ++i)
      for (int k = 0; k < forces; ++k) {
        const auto& bounds = bounds_[i];
        const double load = std::max(std::abs(bounds.start.rest[k]), std::abs(bounds.end.rest[k]));
        const double room = limits_.most[k] - load - bounds.error.rest[k] - limits_.coulomb[k];
        const double slope =
            limits_.viscous[k] * std::max(std::abs(bounds.slope_low[k]), std::abs(bounds.slope_high[k]));
        if (slope > 0 && room > 0) bounds_[i].tangent = std::min(bounds_[i].tangent, room / slope);
      }
  }

  /// Moves friction's tangents to the speeds of the motion that was planned.
  void move_tangents() {
    for (std::size_t i = 0; i + 1 < q_.size(); ++i) {
      const double middle = points_[i].w + points_[i].u * points_[i].length;
      bounds_[i].tangent = std::sqrt(std::max(middle, 1e-12));
    }
  }

  /// Cuts stretches into equal pieces; returns which ones are new. The spline stays the same.
  std::vector<char> split(const std::vector<int>& pieces) {
    const Time time = timing();
    LeastTime cut(dynamics_, rates_, limits_);
    std::vector<char> is_new;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      const int count = points_[i].length > 0 ? pieces[i] : 1;
      for (int piece = 0; piece < count; ++piece) {
        cut.add_piece(*this, time, i, static_cast<double>(piece) / count);
        cut.points_.back().length /= count;
        is_new.push_back(static_cast<char>(count > 1));
      }
    }
    std::swap(q_, cut.q_);
    std::swap(points_, cut.points_);
    std::swap(at_, cut.at_);
    std::swap(bounds_, cut.bounds_);
    return is_new;
  }

  /// Adds a point on a stretch of another motion, or where that begins.
  void add_piece(const LeastTime& of, const Time& time, std::size_t i, double share) {
    points_.push_back(of.points_[i]);
    bounds_.push_back(of.bounds_[i]);
    if (share == 0) {
      q_.push_back(of.q_[i]);
      at_.push_back(of.at_[i]);
      return;
    }
    q_.push_back(time.joints(i, share));
    at_.push_back({of.at_[i].back() + share * (of.at_[i + 1].front() - of.at_[i].back())});
    points_.back().bend += share * (of.points_[i + 1].bend - of.points_[i].bend);
  }

  const Dynamics& dynamics_;
  RateLimits<6> rates_;
  ForceLimits<forces> limits_;
  Values jerks_ = Values::Constant(std::numeric_limits<double>::infinity());
  std::vector<Values> q_;
  std::vector<std::vector<double>> at_;  ///< path coordinates of each point
  std::vector<Point> points_;
  std::vector<ForceBounds<forces>> bounds_;
};

/// Returns the friction of all joints, found from the arm's inverse dynamics without gravity and centrifugal
/// forces: `friction(qd)` has the forces at rates qd. Adds it to limits.
template <int forces, class Friction>
void add_friction(const Friction& friction, ForceLimits<forces>& limits) {
  for (int k = 0; k < forces; ++k) {
    const double slow = friction(Joints<forces>(Joints<forces>::Unit(k)))[k];
    const double fast = friction(Joints<forces>(2 * Joints<forces>::Unit(k)))[k];
    const double nothing = 1e-12 * (1 + std::abs(slow) + std::abs(fast));
    const auto kept = [&](double value) { return value > nothing ? value : 0; };
    limits.viscous[k] = kept(fast - slow);
    limits.coulomb[k] = kept(2 * slow - fast);
  }
}

}  // namespace qvgen::path
