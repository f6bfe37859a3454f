// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <qvgen/inverse/solutions.h>

namespace qvgen {

template <int dof>
using Joints = Eigen::Matrix<double, dof, 1>;

/// Which joints are revolute; generated code has it as `is_revolute`.
template <int dof>
using JointKinds = std::array<bool, static_cast<std::size_t>(dof)>;

/// Lower and upper bounds, rad or m; infinite where there is none. Generated code has the description's as
/// `Limits`.
template <int dof>
struct JointLimits {
  Joints<dof> lower;
  Joints<dof> upper;
};

/// Solutions within limits, whole turns counted: the rows of one branch differ by them, and angles are not
/// confined to (-pi, pi]. No branch lacks a row for want of room; `complete` tells whether there are all
/// representatives.
template <int dof, int capacity, int turns = 16>
struct LimitedSolutions : Solutions<dof, turns * capacity> {
  bool complete = true;
};

/// A difference of angles, rad, less the whole turns that bring it into [-pi, pi]. Adding and subtracting a
/// large number rounds, some thirty times as fast as std::remainder.
inline double without_turns(double difference) {
  constexpr double turn = 6.283185307179586476925;
  constexpr double rounds = 0x1.8p52;
  return difference - turn * ((difference * (1 / turn) + rounds) - rounds);
}

/// Difference of two angles in [-pi, pi], rad.
inline double turn_between(double from, double to) { return without_turns(to - from); }

/// Root of the sum of squares of the differences, rad and m mixed as they stand; revolute joints the short
/// way round.
template <int dof>
double joint_distance(const Joints<dof>& a, const Joints<dof>& b, const JointKinds<dof>& revolute) {
  double sum = 0;
  for (int i = 0; i < dof; ++i) {
    const double difference = revolute[static_cast<std::size_t>(i)] ? turn_between(a[i], b[i]) : b[i] - a[i];
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

namespace inverse {

/// Order by distance, which is computed once a row; equal distances keep their order.
template <int dof, int capacity, class Distance>
void sort_rows(Solutions<dof, capacity>& found, const Distance& distance) {
  std::array<double, static_cast<std::size_t>(capacity)> distances;
  for (int i = 0; i < found.size(); ++i) {
    const double own = distance(found[i].q);
    double* const first = distances.data();
    double* const place = std::upper_bound(first, first + i, own);
    std::copy_backward(place, first + i, first + i + 1);
    *place = own;
    Solution<dof>* const row = found.begin() + (place - first);
    std::rotate(row, found.begin() + i, found.begin() + i + 1);
  }
}

template <int dof, int capacity, class Distance>
const Solution<dof>* nearest_row(const Solutions<dof, capacity>& found, const Distance& distance) {
  const Solution<dof>* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Solution<dof>& row : found) {
    if (!(distance(row.q) < least)) continue;
    least = distance(row.q);
    best = &row;
  }
  return best;
}

/// The angles q + 2 pi k of one joint inside its limits, the nearest to a centre first. A slide has itself.
class Representatives {
 public:
  Representatives(double q, double centre, double lower, double upper, bool revolute) : q_(q) {
    if (!revolute) {
      count_ = q >= lower && q <= upper ? 1 : 0;
      return;
    }
    const double low = lowest(lower), high = highest(upper);
    const double first = std::fmin(std::fmax(std::rint((centre - q) / turn), low), high);
    if (!(low <= high) || !std::isfinite(first)) return;
    first_ = first;
    below_ = first - low;
    above_ = high - first;
    count_ = std::isfinite(below_ + above_) ? std::fmin(below_ + above_ + 1, 1e9) : 1;
  }

  [[nodiscard]] int count() const { return static_cast<int>(count_); }
  /// 0 is the nearest; then alternately above and below for as long as there are both.
  [[nodiscard]] double operator[](int index) const {
    const double both = 2 * std::fmin(below_, above_);
    if (index > both) return at(above_ > below_ ? index - both / 2 : both / 2 - index);
    return at(index % 2 == 1 ? (index + 1) / 2 : -index / 2);
  }

 private:
  static constexpr double turn = 6.283185307179586476925;
  [[nodiscard]] double at(double steps) const { return q_ + turn * (first_ + steps); }
  /// Rounding may put the quotient on either side of a whole number: the angle decides.
  [[nodiscard]] double lowest(double lower) const {
    const double k = std::ceil((lower - q_) / turn);
    return q_ + turn * k < lower ? k + 1 : q_ + turn * (k - 1) >= lower ? k - 1 : k;
  }
  [[nodiscard]] double highest(double upper) const {
    const double k = std::floor((upper - q_) / turn);
    return q_ + turn * k > upper ? k - 1 : q_ + turn * (k + 1) <= upper ? k + 1 : k;
  }

  double q_;
  double first_ = 0, below_ = 0, above_ = 0, count_ = 0;
};

}  // namespace inverse

/// Puts the solutions in order of their distance from the seed; equal distances keep their order.
template <int dof, int capacity, std::size_t count>
void sort_by_distance(Solutions<dof, capacity>& found, const Joints<dof>& seed,
                      const std::array<bool, count>& revolute) {
  inverse::sort_rows(found, [&](const Joints<dof>& q) { return joint_distance<dof>(q, seed, revolute); });
}

/// The same of rows within limits: whole turns count.
template <int dof, int capacity, int turns, std::size_t count>
void sort_by_distance(LimitedSolutions<dof, capacity, turns>& found, const Joints<dof>& seed,
                      const std::array<bool, count>& /*revolute*/) {
  inverse::sort_rows(found, [&](const Joints<dof>& q) { return (q - seed).norm(); });
}

/// The solution nearest to the seed; null if there is none.
template <int dof, int capacity, std::size_t count>
const Solution<dof>* nearest(const Solutions<dof, capacity>& found, const Joints<dof>& seed,
                             const std::array<bool, count>& revolute) {
  return inverse::nearest_row(found,
                              [&](const Joints<dof>& q) { return joint_distance<dof>(q, seed, revolute); });
}

/// The same of rows within limits: whole turns count.
template <int dof, int capacity, int turns, std::size_t count>
const Solution<dof>* nearest(const LimitedSolutions<dof, capacity, turns>& found, const Joints<dof>& seed,
                             const std::array<bool, count>& /*revolute*/) {
  return inverse::nearest_row(found, [&](const Joints<dof>& q) { return (q - seed).norm(); });
}

/// Joints that continue a path without limits: the solution nearest to `previous`, its revolute joints
/// unwound by whole turns so that none jumps. False, and `next` untouched, if there is no solution.
template <int dof, int capacity, std::size_t count>
bool continued(const Solutions<dof, capacity>& found, const Joints<dof>& previous,
               const std::array<bool, count>& revolute, Joints<dof>& next) {
  const Solution<dof>* row = nearest(found, previous, revolute);
  if (row == nullptr) return false;
  for (int i = 0; i < dof; ++i)
    next[i] = revolute[static_cast<std::size_t>(i)] ? previous[i] + turn_between(previous[i], row->q[i])
                                                    : row->q[i];
  return true;
}

/// The same within limits: the nearest row as it stands. Where a joint has reached its limit this is a jump
/// to another branch or by whole turns; the caller sees how far `next` is.
template <int dof, int capacity, int turns, std::size_t count>
bool continued(const LimitedSolutions<dof, capacity, turns>& found, const Joints<dof>& previous,
               const std::array<bool, count>& revolute, Joints<dof>& next) {
  const Solution<dof>* row = nearest(found, previous, revolute);
  if (row != nullptr) next = row->q;
  return row != nullptr;
}

namespace inverse {

/// The representatives of one joint of one solution.
template <int dof, std::size_t count>
Representatives representatives(const Solution<dof>& row, int joint, const JointLimits<dof>& limits,
                                const std::array<bool, count>& revolute, const Joints<dof>& centre) {
  return {row.q[joint], centre[joint], limits.lower[joint], limits.upper[joint],
          revolute[static_cast<std::size_t>(joint)]};
}

/// How many rows all representatives of all solutions take.
template <int dof, int capacity, std::size_t count>
double rows_within_limits(const Solutions<dof, capacity>& found, const JointLimits<dof>& limits,
                          const std::array<bool, count>& revolute, const Joints<dof>& centre) {
  double rows = 0;
  for (const Solution<dof>& row : found) {
    double product = 1;
    for (int i = 0; i < dof; ++i) product *= representatives(row, i, limits, revolute, centre).count();
    rows += product;
  }
  return rows;
}

/// Appends up to `most` representatives of each solution, the nearest to the centre first.
template <int dof, int capacity, int rows, std::size_t count>
void append_within_limits(const Solutions<dof, capacity>& found, const JointLimits<dof>& limits,
                          const std::array<bool, count>& revolute, const Joints<dof>& centre, int most,
                          Solutions<dof, rows>& result) {
  for (const Solution<dof>& row : found) {
    const auto of_joint = [&](int i) { return representatives(row, i, limits, revolute, centre); };
    Joints<dof> q;
    bool inside = true;
    for (int i = 0; i < dof; ++i) {
      inside = inside && of_joint(i).count() > 0;
      if (inside) q[i] = of_joint(i)[0];
    }
    // Counts through all combinations like an odometer.
    std::array<int, static_cast<std::size_t>(dof)> index{};
    for (int appended = 0; inside && appended < most; ++appended) {
      append(result, q, row.branch, row.continuum);
      inside = false;
      for (int i = 0; i < dof && !inside; ++i) {
        int& k = index[static_cast<std::size_t>(i)];
        inside = k + 1 < of_joint(i).count();
        k = inside ? k + 1 : 0;
        q[i] = of_joint(i)[k];
      }
    }
  }
  result.effort = found.effort;
  result.status = found.status;
  // Of an incomplete set a row inside the limits may be among those that are missing.
  if (found.status != Status::invalid && found.status != Status::incomplete) result.conclude();
}

}  // namespace inverse

/// The representatives of every solution inside the limits, of each branch those nearest to `centre` first.
/// Status: unreachable if solutions exist but none inside. A limit that is not a number (lower above upper,
/// NaN) admits nothing; a joint that has not two finite limits has the one representative nearest to
/// `centre`. An incomplete set stays incomplete. Where they are more than sixteen times as many as solutions
/// are kept every branch has an equal share.
template <int dof, int capacity, std::size_t count>
LimitedSolutions<dof, capacity> within_limits(const Solutions<dof, capacity>& found,
                                              const JointLimits<dof>& limits,
                                              const std::array<bool, count>& revolute,
                                              const Joints<dof>& centre = Joints<dof>::Zero()) {
  LimitedSolutions<dof, capacity> result;
  result.complete = inverse::rows_within_limits(found, limits, revolute, centre) <= result.max_size;
  const int most = result.complete ? result.max_size : result.max_size / found.size();
  inverse::append_within_limits(found, limits, revolute, centre, most, result);
  return result;
}

/// One row for each branch that has one inside the limits, its representative nearest to the seed; the
/// nearest row first. What is left out is farther from the seed on every joint, or as far.
template <int dof, int capacity, std::size_t count>
LimitedSolutions<dof, capacity, 1> nearest_within_limits(const Solutions<dof, capacity>& found,
                                                         const JointLimits<dof>& limits,
                                                         const std::array<bool, count>& revolute,
                                                         const Joints<dof>& seed) {
  LimitedSolutions<dof, capacity, 1> result;
  inverse::append_within_limits(found, limits, revolute, seed, 1, result);
  sort_by_distance(result, seed, revolute);
  return result;
}

}  // namespace qvgen
