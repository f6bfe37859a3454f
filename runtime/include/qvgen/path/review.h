// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <qvgen/path/curve.h>
#include <qvgen/path/motions.h>

/// Numbers of a motion at the samples that it passes: how near it comes to limits and to a singular pose, and
/// how fast its joints, or the motors that move them, go if the samples have times.
namespace qvgen::path {

/// A number and the path coordinate at which it was found.
struct Extreme {
  double value = std::numeric_limits<double>::quiet_NaN();
  double s = 0;
  int joint = -1;
};

struct Review {
  Extreme limit_distance;  ///< the smallest, rad or m; NaN without limits
  /// The smallest 1 / |J^-1|, by the root of the sum of squares: m/rad at most, 0 at a singular pose. It
  /// bounds the smallest singular value of the Jacobian from below.
  Extreme regularity;
  Extreme speed;                   ///< the largest of a joint, rad/s or m/s; NaN without times
  Extreme acceleration;            ///< likewise, of mean speeds of neighbouring pieces, rad/s^2 or m/s^2
  Values travel = Values::Zero();  ///< of each joint, there and back counted
};

template <class Arm>
class Reviewer {
 public:
  using Table = Record<Arm::capacity>;
  using Limits = JointLimits<Arm::Limited::values>;

  /// `times`: one a sample, s, rising; or null.
  Reviewer(const Arm& arm, const Curve& curve, const Limits& limits, const Table& record, const double* times)
      : arm_(arm), curve_(curve), limits_(limits), record_(record), times_(times) {}

  [[nodiscard]] Review review(const Motion& motion) const {
    Review review;
    Pass pass;
    see(motion.begin.s, motion.begin.q, has_speeds(motion.begin), pass, review);
    const auto first = static_cast<std::size_t>(std::ceil(motion.begin.s));
    for (std::size_t i = first; static_cast<double>(i) <= motion.end.s; ++i) {
      Values q;
      if (record_.at(i, motion.track, q)) see(static_cast<double>(i), q + motion.turns, true, pass, review);
    }
    see(motion.end.s, motion.end.q, has_speeds(motion.end), pass, review);
    return review;
  }

 private:
  /// The last places that were seen.
  struct Pass {
    double s = std::numeric_limits<double>::quiet_NaN();
    Values q, speed;
    double middle = 0;  ///< time of the mean speed
    bool has_speed = false;
  };

  static void lower(Extreme& extreme, double value, double s, int joint) {
    if (!(value >= extreme.value)) extreme = {value, s, joint};
  }
  static void raise(Extreme& extreme, double value, double s, int joint) {
    if (!(value <= extreme.value)) extreme = {value, s, joint};
  }

  /// False where branches meet: speeds have no bound there.
  static bool has_speeds(const End& end) { return end.cause == Cause::path_end || end.cause == Cause::limit; }

  void see(double s, const Values& q, bool speeds, Pass& pass, Review& review) const {
    const auto& limited = arm_.coupling.of(q);
    for (int i = 0; i < Arm::Limited::values; ++i) {
      const double room = std::min(limited[i] - limits_.lower[i], limits_.upper[i] - limited[i]);
      const int index = arm_.coupling.shown_index(i);
      if (std::isfinite(room) && index >= 0) lower(review.limit_distance, std::max(0.0, room), s, index);
    }
    const Eigen::Matrix<double, 6, 6> inverse = arm_.jacobian(q).inverse();
    const double norm = inverse.norm();
    lower(review.regularity, std::isfinite(norm) ? 1 / norm : 0, s, -1);
    if (times_ != nullptr && speeds) see_speeds(inverse, s, review);
    if (s > pass.s) see_way(s, q, pass, review);
    pass.s = s;
    pass.q = q;
  }

  /// The joints' speeds on both sides of a place.
  void see_speeds(const Eigen::Matrix<double, 6, 6>& inverse, double s, Review& review) const {
    for (const double beside : {s - 1e-9, s + 1e-9}) {
      if (beside < 0 || beside > curve_.end()) continue;
      const std::size_t i = curve_.piece_at(beside);
      const Values rates = inverse * curve_.piece(i).rate(s - static_cast<double>(i)) / duration(i);
      const Values& speed = arm_.coupling.shown_way(rates);
      for (int k = 0; k < 6; ++k)
        if (std::isfinite(speed[k])) raise(review.speed, std::abs(speed[k]), s, k);
    }
  }

  [[nodiscard]] double duration(std::size_t piece) const { return times_[piece + 1] - times_[piece]; }
  [[nodiscard]] double time_at(double s) const {
    const std::size_t i = curve_.piece_at(s);
    return times_[i] + (s - static_cast<double>(i)) * duration(i);
  }

  void see_way(double s, const Values& q, Pass& pass, Review& review) const {
    const Values joints = q - pass.q;
    const Values& way = arm_.coupling.shown_way(joints);
    review.travel += way.cwiseAbs();
    const bool is_whole = s - pass.s > 0.5;  // short pieces at the ends say little about accelerations
    if (times_ == nullptr || !is_whole) return;
    const double from = time_at(pass.s), to = time_at(s), middle = 0.5 * (from + to);
    const Values speed = way / (to - from);
    for (int k = 0; pass.has_speed && k < 6; ++k)
      raise(review.acceleration, std::abs(speed[k] - pass.speed[k]) / (middle - pass.middle), pass.s, k);
    pass.speed = speed;
    pass.middle = middle;
    pass.has_speed = true;
  }

  const Arm& arm_;
  Curve curve_;
  Limits limits_;
  const Table& record_;
  const double* times_;
};

}  // namespace qvgen::path
