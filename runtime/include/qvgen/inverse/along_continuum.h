// SPDX-License-Identifier: MIT
// Sets of rows within limits at and near singular poses: what the pose leaves free is moved to where all
// joints are inside (continuum_walk.h), before the rows within limits are chosen.
#pragma once

#include <qvgen/inverse/continuum_walk.h>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/straight.h>
#include <qvgen/inverse/whole_arm.h>

namespace qvgen::inverse {

/// Moves rows along their continua to where all joints are inside limits.
template <int dof, int points>
class AlongContinuum {
 public:
  AlongContinuum(const ArmAtZero<dof>& arm, const Pose<double>& pose, const JointLimits<dof>& limits)
      : task_(matching<points>(arm, pose)), limits_{steps_of(limits.lower), steps_of(limits.upper)} {}

  /// Moves a row of what may be a continuum, as `walk_inside` does.
  bool bring_inside(Joints<dof>& q, bool is_marked, Effort& effort) {
    Steps values = steps_of(q);
    const bool found = walk_inside(task_, limits_, is_marked, values, effort, left_surface_);
    if (found) q = Eigen::Map<const Joints<dof>>(values.data());
    return found;
  }

  /// Brings a row back that rounding alone has put outside, as `press_back` does.
  bool bring_back(Joints<dof>& q, Effort& effort) const {
    Steps values = steps_of(q);
    const bool found = press_back(task_, limits_, values, effort);
    if (found) q = Eigen::Map<const Joints<dof>>(values.data());
    return found;
  }

  /// True if a row has been left of which others on its surface may be inside.
  [[nodiscard]] bool has_left_surface() const { return left_surface_; }

 private:
  static constexpr auto joints = static_cast<std::size_t>(dof);
  using Steps = polishing::Steps<double, joints>;

  static Steps steps_of(const Joints<dof>& q) {
    Steps values;
    std::copy(q.data(), q.data() + dof, values.begin());
    return values;
  }

  ArmMatching<dof, points> task_;
  JointBounds<double, joints> limits_;
  bool left_surface_ = false;
};

/// Moves the rows that are outside limits and that the pose leaves free, or nearly so, to where they are
/// inside. Where none is, but the pose leaves two joints free, the set is incomplete.
template <int points, int dof, int capacity, std::size_t count>
void bring_inside(const ArmAtZero<dof>& arm, const Pose<double>& pose, const JointLimits<dof>& limits,
                  const std::array<bool, count>& revolute, Solutions<dof, capacity>& found) {
  const Within<dof> within(limits, revolute, Joints<dof>::Zero());
  const Straight<dof> straight(arm);
  AlongContinuum<dof, points> along(arm, pose, limits);
  const bool is_near_singular = found.effort.passes > 0;
  bool is_any_inside = false;
  for (Solution<dof>& row : found) {
    Joints<dof> q = row.q;
    const bool is_free = is_near_singular || row.continuum || straight.holds(row.q);
    const bool is_inside = within.take(q) || (is_free ? along.bring_inside(row.q, row.continuum, found.effort)
                                                      : along.bring_back(row.q, found.effort));
    is_any_inside = is_any_inside || is_inside;
  }
  if (is_any_inside || !along.has_left_surface()) return;
  found.effort.used_up = true;
  found.status = Status::incomplete;
}

/// Brings the rows of an arm with a given joint inside the limits; the given joint keeps its value.
template <int points, int dof, int capacity, std::size_t count>
void bring_inside(const ArmAtZero<dof>& arm, const Pose<double>& pose, int given, double value,
                  const JointLimits<dof>& limits, const std::array<bool, count>& revolute,
                  Solutions<dof, capacity>& found) {
  JointLimits<dof - 1> others;
  std::array<bool, count - 1> kinds;
  for (int i = 0; i < dof - 1; ++i) {
    const int joint = i < given ? i : i + 1;
    others.lower[i] = limits.lower[joint];
    others.upper[i] = limits.upper[joint];
    kinds[static_cast<std::size_t>(i)] = revolute[static_cast<std::size_t>(joint)];
  }
  Solutions<dof - 1, capacity> rest;
  for (const Solution<dof>& row : found) {
    Joints<dof - 1> q;
    for (int i = 0; i < dof - 1; ++i) q[i] = row.q[i < given ? i : i + 1];
    append(rest, q, row.branch, row.continuum);
  }
  rest.effort = found.effort;
  bring_inside<points>(without_joint(arm, given, value), pose, others, kinds, rest);
  found.effort = rest.effort;
  if (rest.status == Status::incomplete) found.status = rest.status;
  for (int k = 0; k < found.size(); ++k)
    for (int i = 0; i < dof - 1; ++i) found[k].q[i < given ? i : i + 1] = rest[k].q[i];
}

/// Rows within limits, of all solutions: `choose(found)`. Where that leaves none, or the pose is near a
/// singular one, `bring(found)` moves what is free before.
template <int dof, int capacity, class Choose, class Bring>
auto chosen_within(Solutions<dof, capacity>&& found, const Choose& choose, const Bring& bring) {
  const bool is_regular = found.status == Status::solved && found.effort.passes == 0;
  if (!is_regular) bring(found);
  auto rows = choose(found);
  if (!rows.empty() || found.empty() || !is_regular) return rows;
  bring(found);
  rows = choose(found);
  return rows;
}

}  // namespace qvgen::inverse
