// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/seed.h>
#include <qvgen/inverse/seed_branch.h>
#include <qvgen/inverse/tasks.h>
#include <qvgen/simd/lanes.h>

/// Newton's steps of all joints of an arm at once. A wrist that is solved behind an arm makes much of what
/// rounding leaves of the arm's joints, where both are singular; all joints together need not.
namespace qvgen::inverse {

/// Branch number of a row that Newton's steps have found, not the equations.
inline constexpr int unknown_branch = -1;

template <int dof, int points>
using ArmMatching = PointMatching<double, static_cast<std::size_t>(dof), static_cast<std::size_t>(points)>;

/// The tool's point (`points` 1) or its whole pose (3) at the zero pose, and where it is to be.
template <int points, int dof>
ArmMatching<dof, points> matching(const ArmAtZero<dof>& arm, const Pose<double>& pose) {
  const Pose<double> moved = pose.normalised() * arm.tool.inverse();
  const double square = pose.position.squaredNorm() + arm.tool.position.squaredNorm();
  // An arm without size may measure turns by any length.
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

using Four = simd::Lanes<double, simd::Doubles<4>>;

/// How far joint values leave the points off their goals, the largest distance squared. All points side by
/// side and no Jacobian: a quarter of what an evaluation for a Newton step takes.
template <int points, int dof>
double miss_square(const ArmMatching<dof, points>& task, const Preference<dof>& values) {
  // The fourth point is the first once more.
  constexpr std::size_t b = 1 % points, c = 2 % points;
  Four x[3], goal[3];
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = Four(task.start[0][k], task.start[b][k], task.start[c][k], task.start[0][k]);
    goal[k] = Four(task.goal[0][k], task.goal[b][k], task.goal[c][k], task.goal[0][k]);
  }
  for (std::size_t i = dof; i-- > 0;) {
    const Screw<double>& screw = task.arm[i];
    const Triple<double>& a = screw.axis;
    if (!screw.revolute) {
      for (std::size_t k = 0; k < 3; ++k) x[k] += values.slide[static_cast<int>(i)] * a[k];
      continue;
    }
    const Rotor<double>& turn = values.turn[i];
    const Four u = x[0] - screw.point[0];
    const Four v = x[1] - screw.point[1];
    const Four w = x[2] - screw.point[2];
    const Four along = (a[0] * u + a[1] * v + a[2] * w) * (1 - turn.cosine);
    x[0] = screw.point[0] + turn.cosine * u + turn.sine * (a[1] * w - a[2] * v) + along * a[0];
    x[1] = screw.point[1] + turn.cosine * v + turn.sine * (a[2] * u - a[0] * w) + along * a[1];
    x[2] = screw.point[2] + turn.cosine * w + turn.sine * (a[0] * v - a[1] * u) + along * a[2];
  }
  Four error = 0;
  for (std::size_t k = 0; k < 3; ++k) error += (goal[k] - x[k]) * (goal[k] - x[k]);
  return std::max({error[0], error[1], error[2]});
}

/// True if a row of the equations is to be taken although rounding may have decided it: it brings the tool to
/// the pose, but for rounding, and no joint between the seed and it is nearly free, along which rounding
/// would have moved it.
template <int points, int dof>
bool is_certain_row(const ArmAtZero<dof>& arm, const Pose<double>& pose, const Preference<dof>& seed,
                    const Solutions<dof, 1>& found, const bool* revolute) {
  constexpr double rounding = tolerance::row_rounding * std::numeric_limits<double>::epsilon();
  const auto task = matching<points>(arm, pose);
  if (!(miss_square<points>(task, preference<dof>(found[0].q)) <= rounding * rounding * task.size_square))
    return false;
  const double way = apart(found, seed, revolute);
  return miss_square<points>(task, seed) >=
         tolerance::least_miss * tolerance::least_miss * way * task.size_square;
}

/// True if the seed misses the pose by much less than its way to a row lets expect: some joint between them
/// is nearly free. The largest distance of a point, which is quickly known, is at most twice the root of the
/// error: a point off by a turn and a move is off by their sum, and the error has half the square of a turn.
template <int points, int dof>
bool is_nearly_free(const ArmMatching<dof, points>& task, const Preference<dof>& seed,
                    const JointValues<double, static_cast<std::size_t>(dof)>& start, double row_apart,
                    Budget& budget) {
  const double least = tolerance::least_miss * tolerance::least_miss * row_apart * task.size_square;
  if (!budget.step() || miss_square<points>(task, seed) >= 4 * least) return false;
  using Newton = polishing::Newton<double, static_cast<std::size_t>(dof), static_cast<std::size_t>(points)>;
  return Newton(task).reached(start).error < least;
}

/// Keeps the row that is nearer to the seed, and counts what both have cost.
template <int dof>
void take_nearer(const Solutions<dof, 1>& row, const Preference<dof>& seed, const bool* revolute,
                 Solutions<dof, 1>& found) {
  const Effort effort = {found.effort.passes + row.effort.passes, found.effort.steps + row.effort.steps};
  if (apart(row, seed, revolute) < apart(found, seed, revolute)) found = row;
  found.effort = effort;
}

/// True if two rows are one but for rounding: next to a double root half the digits are lost.
template <int dof>
bool is_same_row(const Solution<dof>& a, const Solution<dof>& b, const bool* revolute) {
  double square = 0;
  for (int i = 0; i < dof; ++i) {
    const double difference = a.q[i] - b.q[i];
    const double way = revolute[i] ? without_turns(difference) : difference;
    square += way * way;
  }
  return square < tolerance::same_rows * std::numeric_limits<double>::epsilon();
}

/// Keeps the nearer row likewise, `row` one of Newton's steps. Where the equations are sure of theirs it
/// stays, if it is the same but for rounding.
template <int dof>
void take_nearer_of_steps(const Solutions<dof, 1>& row, const Preference<dof>& seed, const bool* revolute,
                          bool is_sure, Solutions<dof, 1>& found) {
  const bool is_known = is_sure && !row.empty() && !found.empty() && is_same_row(row[0], found[0], revolute);
  if (!is_known) return take_nearer(row, seed, revolute, found);
  found.effort.passes += row.effort.passes;
  found.effort.steps += row.effort.steps;
}

/// The row to which Newton's steps of the whole arm lead from the seed, if they lead to the pose. What is
/// nearly free stays where the seed has it. `row_apart`: how far what has been found is from the seed,
/// squared; where that `is_sure` steps are taken only next to what turns out to be singular.
template <int points, int dof>
Solutions<dof, 1> row_from_seed(const ArmAtZero<dof>& arm, const Pose<double>& pose,
                                const Preference<dof>& seed, double tolerance, bool is_sure,
                                double row_apart) {
  const auto task = matching<points>(arm, pose);
  JointValues<double, static_cast<std::size_t>(dof)> start;
  for (std::size_t i = 0; i < start.size(); ++i)
    start[i] = arm.joints[i].revolute ? seed.turn[i] : Rotor<double>{seed.slide[i], 0};
  SeedTracker<double, static_cast<std::size_t>(dof)> tracker;
  tracker.start_from(Start::seed);
  Solutions<dof, 1> row;
  const bool is_wanted = !is_sure || (std::isfinite(row_apart) &&
                                      is_nearly_free<points>(task, seed, start, row_apart, tracker.budget()));
  auto values = start;
  Branch<double> branch;
  branch.unsure = true;
  if (is_wanted && tracker.settle(0, task, Boundary::ends(tolerance), &start, values, branch)) {
    Joints<dof> q;
    for (int i = 0; i < dof; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      q[i] = arm.joints[joint].revolute ? output_angle(values[joint].cosine, values[joint].sine)
                                        : values[joint].cosine;
    }
    append(row, q, unknown_branch, branch.continuum);
  }
  row.effort = tracker.budget().spent;
  return row;
}

/// Takes that row if it is nearer to the seed than what has been found.
template <int points, int dof>
void follow_whole_arm(const ArmAtZero<dof>& arm, const Pose<double>& pose, const Preference<dof>& seed,
                      double tolerance, const bool* revolute, bool is_sure, Solutions<dof, 1>& found) {
  const double row_apart = apart(found, seed, revolute);
  take_nearer_of_steps(row_from_seed<points>(arm, pose, seed, tolerance, is_sure, row_apart), seed, revolute,
                       is_sure, found);
}

/// Finishes rows in which a wrist is folded, because rounding has put it beyond the end of its range: the
/// joints before it may be at a double root and then carry half the digits. Newton's steps of all joints lead
/// from there to the pose, or there is no such solution. `lead(start)` is the row that they lead to.
template <int points, int dof, int capacity, class Lead>
void finish_folded(const ArmAtZero<dof>& arm, const Pose<double>& pose, double tolerance,
                   const bool* revolute, const Lead& lead, Solutions<dof, capacity>& found) {
  const auto task = matching<points>(arm, pose);
  const double allowed = 2 * std::max(tolerance, tolerance::least_fold);
  int kept = 0;
  for (int k = 0; k < found.size(); ++k) {
    const Preference<dof> start = preference<dof>(found[k].q);
    if (miss_square<points>(task, start) > allowed * allowed * task.size_square) {
      const Solutions<dof, 1> led = lead(start);
      found.effort.steps += led.effort.steps;
      found.effort.used_up = found.effort.used_up || (led.empty() && led.effort.used_up);
      const auto is_known = [&](const Solution<dof>& row) { return is_same_row(row, led[0], revolute); };
      if (led.empty() || std::any_of(found.begin(), found.begin() + kept, is_known) ||
          std::any_of(found.begin() + k + 1, found.end(), is_known))
        continue;
      found[k].q = led[0].q;
      found[k].continuum = found[k].continuum || led[0].continuum;
    }
    if (kept < k) found[kept] = found[k];
    ++kept;
  }
  found.truncate(kept);
  found.conclude();
}

/// The arm with a turn of its tool about an axis of its own, a unit vector, as one more joint: what a task
/// with a direction leaves.
template <int dof>
ArmAtZero<dof + 1> with_tool_turn(const ArmAtZero<dof>& arm, const Vector3<double>& tool_axis) {
  const Vector3<double> axis = arm.tool.orientation * tool_axis;
  const Vector3<double>& point = arm.tool.position;
  ArmAtZero<dof + 1> result;
  std::copy(arm.joints.begin(), arm.joints.end(), result.joints.begin());
  result.joints.back() = {true, {axis.x(), axis.y(), axis.z()}, {point.x(), point.y(), point.z()}};
  result.tool = arm.tool;
  return result;
}

/// The arm with all axes and its tool in the origin, for tasks that leave the position. Of revolute joints.
template <int dof>
ArmAtZero<dof> turns_of(ArmAtZero<dof> arm) {
  for (Screw<double>& joint : arm.joints) joint.point = {0, 0, 0};
  arm.tool.position.setZero();
  return arm;
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

template <int dof>
Preference<dof - 1> without_joint(const Preference<dof>& seed, int still) {
  Preference<dof - 1> rest;
  for (int i = 0; i < dof - 1; ++i) {
    const int joint = i < still ? i : i + 1;
    rest.angle[i] = seed.angle[joint];
    rest.slide[i] = seed.slide[joint];
    rest.choose(i, seed.turn[joint]);
  }
  return rest;
}

/// Rows with the value of one more joint.
template <int dof, int capacity>
Solutions<dof + 1, capacity> with_joint(const Solutions<dof, capacity>& rows, int joint, double value) {
  Solutions<dof + 1, capacity> result;
  for (const Solution<dof>& row : rows) {
    Joints<dof + 1> q;
    for (int i = 0; i < dof; ++i) q[i < joint ? i : i + 1] = row.q[i];
    q[joint] = value;
    append(result, q, row.branch, row.continuum);
  }
  result.effort = rows.effort;
  result.status = rows.status;
  return result;
}

/// Follows the whole arm with one joint given, which the seed has at its value, too.
template <int points, int dof>
void follow_whole_arm(const ArmAtZero<dof>& arm, const Pose<double>& pose, const Preference<dof>& seed,
                      int given, double value, double tolerance, const bool* revolute, bool is_sure,
                      Solutions<dof, 1>& found) {
  const double row_apart = apart(found, seed, revolute);
  const auto rest = row_from_seed<points>(without_joint(arm, given, value), pose, without_joint(seed, given),
                                          tolerance, is_sure, row_apart);
  take_nearer_of_steps(with_joint(rest, given, value), seed, revolute, is_sure, found);
}

/// Finishes rows near singular poses in which a wrist is folded, of an arm whose joints are all asked for.
template <int points, int dof, int capacity>
void finish_folded(const ArmAtZero<dof>& arm, const Pose<double>& pose, double tolerance,
                   const bool* revolute, Solutions<dof, capacity>& found) {
  const auto lead = [&](const Preference<dof>& start) {
    return row_from_seed<points>(arm, pose, start, tolerance, false, 0);
  };
  finish_folded<points>(arm, pose, tolerance, revolute, lead, found);
}
/// Finishes such rows with one joint given.
template <int points, int dof, int capacity>
void finish_folded(const ArmAtZero<dof>& arm, const Pose<double>& pose, int given, double value,
                   double tolerance, const bool* revolute, Solutions<dof, capacity>& found) {
  const auto lead = [&](const Preference<dof>& start) {
    return with_joint(row_from_seed<points>(without_joint(arm, given, value), pose,
                                            without_joint(start, given), tolerance, false, 0),
                      given, value);
  };
  finish_folded<points>(arm, pose, tolerance, revolute, lead, found);
}

/// The first number that no row has.
template <int dof, int capacity>
int free_branch(const Solutions<dof, capacity>& rows) {
  int branch = 0;
  const auto has_it = [&](const Solution<dof>& row) { return row.branch == branch; };
  while (std::any_of(rows.begin(), rows.end(), has_it)) ++branch;
  return branch;
}

/// Puts a row next to the seed in front of all solutions, which stand by their distance from it, if there is
/// one that these do not have: in place of the nearest one where a joint is free or nearly free, and else as
/// one that has been missing, as others may be, with a number that no other has. `follow(is_sure, nearest)`:
/// see `follow_whole_arm`.
template <int dof, int capacity, class Follow>
void add_row_at_seed(const Preference<dof>& seed, const bool* revolute, const Follow& follow,
                     Solutions<dof, capacity>& found) {
  Solutions<dof, 1> nearest;
  if (!found.empty()) nearest.append() = found[0];
  if (found.status == Status::invalid) return;
  const bool is_sure = found.effort.passes == 0;
  const double row_apart = apart(nearest, seed, revolute);
  // Steps that rounding makes on a continuum would add up.
  if (is_sure ? is_next_to(nearest, seed, revolute) : row_apart < tolerance::at_seed) return;
  follow(is_sure, nearest);
  found.effort.steps += nearest.effort.steps;
  if (!(apart(nearest, seed, revolute) < row_apart)) return;
  const auto is_known = [&](const Solution<dof>& row) { return is_same_row(row, nearest[0], revolute); };
  if (std::any_of(found.begin(), found.end(), is_known)) return;
  const bool is_joined = !found.empty() && (is_sure || found[0].continuum || nearest[0].continuum);
  const bool replaces = is_joined || found.size() == capacity;
  const int branch = replaces ? found[0].branch : free_branch(found);
  if (!replaces) {
    found.append();
    std::move_backward(found.begin(), found.end() - 1, found.end());
  }
  found[0] = nearest[0];
  found[0].branch = branch;
  found.conclude();
  if (!replaces) found.status = Status::incomplete;
}

}  // namespace qvgen::inverse
