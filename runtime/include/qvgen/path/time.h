// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <qvgen/inverse/nearest.h>
#include <qvgen/path/force.h>

/// The fastest motion along joints that are given at some points, from rest to rest, under limits of joint
/// speed, acceleration and, if wanted, force, with no violation between the points either.
///
/// A natural cubic spline q(s) leads through the points, s the way in joint space. With w = s'^2 linear on
/// each stretch and its acceleration u = s'' even, q' u + q'' w is a quadratic polynomial of s there, which
/// lies between the least and largest of its three Bernstein coefficients. These are linear in u and in w at
/// the stretch's start, so each limit is three straight lines. A pass from the end finds the largest w from
/// which the rest can be done, and a pass from the start goes as fast as that allows (reachability analysis,
/// Pham and Pham 2018, with Bernstein coefficients in place of points). Limits of force give more lines,
/// which hold on the whole stretch (force.h).
namespace qvgen::path {

/// Largest speed and acceleration of each joint, rad or m; infinite for none.
template <int dof>
struct RateLimits {
  Joints<dof> speed, acceleration;
};

/// `forces`: number of joints whose forces are limited; 0 without.
template <int dof, int forces = 0>
class Timing {
 public:
  /// One point and the stretch behind it. The caller has as many as there are points.
  struct Point {
    Joints<dof> bend = Joints<dof>::Zero();  ///< q'' at the point
    double length = 0;    ///< of the stretch to the next one; 0 where the joints are the same
    double most = 0;      ///< largest w, while it is computed
    double w = 0, u = 0;  ///< s'^2 at the point, s'' behind it
    double time = 0;      ///< s, from the start
  };

  /// `q`: joints at `count` points, rad or m, continuous (turns included).
  Timing(const Joints<dof>* q, std::size_t count, const RateLimits<dof>& limits, Point* points)
      : q_(q), count_(count), limits_(limits), points_(points) {}

  /// Limits the joints' forces too: `bounds` has those of each stretch, all of whose lines have gammas above
  /// zero when the motion is planned.
  void limit_forces(const ForceLimits<forces>& limits, const ForceBounds<forces>* bounds) {
    force_limits_ = limits;
    bounds_ = bounds;
  }

  /// Returns the time that the motion takes, s; NaN if numbers are not finite or a limit is not above zero.
  /// The motion rests at equal points; a stretch between two rests needs a point in its middle, else it is
  /// infinite.
  double run() { return lay() ? plan() : std::numeric_limits<double>::quiet_NaN(); }

  /// Lays the spline through the points; false if numbers are not finite or a limit is not above zero.
  bool lay() {
    if (!is_good()) return false;
    measure();
    bend();
    return true;
  }

  /// Returns the time of the fastest motion along the spline, which was laid before.
  double plan() {
    if (count_ == 0) return 0;
    if (!go_back()) return std::numeric_limits<double>::quiet_NaN();
    go_on();
    return stretch();
  }

  /// Returns the spline on a stretch.
  [[nodiscard]] SplineStretch<dof> spline(std::size_t i) const {
    const Point &a = points_[i], &b = points_[i + 1];
    const Joints<dof> start = slope_at_start(i);
    return {
        {q_[i], q_[i + 1]}, {start, start + 0.5 * a.length * (a.bend + b.bend)}, {a.bend, b.bend}, a.length};
  }

  /// Returns speed and acceleration of the joints on a stretch, at a share of it from 0 to 1.
  void rates(std::size_t i, double share, Joints<dof>& speed, Joints<dof>& acceleration) const {
    const Point &a = points_[i], &b = points_[i + 1];
    const double along = share * a.length, w = std::max(0.0, a.w + 2 * a.u * along);
    const Joints<dof> bend = a.bend + share * (b.bend - a.bend);
    const Joints<dof> slope = slope_at_start(i) + 0.5 * along * (a.bend + bend);
    speed = std::sqrt(w) * slope;
    acceleration = a.u * slope + w * bend;
  }

  /// Returns the joints on a stretch.
  [[nodiscard]] Joints<dof> joints(std::size_t i, double share) const {
    const double along = share * points_[i].length;
    const Joints<dof> change = (points_[i + 1].bend - points_[i].bend) * share;
    return q_[i] + along * slope_at_start(i) + along * along * (0.5 * points_[i].bend + change / 6);
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double shortest = 1e-12, fastest = 1e12;
  static constexpr int lines = 3 * dof + 1 + force_lines<forces>;

  [[nodiscard]] bool is_good() const {
    for (std::size_t i = 0; i < count_; ++i)
      if (!q_[i].allFinite()) return false;
    return (limits_.speed.array() > 0).all() && (limits_.acceleration.array() > 0).all();
  }

  void measure() {
    for (std::size_t i = 0; i < count_; ++i) points_[i] = Point();
    for (std::size_t i = 0; i < count_; ++i) {
      const double way = i + 1 < count_ ? (q_[i + 1] - q_[i]).norm() : 0;
      points_[i].length = way > shortest ? way : 0;
    }
  }

  /// Second derivatives of a spline through each run of points that differ, by elimination; `most` and `w`
  /// keep its factors. At equal points the motion rests.
  void bend() {
    for (std::size_t first = 0; first + 1 < count_;) {
      std::size_t last = first;
      while (last + 1 < count_ && points_[last].length > 0) ++last;
      bend(first, last);
      first = std::max(last, first + 1);
    }
  }
  void bend(std::size_t first, std::size_t last) {
    for (std::size_t i = first + 1; i < last; ++i) {
      const double before = points_[i - 1].length, behind = points_[i].length;
      const double factor = i > first + 1 ? before / points_[i - 1].most : 0;
      points_[i].most = 2 * (before + behind) - factor * (i > first + 1 ? before : 0);
      points_[i].bend = 6 * ((q_[i + 1] - q_[i]) / behind - (q_[i] - q_[i - 1]) / before);
      if (i > first + 1) points_[i].bend -= factor * points_[i - 1].bend;
    }
    for (std::size_t i = last; i-- > first + 1;) {
      if (i + 1 < last) points_[i].bend -= points_[i].length * points_[i + 1].bend;
      points_[i].bend /= points_[i].most;
    }
  }

  [[nodiscard]] Joints<dof> slope_at_start(std::size_t i) const {
    const double length = points_[i].length;
    if (length == 0) return Joints<dof>::Zero();
    return (q_[i + 1] - q_[i]) / length - length / 6 * (2 * points_[i].bend + points_[i + 1].bend);
  }

  /// Limits of one stretch: low_k(w) <= u <= high_k(w), each a line offset + slope w, and w <= most.
  struct Stretch {
    double low[lines], low_slope[lines], high[lines], high_slope[lines];
    double most = infinity;

    void take(int k, double by_u, double by_w, double limit) {
      low[k] = -infinity;
      high[k] = infinity;
      low_slope[k] = high_slope[k] = 0;
      if (!(limit < infinity)) return;
      if (std::abs(by_u) < 1e-9) {  // s is about as long as the joints' way, so that this is next to nothing
        if (std::abs(by_w) > 0) most = std::min(most, limit / std::abs(by_w));
        return;
      }
      low[k] = -limit / std::abs(by_u);
      high[k] = limit / std::abs(by_u);
      low_slope[k] = high_slope[k] = -by_w / by_u;
    }
    void take(int k, const ForceLine& line) {
      low[k] = -infinity;
      high[k] = infinity;
      low_slope[k] = high_slope[k] = 0;
      if (!(line.gamma < infinity)) return;
      if (std::abs(line.alpha) < 1e-12) {
        if (line.beta > 0) most = std::min(most, line.gamma / line.beta);
        return;
      }
      (line.alpha > 0 ? high : low)[k] = line.gamma / line.alpha;
      (line.alpha > 0 ? high_slope : low_slope)[k] = -line.beta / line.alpha;
    }
    [[nodiscard]] double largest_low(double w, int& which) const {
      return extreme(low, low_slope, w, which, 1);
    }
    [[nodiscard]] double least_high(double w, int& which) const {
      return -extreme(high, high_slope, w, which, -1);
    }

   private:
    static double extreme(const double* offset, const double* slope, double w, int& which, double sign) {
      double most = -infinity;
      for (int k = 0; k < lines; ++k) {
        const double value = sign * (offset[k] + slope[k] * w);
        if (value > most) {
          most = value;
          which = k;
        }
      }
      return most;
    }
  };

  /// The limits of a stretch at whose end w is `next` at most.
  [[nodiscard]] Stretch limits_of(std::size_t i, double next) const {
    const Point &a = points_[i], &b = points_[i + 1];
    const double h = a.length;
    const Joints<dof> start = slope_at_start(i), middle = start + 0.5 * h * a.bend,
                      end = middle + 0.5 * h * b.bend;
    Stretch stretch;
    for (int k = 0; k < dof; ++k) {
      const double limit = limits_.acceleration[k];
      stretch.take(3 * k, start[k], a.bend[k], limit);
      stretch.take(3 * k + 1, middle[k] + h * a.bend[k], 0.5 * (a.bend[k] + b.bend[k]), limit);
      stretch.take(3 * k + 2, end[k] + 2 * h * b.bend[k], b.bend[k], limit);
    }
    int line = 3 * dof;
    if constexpr (forces > 0)
      for_each_line(bounds_[i], force_limits_, h,
                    [&](int, const ForceLine& each) { stretch.take(line++, each); });
    const int last = lines - 1;  // 0 <= w + 2 u h <= next
    stretch.low[last] = 0;
    stretch.high[last] = next / (2 * h);
    stretch.low_slope[last] = stretch.high_slope[last] = -1 / (2 * h);
    return stretch;
  }

  /// The largest w that the joints' speeds allow on all of a stretch.
  [[nodiscard]] double most_by_speed(std::size_t i) const {
    const Point &a = points_[i], &b = points_[i + 1];
    const Joints<dof> start = slope_at_start(i), middle = start + 0.5 * a.length * a.bend,
                      end = middle + 0.5 * a.length * b.bend;
    double most = infinity;
    for (int k = 0; k < dof; ++k) {
      const double slope = std::max({std::abs(start[k]), std::abs(middle[k]), std::abs(end[k])});
      const double root = limits_.speed[k] / slope;
      if (slope > 0) most = std::min(most, root * root);
    }
    return most;
  }

  /// The largest w with which a stretch can begin: from above, along the lines that exclude each other.
  static double largest(const Stretch& stretch, double w) {
    for (int trial = 0; trial < 100; ++trial) {
      int i = 0, j = 0;
      const double low = stretch.largest_low(w, i), high = stretch.least_high(w, j);
      if (low <= high) return w;
      const double meet = (stretch.high[j] - stretch.low[i]) / (stretch.low_slope[i] - stretch.high_slope[j]);
      if (!(meet < w)) return std::max(0.0, w * (1 - 1e-12));
      w = std::max(0.0, meet);
    }
    return 0;
  }

  /// From the end: the largest w at each point; false if some stretch has no limit at all.
  bool go_back() {
    double speed = infinity;
    points_[count_ - 1].most = 0;
    for (std::size_t i = count_ - 1; i-- > 0;) {
      if (points_[i].length == 0) {
        points_[i].most = 0;
        speed = infinity;
        continue;
      }
      const double own = most_by_speed(i);
      points_[i + 1].most = std::min(points_[i + 1].most, std::min(own, speed));
      const Stretch stretch = limits_of(i, points_[i + 1].most);
      const double most = std::min(own, stretch.most);
      if (forces == 0 && !(most < infinity) && !limits_.acceleration.allFinite()) return false;
      points_[i].most = largest(stretch, std::min(most, fastest));
      if (forces > 0 && points_[i].most == fastest) return false;
      speed = own;
    }
    return true;
  }

  /// From the start, as fast as can be.
  void go_on() {
    double w = 0;
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      points_[i].w = w = std::min(w, points_[i].most);
      points_[i].u = 0;
      if (points_[i].length == 0) continue;
      int which = 0;
      points_[i].u = limits_of(i, points_[i + 1].most).least_high(w, which);
      w = std::max(0.0, w + 2 * points_[i].u * points_[i].length);
    }
    points_[count_ - 1].w = w;
  }

  /// Times of all points. Rounding may have left a limit by a little: the motion is slowed down by as much.
  double stretch() {
    double excess = 1;
    for (std::size_t i = 0; i + 1 < count_; ++i) excess = std::max(excess, excess_on(i));
    double time = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      Point& point = points_[i];
      point.time = time;
      if (i + 1 < count_ && point.length > 0) {
        const double sum =
            std::sqrt(point.w) + std::sqrt(std::max(0.0, point.w + 2 * point.u * point.length));
        time += std::sqrt(excess) * 2 * point.length / sum;
      }
      point.w /= excess;
      point.u /= excess;
    }
    return time;
  }

  [[nodiscard]] double excess_on(std::size_t i) const {
    const Point &a = points_[i], &b = points_[i + 1];
    const double h = a.length, end = std::max(0.0, a.w + 2 * a.u * h);
    if (h == 0) return 1;
    const Joints<dof> start = slope_at_start(i), middle = start + 0.5 * h * a.bend,
                      last = middle + 0.5 * h * b.bend;
    const Joints<dof> first = a.u * start + a.w * a.bend, third = a.u * last + end * b.bend,
                      second = a.u * middle + 0.5 * (end * a.bend + a.w * b.bend);
    double excess = std::max(a.w, end) / most_by_speed(i);
    for (int k = 0; k < dof; ++k)
      excess = std::max(excess, std::max({std::abs(first[k]), std::abs(second[k]), std::abs(third[k])}) /
                                    limits_.acceleration[k]);
    if constexpr (forces > 0)
      for_each_line(bounds_[i], force_limits_, h, [&](int, const ForceLine& line) {
        excess = std::max(excess, (line.alpha * a.u + line.beta * a.w) / line.gamma);
      });
    return excess;
  }

  const Joints<dof>* q_;
  std::size_t count_;
  RateLimits<dof> limits_;
  Point* points_;
  ForceLimits<forces> force_limits_;
  const ForceBounds<forces>* bounds_ = nullptr;
};

}  // namespace qvgen::path
