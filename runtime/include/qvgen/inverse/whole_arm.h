// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/request.h>
#include <qvgen/inverse/seed_branch.h>
#include <qvgen/inverse/tasks.h>

/// Newton's steps of all joints of an arm at once. A wrist that is solved behind an arm makes much of what
/// rounding leaves of the arm's joints, where both are singular; all joints together need not.
namespace qvgen::inverse {

template <int dof, int points>
using ArmMatching = PointMatching<double, static_cast<std::size_t>(dof), static_cast<std::size_t>(points)>;

/// The tool's point (`points` 1) or its whole pose (3) at the zero pose, and where it is to be.
template <int points, int dof>
ArmMatching<dof, points> matching(const ArmAtZero<dof>& arm, const Pose<double>& pose) {
  const Pose<double> moved = pose.normalised() * arm.tool.inverse();
  const double square = pose.position.squaredNorm() + arm.tool.position.squaredNorm();
  // Of an arm without size: any length serves to measure turns by.
  const double size = square > 0 ? std::sqrt(square) : 1;
  ArmMatching<dof, points> task;
  task.arm = arm.joints;
  task.size_square = size * size;
  for (int i = 0; i < points; ++i) {
    Vector3<double> start = arm.tool.position;
    if (i > 0) start[i - 1] += size;
    const Vector3<double> goal = points == 1 ? pose.position : moved * start;
    task.start[static_cast<std::size_t>(i)] = {start.x(), start.y(), start.z()};
    task.goal[static_cast<std::size_t>(i)] = {goal.x(), goal.y(), goal.z()};
  }
  return task;
}

/// Whether the seed misses the pose by much less than its way to a row lets expect: something between them is
/// nearly free.
template <std::size_t joints, std::size_t points>
bool is_nearly_free(const PointMatching<double, joints, points>& task,
                    const JointValues<double, joints>& seed, double row_apart, Budget& budget) {
  constexpr double share = 0.05;
  if (!budget.step()) return false;
  const double error = polishing::Newton<double, joints, points>(task).reached(seed).error;
  return error < share * share * row_apart * task.size_square;
}

/// Keeps the row that is nearer to the seed, and counts what both have cost.
template <int dof>
void take_nearer(const Solutions<dof, 1>& row, const Preference<dof>& seed, const bool* revolute,
                 Solutions<dof, 1>& found) {
  const Effort effort = {found.effort.passes + row.effort.passes, found.effort.steps + row.effort.steps};
  if (apart(row, seed, revolute) < apart(found, seed, revolute)) found = row;
  found.effort = effort;
}

/// Where Newton's steps of the whole arm lead from the seed, if they lead to the pose and nearer to the seed
/// than what has been found: where that `is_sure`, only next to what turns out to be singular. What is nearly
/// free stays where the seed has it.
template <int points, int dof>
void follow_whole_arm(const ArmAtZero<dof>& arm, const Pose<double>& pose, const Preference<dof>& seed,
                      double tolerance, const bool* revolute, bool is_sure, Solutions<dof, 1>& found) {
  const auto task = matching<points>(arm, pose);
  JointValues<double, static_cast<std::size_t>(dof)> start;
  for (std::size_t i = 0; i < start.size(); ++i)
    start[i] = revolute[i] ? seed.turn[i] : Rotor<double>{seed.slide[i], 0};
  SeedTracker<double, static_cast<std::size_t>(dof)> tracker;
  if (is_sure &&
      (found.empty() || !is_nearly_free(task, start, apart(found, seed, revolute), tracker.budget())))
    return;
  auto values = start;
  Branch<double> branch;
  branch.unsure = true;
  tracker.start_from(Start::seed);
  Solutions<dof, 1> row;
  if (tracker.settle(0, task, Boundary::ends(tolerance), &start, values, branch)) {
    Joints<dof> q;
    for (int i = 0; i < dof; ++i) {
      const auto& value = values[static_cast<std::size_t>(i)];
      q[i] = revolute[i] ? output_angle(value.cosine, value.sine) : value.cosine;
    }
    append(row, q, found.empty() ? 0 : found[0].branch, branch.continuum);
  }
  row.effort = tracker.budget().spent;
  take_nearer(row, seed, revolute, found);
}

/// An arm one of whose joints stands still: the others of it.
template <int dof>
ArmAtZero<dof - 1> without_joint(const ArmAtZero<dof>& arm, int still, double value) {
  const Screw<double>& screw = arm.joints[static_cast<std::size_t>(still)];
  const Rotor<double> turn =
      screw.revolute ? Rotor<double>{std::cos(value), std::sin(value)} : Rotor<double>{value, 0};
  ArmAtZero<dof - 1> rest;
  for (int i = 0; i < dof - 1; ++i) {
    Screw<double>& joint = rest.joints[static_cast<std::size_t>(i)];
    joint = arm.joints[static_cast<std::size_t>(i < still ? i : i + 1)];
    if (i < still) continue;
    if (screw.revolute) joint.axis = turned(screw, turn, joint.axis);
    joint.point = moved(screw, turn, joint.point);
  }
  ArmAtZero<1> alone;
  alone.joints[0] = screw;
  alone.tool = arm.tool;
  rest.tool = tool_of(alone, Eigen::Matrix<double, 1, 1>(value));
  return rest;
}

/// The same with one joint where it is given.
template <int points, int dof>
void follow_whole_arm(const ArmAtZero<dof>& arm, const Pose<double>& pose, const Preference<dof>& seed,
                      int given, double value, double tolerance, const bool* revolute, bool is_sure,
                      Solutions<dof, 1>& found) {
  Preference<dof - 1> rest_seed;
  bool rest_revolute[dof - 1];
  const auto place = [&](int i) { return i < given ? i : i + 1; };
  for (int i = 0; i < dof - 1; ++i) {
    rest_seed.angle[i] = seed.angle[place(i)];
    rest_seed.slide[i] = seed.slide[place(i)];
    rest_seed.choose(i, seed.turn[place(i)]);
    rest_revolute[i] = revolute[place(i)];
  }
  Solutions<dof - 1, 1> rest;
  rest.effort = found.effort;
  if (!found.empty()) {
    Joints<dof - 1> q;
    for (int i = 0; i < dof - 1; ++i) q[i] = found[0].q[place(i)];
    append(rest, q, found[0].branch, found[0].continuum);
    rest.status = found.status;
  }
  follow_whole_arm<points>(without_joint(arm, given, value), pose, rest_seed, tolerance, rest_revolute,
                           is_sure, rest);
  found.clear();
  for (const Solution<dof - 1>& row : rest) {
    Joints<dof> q;
    q[given] = value;
    for (int i = 0; i < dof - 1; ++i) q[place(i)] = row.q[i];
    append(found, q, row.branch, row.continuum);
  }
  found.status = rest.status;
  found.effort = rest.effort;
}

/// Puts a row next to the seed in front of all solutions, which stand by their distance from it, if there is
/// one that these do not have: in place of the nearest one where a joint is free or nearly free, and else as
/// one that has been missing, as others may be. `follow(is_sure, nearest)`: see `follow_whole_arm`.
template <int dof, int capacity, class Follow>
void add_row_at_seed(const Preference<dof>& seed, const bool* revolute, const Follow& follow,
                     Solutions<dof, capacity>& found) {
  Solutions<dof, 1> nearest;
  if (!found.empty()) nearest.append() = found[0];
  if (found.status == Status::invalid) return;
  const bool is_sure = found.effort.passes == 0;
  const double row_apart = apart(nearest, seed, revolute);
  // Steps that rounding makes on a continuum would add up.
  if (is_sure ? is_next_to(nearest, seed, revolute) : row_apart < 1e-12) return;
  follow(is_sure, nearest);
  found.effort.steps += nearest.effort.steps;
  if (!(apart(nearest, seed, revolute) < row_apart)) return;
  const bool is_joined = !found.empty() && (is_sure || found[0].continuum || nearest[0].continuum);
  const bool replaces = is_joined || found.size() == capacity;
  if (!replaces) {
    found.append();
    std::move_backward(found.begin(), found.end() - 1, found.end());
  }
  found[0] = nearest[0];
  found.conclude();
  if (!replaces) found.status = Status::incomplete;
}

}  // namespace qvgen::inverse
