// SPDX-License-Identifier: MIT
// Assemblies of closed loops: joint values of the whole mechanism for given values of some of its joints. The
// equations are those of inverse kinematics, and so is the set: rows with branches, a status, orders and
// limits. Loops add where two assemblies meet. How passive joints move with the given ones is in
// loop_motion.h.
#pragma once

#include <array>
#include <bitset>
#include <cmath>

#include <Eigen/Core>
#include <qvgen/inverse/branch.h>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/solutions.h>

namespace qvgen {

/// Assemblies for given joints, in the order of their branches, none twice. A row has the values of all
/// joints. Its branch is a number of which sign each step took, which stays along a path without dead
/// centres.
///
/// Status: `unreachable` if the loops cannot be closed there, `singular` if a row's passive joint is free
/// (its `continuum`), `incomplete` if an equation has lost its meaning (three centres in line), `invalid` for
/// NaN.
template <int dof, int capacity>
struct Assemblies : Solutions<dof, capacity> {
  std::bitset<static_cast<std::size_t>(capacity)> meeting;  ///< by branch

  /// True if another assembly is so near that both meet: at a dead centre, or where a parallelogram may fold.
  [[nodiscard]] bool meets(const Solution<dof>& row) const {
    return meeting[static_cast<std::size_t>(row.branch)];
  }
};

namespace inverse {

/// Two assemblies that meet are one if their joints, rad or m, are nearer than this: the root of rounding.
inline constexpr double same_assembly = 6e-8;
/// Assemblies that a chain has found meet if their joints, rad or m, are nearer than this.
inline constexpr double meeting_assemblies = 1e-6;
/// They are at a dead centre if the loops' measure of the passive joints is less.
inline constexpr double dead_centre = 1e-9;
/// Gap, as a share of the size, that rounding may leave of loops.
inline constexpr double rounding_of_loops = 1e-13;
/// Gap, as a share of the size, of poses for chains of fewer joints than there are equations.
inline constexpr double pose_of_few_joints = 1e-11;

/// True if all joint values are finite: infinity times zero is no number.
template <int dof>
bool are_finite(const Joints<dof>& q) {
  return (0.0 * q).sum() == 0;
}

/// Appends a row on which nothing is free and that meets no other. Returns its joints, which are those of `q`
/// until the passive ones are put there; for generated code.
template <int dof, int capacity>
Joints<dof>& append_regular(Assemblies<dof, capacity>& found, const Joints<dof>& q, int branch) {
  Solution<dof>& row = found.append();
  row = {q, branch, false};
  return row.q;
}

/// Appends a row, but for one that an earlier row it meets is; for generated code.
template <int dof, int capacity, std::size_t count>
void append_assembly(Assemblies<dof, capacity>& found, const Joints<dof>& q, int branch, bool is_free,
                     bool meets, const std::array<bool, count>& revolute) {
  if (meets)
    for (const Solution<dof>& row : found)
      if (found.meets(row) && joint_distance<dof>(row.q, q, revolute) < same_assembly) return;
  if (meets) found.meeting.set(static_cast<std::size_t>(branch));
  append(static_cast<Solutions<dof, capacity>&>(found), q, branch, is_free);
}

/// Marks a branch with what is so of another one, which was followed apart from it.
template <typename Scalar>
void join(const Branch<Scalar>& other, Branch<Scalar>& branch) {
  branch.exists = branch.exists & other.exists;
  branch.continuum = branch.continuum | other.continuum;
  branch.unsure = branch.unsure | other.unsure;
}

/// How far outside of an equation's range, as a share of it, a step of closed loops is still taken.
inline constexpr double end_of_loops = 1e-14;

/// Boundary of steps of closed loops: taken at their word, and no farther outside than rounding.
constexpr Boundary boundary_of_loops() {
  Boundary boundary = Boundary::plain(0);
  boundary.accept = end_of_loops;
  boundary.near = 1;
  return boundary;
}

/// Brings angles next to those of the seed by whole turns, and sorts the rows by their distance from it,
/// nearest first.
template <int dof, int capacity, std::size_t count>
void put_near(Assemblies<dof, capacity>& found, const Joints<dof>& seed, const std::array<bool, count>& given,
              const std::array<bool, count>& revolute) {
  for (Solution<dof>& row : found)
    for (int i = 0; i < dof; ++i)
      if (revolute[static_cast<std::size_t>(i)] && !given[static_cast<std::size_t>(i)])
        row.q[i] = seed[i] + qvgen::turn_between(seed[i], row.q[i]);
  sort_by_distance(static_cast<Solutions<dof, capacity>&>(found), seed, revolute);
}

}  // namespace inverse

/// Outcome of following loops from a seed.
template <int dof>
struct Followed {
  Joints<dof> q;
  bool closed = false;  ///< false: Newton's steps have not closed the loops; q is where they have ended
  /// True if a dead centre lies between the seed and q: the determinant that is zero there has changed its
  /// sign. q is then on another branch than the seed was.
  bool crossed = false;
  int steps = 0;   ///< of Newton
  double gap = 0;  ///< the widest gap that is left at q, m
};

}  // namespace qvgen
