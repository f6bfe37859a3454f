// SPDX-License-Identifier: MIT
// Motion of closed loops: how passive joints follow the given ones, by rates, by accelerations and by
// Newton's steps, and the forces that the loops carry. Generated sources include it, their headers do not.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>
#include <qvgen/assembly.h>
#include <qvgen/detail/linear_system.h>
#include <qvgen/inverse/tolerances.h>
#include <qvgen/limb.h>

namespace qvgen {

/// Rows of a limb's joints, from those of all joints.
template <std::size_t count, int dof, int columns>
Eigen::Matrix<double, static_cast<int>(count), columns> rows_of(
    const std::array<LimbJoint, count>& limb, const Eigen::Matrix<double, dof, columns>& rows) {
  Eigen::Matrix<double, static_cast<int>(count), columns> result;
  for (int j = 0; j < columns; ++j)
    for (std::size_t i = 0; i < count; ++i)
      result(static_cast<int>(i), j) = limb[i].ratio * rows(limb[i].joint, j);
  return result;
}

/// Rates of all joints for rates of the given ones: dq/da, one row a joint and one column a given joint.
/// `jacobian` has the loops' equations by all joints, `factors` is of its columns of the passive ones. Not
/// finite at dead centres.
template <int rows, int dof, std::size_t passive_count, std::size_t given_count>
Eigen::Matrix<double, dof, static_cast<int>(given_count)> loop_rates(
    const detail::LinearSystem<rows>& factors, const Eigen::Matrix<double, rows, dof>& jacobian,
    const std::array<int, passive_count>& passive, const std::array<int, given_count>& given) {
  static_assert(rows == static_cast<int>(passive_count), "as many equations as passive joints");
  Eigen::Matrix<double, dof, static_cast<int>(given_count)> rates;
  const auto place = [](int i) { return static_cast<std::size_t>(i); };
  factors.template solve_each<static_cast<int>(given_count)>(
      [&](int i, int j) { return jacobian(i, given[place(j)]); },
      [&](int i, int j, double value) { rates(passive[place(i)], j) = -value; });
  for (std::size_t i = 0; i < given_count; ++i)
    for (std::size_t j = 0; j < given_count; ++j) rates(given[i], static_cast<int>(j)) = i == j ? 1 : 0;
  return rates;
}

/// Likewise where each equation has one given joint to itself: `own[i]` is the place of equation i's in
/// `given`.
template <int rows, int dof, std::size_t count>
Eigen::Matrix<double, dof, static_cast<int>(count)> loop_rates(
    const detail::LinearSystem<rows>& factors, const Eigen::Matrix<double, rows, dof>& jacobian,
    const std::array<int, count>& passive, const std::array<int, count>& given,
    const std::array<int, count>& own) {
  static_assert(rows == static_cast<int>(count), "as many equations as passive and as given joints");
  Eigen::Matrix<double, dof, static_cast<int>(count)> rates;
  const auto place = [](int i) { return static_cast<std::size_t>(i); };
  factors.solve_diagonal(
      [&](int i) { return jacobian(i, given[place(own[place(i)])]); },
      [&](int i, int j, double value) { rates(passive[place(i)], own[place(j)]) = -value; });
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) rates(given[i], static_cast<int>(j)) = i == j ? 1 : 0;
  return rates;
}

/// Accelerations of all joints at which the given ones have none: what their rates alone make of the passive
/// ones. `bias` is the loops' second derivative by time at those rates.
template <int dof, int rows, std::size_t passive_count>
Joints<dof> loop_bias(const detail::LinearSystem<rows>& factors,
                      const std::array<int, passive_count>& passive,
                      const Eigen::Matrix<double, rows, 1>& bias) {
  const Eigen::Matrix<double, rows, 1> solved = factors.solve(bias);
  Joints<dof> result = Joints<dof>::Zero();
  for (std::size_t i = 0; i < passive_count; ++i) result[passive[i]] = -solved[static_cast<int>(i)];
  return result;
}

namespace detail {

/// A vector whose last `old` numbers are replaced by others. Those before them are of a floating base, or
/// none.
template <int old, int size, int count>
Eigen::Matrix<double, size - old + count, 1> behind_base(const Eigen::Matrix<double, size, 1>& of,
                                                         const Eigen::Matrix<double, count, 1>& joints) {
  constexpr int base = size - old;
  static_assert(base == 0 || base == 6, "the six motions of a base, or none");
  Eigen::Matrix<double, base + count, 1> result;
  result.template head<base>() = of.template head<base>();
  result.template tail<count>() = joints;
  return result;
}

}  // namespace detail

/// Motion of a floating base, which passes through, and of all joints, from those of the base and of the
/// given joints. Without a base `motion` has as many numbers as `rates` has columns.
template <int dof, int given, int size>
Eigen::Matrix<double, size - given + dof, 1> whole_motion(const Eigen::Matrix<double, dof, given>& rates,
                                                          const Eigen::Matrix<double, size, 1>& motion) {
  const Eigen::Matrix<double, given, 1> by = motion.template tail<given>();
  return detail::behind_base<given>(motion, Joints<dof>(rates * by));
}

/// Wrench on a floating base, which passes through, and forces of the motors, from the wrench and forces of
/// all joints.
template <int dof, int given, int size>
Eigen::Matrix<double, size - dof + given, 1> motor_forces(const Eigen::Matrix<double, dof, given>& rates,
                                                          const Eigen::Matrix<double, size, 1>& forces) {
  const Joints<dof> of_joints = forces.template tail<dof>();
  return detail::behind_base<dof>(forces, Joints<given>(rates.transpose() * of_joints));
}

/// Mass matrix of a floating base, if there is one, and the given joints, from that of the base and all
/// joints.
template <int dof, int given, int size>
Eigen::Matrix<double, size - dof + given, size - dof + given> motor_masses(
    const Eigen::Matrix<double, dof, given>& rates, const Eigen::Matrix<double, size, size>& masses) {
  constexpr int base = size - dof;
  static_assert(base == 0 || base == 6, "the six motions of a base, or none");
  const Eigen::Matrix<double, dof, dof> of_joints = masses.template bottomRightCorner<dof, dof>();
  Eigen::Matrix<double, base + given, base + given> result;
  result.template bottomRightCorner<given, given>() =
      detail::transposed_times(rates, detail::times(of_joints, rates));
  if constexpr (base > 0) {
    const Eigen::Matrix<double, base, dof> beside = masses.template topRightCorner<base, dof>();
    const Eigen::Matrix<double, base, given> moved = detail::times(beside, rates);
    result.template topLeftCorner<base, base>() = masses.template topLeftCorner<base, base>();
    result.template topRightCorner<base, given>() = moved;
    result.template bottomLeftCorner<given, base>() = moved.transpose();
  }
  return result;
}

/// Forces that the loops carry, one an equation, N: a rod's pushes its ends apart, a pin's is along the
/// directions of its gap and acts on the first link. `forces` are those that all joints would need if the
/// loops were open, rad or m; the passive ones have no motors, so the loops bear theirs. Not finite at dead
/// centres.
template <int rows, int dof, std::size_t passive_count>
Eigen::Matrix<double, rows, 1> loop_forces(const detail::LinearSystem<rows>& factors,
                                           const std::array<int, passive_count>& passive,
                                           const Joints<dof>& forces) {
  Eigen::Matrix<double, rows, 1> borne;
  for (std::size_t i = 0; i < passive_count; ++i) borne[static_cast<int>(i)] = forces[passive[i]];
  return factors.solve_transposed(borne);
}

/// Measure, from 0 to 1, of how well some joints are held by the loops if the others are given: 0 where they
/// can move although the others stand still. The determinant by these joints, divided by the lengths of its
/// rows; one that is but rounding next to the others counts as longer than it is.
template <int rows, int dof, std::size_t count>
double loop_measure(const Eigen::Matrix<double, rows, dof>& jacobian, const std::array<int, count>& held) {
  const double least = inverse::tolerance::least_row * jacobian.norm();
  double lengths = 1;
  for (int i = 0; i < rows; ++i) lengths *= std::max(jacobian.row(i).norm(), least);
  return lengths > 0 ? std::abs(detail::LinearSystem<rows>(jacobian, held).determinant()) / lengths : 0;
}

/// Follows the loops to new values of the given joints, from joints nearby, by Newton's steps of the passive
/// ones: 30 at most, each of no more than 0.5 rad or m. `gaps` and `jacobian` are functions of q, and the
/// Jacobian is asked for where the gaps have just been; `enough` is the gap, m, that counts as closed. It is
/// an iteration: it leads to one assembly, which need not be the seed's where the way is long.
template <int dof, std::size_t passive_count, class Gaps, class Jacobian>
Followed<dof> follow_loops(Joints<dof> q, const std::array<int, passive_count>& passive, const Gaps& gaps,
                           const Jacobian& jacobian, double enough) {
  constexpr int rows = static_cast<int>(passive_count);
  Followed<dof> found;
  found.q = q;
  double side = 0;
  for (;; ++found.steps) {
    const auto gap = gaps(found.q);
    found.gap = gap.cwiseAbs().maxCoeff();
    found.closed = gap.allFinite() && found.gap <= enough;
    if (found.closed || found.steps == 30 || !gap.allFinite()) return found;
    const detail::LinearSystem<rows> factors(jacobian(found.q), passive);
    const double determinant = factors.determinant();
    if (found.steps == 0) side = determinant;
    found.crossed = (determinant < 0) != (side < 0);
    const Eigen::Matrix<double, rows, 1> left = gap.template head<rows>();
    Eigen::Matrix<double, rows, 1> way = factors.solve(left);
    const double longest = way.cwiseAbs().maxCoeff();
    if (!(longest < 1e300)) return found;
    if (longest > 0.5) way *= 0.5 / longest;
    for (std::size_t i = 0; i < passive_count; ++i) found.q[passive[i]] -= way[static_cast<int>(i)];
  }
}

/// Brings assemblies that hardly miss to where they close the loops as well as rounding lets them, by
/// Newton's steps; those that lead elsewhere are not taken. Rows that meet another so are left out; false
/// then, since what was next to it is lost. `gaps`, `jacobian` and `enough`: as follow_loops has them.
template <int dof, int capacity, std::size_t count, std::size_t passive_count, class Gaps, class Jacobian>
bool close_well(Assemblies<dof, capacity>& found, const std::array<bool, count>& revolute,
                const std::array<int, passive_count>& passive, const Gaps& gaps, const Jacobian& jacobian,
                double enough) {
  constexpr double next_to = 1e-3;  // rad or m
  int kept = 0;
  for (Solution<dof>& row : found) {
    const Followed<dof> closed = follow_loops<dof>(row.q, passive, gaps, jacobian, enough);
    if (closed.closed && (closed.q - row.q).cwiseAbs().maxCoeff() < next_to) row.q = closed.q;
    const bool is_known = std::any_of(found.begin(), found.begin() + kept, [&](const Solution<dof>& other) {
      return joint_distance<dof>(other.q, row.q, revolute) < inverse::same_assembly;
    });
    if (!is_known) found[kept++] = row;
  }
  const bool are_all = kept == found.size();
  found.truncate(kept);
  return are_all;
}

/// Brings rows that chains of joints have found to where they close the loops to rounding, and leaves out
/// those that do not: a chain of few joints reaches poses that are only nearly its own. Marks rows that meet
/// another, or are at a dead centre. False if rows were lost. `size`: of the mechanism, m.
template <int dof, int capacity, std::size_t count, std::size_t passive_count, class Gaps, class Jacobian>
bool close_chains(Assemblies<dof, capacity>& found, const std::array<bool, count>& revolute,
                  const std::array<int, passive_count>& passive, const Gaps& gaps, const Jacobian& jacobian,
                  double size) {
  const double closed = inverse::rounding_of_loops * size;
  const bool are_all = close_well(found, revolute, passive, gaps, jacobian, closed / 4);
  int kept = 0;
  for (const Solution<dof>& row : found)
    if (gaps(row.q).cwiseAbs().maxCoeff() <= closed) found[kept++] = row;
  found.truncate(kept);
  for (const Solution<dof>& row : found) {
    const bool meets_other = std::any_of(found.begin(), found.end(), [&](const Solution<dof>& other) {
      return &other != &row && joint_distance<dof>(other.q, row.q, revolute) < inverse::meeting_assemblies;
    });
    if (meets_other || loop_measure(jacobian(row.q), passive) < inverse::dead_centre)
      found.meeting.set(static_cast<std::size_t>(row.branch));
  }
  return are_all;
}

}  // namespace qvgen
