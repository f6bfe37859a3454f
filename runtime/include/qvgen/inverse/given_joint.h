// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Core>
#include <Eigen/LU>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/within.h>

/// Seven joints within limits, where the inverse kinematics takes one of them as given.
///
/// A pose leaves one degree of freedom. Its values of the given joint with which all joints are within limits
/// are intervals; arms with a spherical shoulder and wrist have them in closed form by the arm angle
/// (arm_angle.h), other arms have no equation of low degree for their ends. Here the margin, the least
/// distance of a joint to its limits in the best solution, is followed along the given joint: sampled where
/// it is far from zero, more densely where it is near, and its zeros are bisected.
namespace qvgen {

/// Values of the given joint, rad or m, between which some solution is within limits.
struct GivenInterval {
  double from, to;
};

/// The intervals in rising order.
class GivenIntervals {
 public:
  static constexpr int max_size = 32;

  /// solved: every value that is not in an interval lacks a solution within limits; intervals and gaps next
  /// to singular poses may be too narrow to be seen. unreachable: no interval was found. invalid: the pose or
  /// a limit is no number. incomplete: there are more intervals than fit, the work is used up, or solutions
  /// may be missing.
  Status status = Status::unreachable;
  double widest_margin_at = 0;  ///< rad or m: the value with which the joints are farthest from their limits
  double widest_margin = -std::numeric_limits<double>::infinity();  ///< rad or m: that distance

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const GivenInterval& operator[](int i) const {
    return intervals_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] const GivenInterval* begin() const { return intervals_.data(); }
  [[nodiscard]] const GivenInterval* end() const { return intervals_.data() + size_; }
  /// Appends an interval; false if there is no room.
  bool append(const GivenInterval& interval) {
    if (size_ == max_size) return false;
    intervals_[static_cast<std::size_t>(size_++)] = interval;
    return true;
  }
  /// Returns the value in an interval that is nearest to a wanted one; without an interval the wanted one.
  [[nodiscard]] double nearest(double wanted) const;

 private:
  int size_ = 0;
  std::array<GivenInterval, max_size> intervals_{};
};

namespace inverse {
namespace given_joint {

/// Distance to the limits that one value of the given joint leaves.
struct Margin {
  double value = -std::numeric_limits<double>::infinity();  ///< of the best solution; without one -infinity
  /// How far the given joint has to go until the margin of some solution may change its sign, by the joints'
  /// rates here.
  double way = std::numeric_limits<double>::infinity();
  bool is_incomplete = false;
};

/// The margin of a pose by the given joint's value.
struct Function {
  const void* functions;
  Margin (*margin)(const void* functions, double value);
};

/// Finds the intervals of non-negative margin in a range, which is finite.
GivenIntervals intervals(const Function& function, double lower, double upper);

/// Distance of a joint to the nearer limit, rad or m, of the representative that is farthest from both;
/// negative outside.
inline double margin_of(double q, double lower, double upper, bool revolute) {
  if (revolute && std::isfinite(lower) && std::isfinite(upper)) {
    const double centre = 0.5 * (lower + upper);
    // Whole turns that lead past the centre may lead back into wide limits.
    const double off = std::abs(without_turns(q - centre));
    return 0.5 * (upper - lower) - off;
  }
  if (revolute) return whole_turn;
  return std::min(q - lower, upper - q);
}

/// The margins of all joints but the given one, which has none.
template <int dof, std::size_t count>
Joints<dof> margins_of(const Joints<dof>& q, int given, const JointLimits<dof>& limits,
                       const std::array<bool, count>& revolute) {
  Joints<dof> margins;
  for (int i = 0; i < dof; ++i)
    margins[i] =
        i == given ? std::numeric_limits<double>::infinity()
                   : margin_of(q[i], limits.lower[i], limits.upper[i], revolute[static_cast<std::size_t>(i)]);
  return margins;
}

/// How the joints move with the given one while the tool stays: J rates = 0. Next to a singular pose they are
/// large, or no numbers.
inline Joints<7> rates_of(const Eigen::Matrix<double, 6, 7>& jacobian, int given) {
  Eigen::Matrix<double, 6, 6> others;
  others << jacobian.leftCols(given), jacobian.rightCols(6 - given);
  const Eigen::Matrix<double, 6, 1> moved = others.partialPivLu().solve(-jacobian.col(given));
  Joints<7> rates;
  rates << moved.head(given), 1, moved.tail(6 - given);
  return rates;
}

/// How far the given joint goes until the joints that are outside may all be inside, or, if all are inside,
/// until the first one may leave.
template <int dof>
double way_of(const Joints<dof>& margins, const Joints<dof>& rates) {
  const bool is_inside = margins.minCoeff() >= 0;
  double way = is_inside ? std::numeric_limits<double>::infinity() : 0;
  for (int i = 0; i < dof; ++i) {
    const double rate = std::abs(rates[i]);
    if (!std::isfinite(rate)) return 0;
    if (is_inside) way = std::min(way, margins[i] / rate);
    if (margins[i] < 0) way = std::max(way, -margins[i] / rate);
  }
  return way;
}

}  // namespace given_joint

/// Solves within limits for an arm of seven joints, one of which is given: `solve(value)` returns all
/// solutions of the pose with that value, `jacobian(q)` the geometric Jacobian at the tool. Generated code
/// has it as `given_intervals_NAME`; by hand:
///
///     const auto solve = [&](double value) { return arm::inverse_kinematics_given_theta7(pose, value); };
///     const auto jacobian = [](const auto& q) { return arm::jacobian(q); };
///     const qvgen::inverse::GivenJoint joint{6, arm::is_revolute, arm::Limits(), solve, jacobian};
///     const auto intervals = joint.intervals();
///     const auto rows = joint.rows(intervals, intervals.nearest(seed[6]), seed);
///
/// Work: 200 to 1,000 calls of `solve` as a rule, 8,100 at most. No heap, no exceptions.
template <std::size_t joints, class Solve, class Jacobian>
class GivenJoint {
 public:
  static constexpr int dof = static_cast<int>(joints);
  static_assert(dof == 7, "a pose leaves one joint of seven");

  GivenJoint(int given, const std::array<bool, joints>& revolute,
             const JointLimits<static_cast<int>(joints)>& limits, Solve solve, Jacobian jacobian)
      : given_(given), revolute_(revolute), limits_(limits), solve_(solve), jacobian_(jacobian) {}

  /// Returns the values of the given joint with which some solution is within limits. A turn without limits
  /// is looked at from -pi to pi; a slide needs limits.
  [[nodiscard]] GivenIntervals intervals() const {
    GivenIntervals none;
    none.status = Status::invalid;
    double lower = limits_.lower[given_], upper = limits_.upper[given_];
    const bool turns = revolute_[static_cast<std::size_t>(given_)];
    if (turns && !std::isfinite(lower)) lower = std::isfinite(upper) ? upper - whole_turn : -0.5 * whole_turn;
    if (turns && !std::isfinite(upper)) upper = lower + whole_turn;
    const bool ordered = (limits_.lower.array() <= limits_.upper.array()).all();  // false for NaN
    if (!ordered || !std::isfinite(lower) || !std::isfinite(upper)) return none;
    if (solve_(0.5 * (lower + upper)).status == Status::invalid) return none;
    return given_joint::intervals({this, margin}, lower, upper);
  }

  /// Returns the solutions within limits for one value, the nearest to `centre` first, one of each branch.
  [[nodiscard]] auto rows(double value, const Joints<dof>& centre) const {
    return nearest_within_limits(solve_(value), limits_, revolute_, centre);
  }

  /// Returns them for the value with which the joints are farthest from their limits, or, with a seed, for
  /// the value nearest to the seed's.
  [[nodiscard]] auto rows(const GivenIntervals& found) const {
    return rows(found, found.widest_margin_at, Joints<dof>::Zero());
  }
  [[nodiscard]] auto rows(const GivenIntervals& found, const Joints<dof>& seed) const {
    return rows(found, found.nearest(seed[given_]), seed);
  }

 private:
  [[nodiscard]] auto rows(const GivenIntervals& found, double value, const Joints<dof>& centre) const {
    auto result = rows(value, centre);
    if (found.empty()) {
      result.clear();
      result.status = found.status;
    }
    return result;
  }

  static given_joint::Margin margin(const void* functions, double value) {
    const auto& arm = *static_cast<const GivenJoint*>(functions);
    const auto found = arm.solve_(value);
    given_joint::Margin best;
    best.is_incomplete = found.status == Status::incomplete;
    for (const auto& row : found) {
      const Joints<dof> margins = given_joint::margins_of<dof>(row.q, arm.given_, arm.limits_, arm.revolute_);
      const Joints<dof> rates = given_joint::rates_of(arm.jacobian_(Joints<dof>(row.q)), arm.given_);
      best.value = std::max(best.value, margins.minCoeff());
      best.way = std::min(best.way, given_joint::way_of<dof>(margins, rates));
    }
    return best;
  }

  int given_;
  std::array<bool, joints> revolute_;
  JointLimits<dof> limits_;
  Solve solve_;
  Jacobian jacobian_;
};

}  // namespace inverse
}  // namespace qvgen
