// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Core>
#include <qvgen/inverse/least_squares.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/pose.h>

namespace qvgen::inverse {
namespace calibrated {

using Twist = Eigen::Matrix<double, 6, 1>;
template <int dof>
using Columns = Eigen::Matrix<double, 6, dof>;
template <int dof>
using Joints = Eigen::Matrix<double, dof, 1>;

/// True if the joints of two arms turn and slide alike.
template <std::size_t dof>
constexpr bool same_types(const std::array<bool, dof>& a, const std::array<bool, dof>& b) {
  for (std::size_t i = 0; i < dof; ++i)
    if (a[i] != b[i]) return false;
  return true;
}

/// Difference from a pose to a goal, to first order: metres, then a rotation vector.
inline Twist left_to(const Pose<double>& goal, const Pose<double>& at) {
  const Eigen::Quaterniond turn = goal.orientation * at.orientation.conjugate();
  Twist twist;
  twist << goal.position - at.position, std::copysign(2.0, turn.w()) * turn.vec();
  return twist;
}

/// Norm of a twist, rad; its metres are counted in units of the arm's size.
inline double norm(const Twist& twist, double size) {
  return std::sqrt(twist.head<3>().squaredNorm() / (size * size) + twist.tail<3>().squaredNorm());
}

/// The joints' way that the twist calls for; a joint that moves nothing stays.
template <int dof>
Joints<dof> step(const Columns<dof>& jacobian, const Twist& twist, double size) {
  constexpr double nothing = 1e-9;  // of the longest column: what is beyond would be rounding
  std::array<polishing::Vector<double, 6>, static_cast<std::size_t>(dof)> columns;
  polishing::Vector<double, 6> goal;
  for (int i = 0; i < 6; ++i) {
    const double unit = i < 3 ? 1 / size : 1;
    goal[static_cast<std::size_t>(i)] = unit * twist[i];
    for (int k = 0; k < dof; ++k)
      columns[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] = unit * jacobian(i, k);
  }
  const auto solved = polishing::least_squares(columns, goal, nothing);
  return Eigen::Map<const Joints<dof>>(solved.data());
}

}  // namespace calibrated

/// An arm that differs a little from an ideal one with a closed form: its axes were measured, and those that
/// should meet or be parallel miss each other by 1e-4. All its solutions take elimination; the one next to a
/// seed is found here from the ideal arm's, in less time (runtime/docs/inverse.md, Calibrated arms). A
/// description with `ideal = "ur5"` has it as `inverse_kinematics_from_ideal`; by hand:
///
///     namespace ideal = qvgen::robots::ur5;
///     namespace mine = qvgen::robots::ur5_17;
///     const qvgen::inverse::Calibrated arm{
///         [](const auto& pose, const auto& seed) { return ideal::inverse_kinematics_near(pose, seed); },
///         [](const auto& q) { return ideal::forward_kinematics(q); },
///         [](const auto& q) { return mine::forward_kinematics(q); },
///         [](const auto& q) { return mine::jacobian(q); }};
///     const auto row = arm.near(pose, seed);  // one solution or none
///
/// The Jacobian is the geometric one at the tool in the base frame, linear rows first.
template <typename IdealNear, typename IdealForward, typename Forward, typename Jacobian>
class Calibrated {
 public:
  Calibrated(IdealNear ideal_near, IdealForward ideal_forward, Forward forward, Jacobian jacobian)
      : ideal_near_(ideal_near), ideal_forward_(ideal_forward), forward_(forward), jacobian_(jacobian) {}

  /// The ideal arm's solution near the seed, of the pose without what the two arms differ by at the seed, and
  /// from there by Newton's method; where the ideal arm has none, from the seed.
  ///
  /// It is not complete: no row with Status::incomplete says that the steps led to none, not that there is
  /// none. A row reaches the pose to 1e-12 of the arm's size and rad, and is on the branch of the seed as the
  /// ideal arm has it; Status::singular where that stands for a continuum. Status::invalid as the ideal arm
  /// says it. At most 12 steps; no heap, no exceptions.
  template <int dof>
  [[nodiscard]] Solutions<dof, 1> near(const Pose<double>& pose,
                                       const Eigen::Matrix<double, dof, 1>& seed) const {
    const Pose<double> difference = Pose<double>(forward_(seed)).inverse() * ideal_forward_(seed);
    const Solutions<dof, 1> ideal = ideal_near_((pose * difference), seed);
    Solutions<dof, 1> found;
    found.status = ideal.status == Status::invalid ? Status::invalid : Status::incomplete;
    if (found.status == Status::invalid) return found;
    const Reached<dof> reached = newton<dof>(pose.normalised(), ideal.empty() ? seed : ideal[0].q);
    if (!(reached.error < close)) return found;
    append(found, reached.q, ideal.empty() ? -1 : ideal[0].branch, !ideal.empty() && ideal[0].continuum);
    found.conclude();
    return found;
  }

 private:
  static constexpr int most = 12;
  static constexpr double close = 1e-12;

  template <int dof>
  struct Reached {
    Eigen::Matrix<double, dof, 1> q;
    double error = std::numeric_limits<double>::infinity();  ///< of the arm's size and rad
  };

  /// The Jacobian of the first step serves the others as long as the error falls by this: next to the goal it
  /// hardly changes.
  static constexpr double fast = 1e-3;
  /// Rounding: no step makes it smaller.
  static constexpr double settled = 2e-15;

  template <int dof>
  [[nodiscard]] Reached<dof> newton(const Pose<double>& goal, Eigen::Matrix<double, dof, 1> q) const {
    Reached<dof> best;
    calibrated::Columns<dof> columns;
    double size = 1;
    for (int i = 0; i < most; ++i) {
      const calibrated::Twist twist = calibrated::left_to(goal, forward_(q));
      const double before = best.error;
      const double error = calibrated::norm(twist, size);
      if (i == 0 || !(error < fast * before)) {
        columns = jacobian_(q);
        size = columns.template topRows<3>().colwise().norm().maxCoeff() + goal.position.norm();
      }
      if (error < before) best = {q, error};
      const bool no_better = before < close && !(error < before / 2);
      if (error < settled || no_better || !std::isfinite(error)) break;
      q += calibrated::step<dof>(columns, twist, size);
    }
    return best;
  }

  IdealNear ideal_near_;
  IdealForward ideal_forward_;
  Forward forward_;
  Jacobian jacobian_;
};

}  // namespace qvgen::inverse
