// The arm from base to tool, and Newton's steps of all of its joints: whole_arm.h of the C++ library.

/// Joints and tool with all joints at zero.
typedef struct Arm {
  int joints;
  Screw of[most_joints];
  Pose tool;
} Arm;

static void set_screw(Arm* arm, int joint, bool revolute, double axis_x, double axis_y, double axis_z,
                      double x, double y, double z) {
  arm->of[joint].revolute = revolute;
  set_triple(arm->of[joint].axis, axis_x, axis_y, axis_z);
  set_triple(arm->of[joint].point, x, y, z);
}

static Pose carried_by(const Screw* joint, double q, Pose tool) {
  if (!joint->revolute) {
    for (int k = 0; k < 3; ++k) tool.position[k] += q * joint->axis[k];
    return tool;
  }
  const Quaternion turn = turn_about(joint->axis, q);
  double from[3];
  difference(tool.position, joint->point, from);
  turn_vector(turn, from, tool.position);
  for (int k = 0; k < 3; ++k) tool.position[k] += joint->point[k];
  tool.orientation = turn_after(turn, tool.orientation);
  return tool;
}

static Pose tool_of(const Arm* arm, const double* q) {
  Pose tool = arm->tool;
  for (int i = arm->joints; i-- > 0;) tool = carried_by(&arm->of[i], q[i], tool);
  return tool;
}

/// The joints that a pitch is about: what turns the whole arm, the first of those that the pitch is counted about, and
/// what the caller gives, -1 for none.
typedef struct PitchJoints {
  int base, first, given;
} PitchJoints;

/// The direction of a joint's axis with the given joint moved.
static void axis_with_given(const Arm* arm, int given, Quaternion moved, int joint, double* axis) {
  if (given >= 0 && given < joint)
    turn_vector(moved, arm->of[joint].axis, axis);
  else
    memcpy(axis, arm->of[joint].axis, 3 * sizeof *axis);
}

/// A pose that has a position and a pitch: the joint at the base is at zero. It is no rotation where the given joint
/// brings the tool's axis along the axes of the pitch.
static Pose pitched_pose(const Arm* arm, PitchJoints joints, const double* tool_axis, const double* position, double pitch,
                         double given) {
  double q[most_joints] = {0}, base[3], across[3], inclined[3], normal[3], beside[3];
  Quaternion moved = {{1, 0, 0, 0}};
  if (joints.given >= 0) {
    q[joints.given] = given;
    if (arm->of[joints.given].revolute) moved = turn_about(arm->of[joints.given].axis, given);
  }
  axis_with_given(arm, joints.given, moved, joints.base, base);
  axis_with_given(arm, joints.given, moved, joints.first, across);
  const Quaternion tool = tool_of(arm, q).orientation;
  turn_vector(tool, tool_axis, inclined);
  cross(base, inclined, normal);
  cross(inclined, across, beside);
  const double now =
      atan2(projection(across, normal), projection(base, inclined) - projection(across, base) * projection(across, inclined));
  Pose pose = pose_from(no_turn, position);
  pose.orientation = turn_after(turn_about(across, pitch - now), tool);
  if (!(projection(beside, beside) > tolerance_pitched)) memset(pose.orientation.of, 0, sizeof pose.orientation.of);
  return pose;
}

/// The joint that turns the whole arm, and what the caller gives, -1 for none.
typedef struct HeadingJoints {
  int base, given;
} HeadingJoints;

/// A pose with a position at which the tool sees the axis of the joint at the base along `up`.
static Pose inclined_pose(const Arm* arm, HeadingJoints joints, const double* position, const double* up, double given) {
  double base[3], meant[3];
  Quaternion moved = {{1, 0, 0, 0}};
  if (joints.given >= 0 && arm->of[joints.given].revolute) moved = turn_about(arm->of[joints.given].axis, given);
  axis_with_given(arm, joints.given, moved, joints.base, base);
  direction_meant(up, meant);
  Pose pose = pose_from(no_turn, position);
  pose.orientation = shortest_turn(base, meant);
  for (int k = 1; k < 4; ++k) pose.orientation.of[k] = -pose.orientation.of[k];
  return pose;
}

/// The tool's point (`points` 1) or its whole pose (3) at the zero pose, and where it is to be.
static void set_matching(const Arm* arm, const Pose* pose, int points, PointMatching* task) {
  const Pose back = inverse_pose(&arm->tool);
  const Pose unit = with_unit_quaternion(pose);
  const Pose moved = pose_after(&unit, &back);
  const double square =
      projection(pose->position, pose->position) + projection(arm->tool.position, arm->tool.position);
  // An arm without size may measure turns by any length.
  const double size = square > 0 ? sqrt(square) : 1;
  task->joints = arm->joints;
  task->points = points;
  memcpy(task->arm, arm->of, sizeof task->arm);
  task->size_square = size * size;
  for (int i = 0; i < points; ++i) {
    memcpy(task->start[i], arm->tool.position, sizeof task->start[i]);
    if (i > 0) task->start[i][i - 1] += size;
    if (points == 1) {
      memcpy(task->goal[i], pose->position, sizeof task->goal[i]);
      continue;
    }
    turn_vector(moved.orientation, task->start[i], task->goal[i]);
    for (int k = 0; k < 3; ++k) task->goal[i][k] += moved.position[k];
  }
}

/// The arm with a turn of its tool about an axis of its own, a unit vector, as one more joint: what a task
/// with a direction leaves.
static Arm with_tool_turn(Arm arm, double x, double y, double z) {
  const double tool_axis[3] = {x, y, z};
  double axis[3];
  turn_vector(arm.tool.orientation, tool_axis, axis);
  const double* point = arm.tool.position;
  set_screw(&arm, arm.joints++, true, axis[0], axis[1], axis[2], point[0], point[1], point[2]);
  return arm;
}

/// The arm with all axes and its tool in the origin, for tasks that leave the position. Of revolute joints.
static Arm turns_of(Arm arm) {
  for (int i = 0; i < arm.joints; ++i) set_triple(arm.of[i].point, 0, 0, 0);
  set_triple(arm.tool.position, 0, 0, 0);
  return arm;
}

/// An arm one of whose joints stands still: the others of it.
static Arm without_joint(const Arm* arm, int still, double value) {
  const Screw* screw = &arm->of[still];
  const Rotor turn = screw->revolute ? rotor(cos(value), sin(value)) : rotor(value, 0);
  Arm rest = *arm;
  rest.joints = arm->joints - 1;
  for (int i = still; i < rest.joints; ++i) {
    rest.of[i] = arm->of[i + 1];
    if (screw->revolute) turn_direction(screw, turn, rest.of[i].axis);
    move_point(screw, turn, rest.of[i].point);
  }
  rest.tool = carried_by(screw, value, arm->tool);
  return rest;
}

/// How far joint values leave the points off their goals, the largest distance squared.
static double miss_square(const PointMatching* task, const JointValues* values) {
  double largest = 0;
  for (int p = 0; p < task->points; ++p) {
    double x[3];
    memcpy(x, task->start[p], sizeof x);
    for (int i = task->joints; i-- > 0;) move_point(&task->arm[i], values->of[i], x);
    difference(task->goal[p], x, x);
    largest = larger(largest, dot(x, x));
  }
  return largest;
}

/// True if a row of the equations that rounding may have decided is to be taken: it brings the tool to the pose, but
/// for rounding, and nothing between the seed and it is nearly free, along which rounding would have moved it.
static bool is_certain_row(const Arm* arm, int points, const Pose* pose, const Preference* seed,
                           const Nearest* found) {
  const double rounding = tolerance_row_rounding * DBL_EPSILON;
  PointMatching task;
  JointValues row, start;
  set_matching(arm, pose, points, &task);
  for (int i = 0; i < arm->joints; ++i) {
    const double q = found->row.q[i];
    row.of[i] = arm->of[i].revolute ? rotor(cos(q), sin(q)) : rotor(q, 0);
    start.of[i] = arm->of[i].revolute ? seed->turn[i] : rotor(seed->slide[i], 0);
  }
  if (!(miss_square(&task, &row) <= rounding * rounding * task.size_square)) return false;
  return miss_square(&task, &start) >=
         tolerance_least_miss * tolerance_least_miss * nearest_apart(found, seed) * task.size_square;
}

/// True if the seed misses the pose by much less than its way to a row lets expect: something between them is nearly
/// free.
static bool is_nearly_free(const PointMatching* task, const JointValues* seed, double row_apart, Budget* budget) {
  if (!may_step(budget)) return false;
  Reached at;
  reach(task, seed, &at);
  return at.error < tolerance_least_miss * tolerance_least_miss * row_apart * task->size_square;
}

/// The row to which Newton's steps of the whole arm lead from the seed, if they lead to the pose; one joint
/// where it is given, none for -1. What is nearly free stays where the seed has it. `row_apart`: how far what
/// has been found is from the seed, squared; where that `is_sure` steps are taken only next to what turns out
/// to be singular.
static void row_from_seed(const Arm* whole, int points, const Pose* pose, const Preference* seed, int given,
                          double value, double tolerance, bool is_sure, double row_apart, Nearest* row) {
  const Arm arm = given >= 0 ? without_joint(whole, given, value) : *whole;
  PointMatching task;
  JointValues start;
  set_matching(&arm, pose, points, &task);
  memset(&start, 0, sizeof start);
  for (int i = 0; i < arm.joints; ++i) {
    const int joint = given >= 0 && i >= given ? i + 1 : i;
    start.of[i] = arm.of[i].revolute ? seed->turn[joint] : rotor(seed->slide[joint], 0);
  }
  SeedTracker tracker = new_seed_tracker();
  tracker.start = from_seed;
  const bool is_wanted =
      !is_sure || (row_apart < HUGE_VAL && is_nearly_free(&task, &start, row_apart, &tracker.budget));
  JointValues values = start;
  Branch branch = new_branch;
  branch.unsure = true;
  const Boundary boundary = ends_boundary(tolerance);
  if (is_wanted && settle_near_seed(&tracker, &task, &boundary, &start, &values, &branch)) {
    double q[row_size];
    for (int i = 0; i < arm.joints; ++i)
      q[given >= 0 && i >= given ? i + 1 : i] =
          arm.of[i].revolute ? output_angle(values.of[i].cosine, values.of[i].sine, 1) : values.of[i].cosine;
    if (given >= 0) q[given] = value;
    take_row(row, q, -1, branch.continuum);
  }
  row->effort = tracker.budget.spent;
}

/// True if two rows are one but for rounding: next to a double root half the digits are lost.
static bool are_one_row(const double* a, const double* b) {
  double square = 0;
  for (int i = 0; i < dof; ++i) {
    const double difference = a[i] - b[i];
    const double off = is_revolute[i] ? without_turns(difference) : difference;
    square += off * off;
  }
  return square < tolerance_same_rows * DBL_EPSILON;
}

/// True if the seed misses the tool's point by so much that nothing between it and a row so far away is nearly free.
static bool misses_point(const Arm* arm, const Pose* pose, const Preference* seed, double row_apart_square) {
  const double square = projection(pose->position, pose->position) + projection(arm->tool.position, arm->tool.position);
  double x[3], off[3];
  memcpy(x, arm->tool.position, sizeof x);
  for (int i = arm->joints; i-- > 0;)
    move_point(&arm->of[i], arm->of[i].revolute ? seed->turn[i] : rotor(seed->slide[i], 0), x);
  difference(pose->position, x, off);
  const double least = tolerance_least_miss * tolerance_least_miss * row_apart_square * (square > 0 ? square : 1);
  return dot(off, off) >= least;
}

/// Takes that row if it is nearer to the seed than what has been found.
static void follow_whole_arm(const Arm* arm, int points, const Pose* pose, const Preference* seed, int given,
                             double value, double tolerance, bool is_sure, Nearest* found) {
  const double found_apart = nearest_apart(found, seed);
  if (is_sure && (found->count == 0 || misses_point(arm, pose, seed, found_apart))) return;
  Nearest row;
  start_nearest(&row);
  row_from_seed(arm, points, pose, seed, given, value, tolerance, is_sure, found_apart, &row);
  // A row of which the equations are sure stays, if it is the same but for rounding.
  if (is_sure && row.count > 0 && found->count > 0 && are_one_row(row.row.q, found->row.q))
    found->effort.steps += row.effort.steps;
  else
    take_nearer(&row, seed, found);
}

/// Finishes rows in which a wrist is folded, because rounding has put it beyond the end of its range: the joints
/// before it may be at a double root and then carry half the digits. Newton's steps of all joints, but a given one,
/// lead from there to the pose, or there is no such solution.
static void finish_folded(const Arm* arm, int points, const Pose* pose, int given, double value, double tolerance,
                          Rows* found) {
  const double allowed = 2 * larger(tolerance, tolerance_least_fold);
  PointMatching task;
  set_matching(arm, pose, points, &task);
  int kept = 0;
  for (int k = 0; k < found->count; ++k) {
    Preference start;
    JointValues values;
    prefer_seed(found->rows[k].q, &start);
    for (int i = 0; i < arm->joints; ++i)
      values.of[i] = arm->of[i].revolute ? start.turn[i] : rotor(start.slide[i], 0);
    bool is_row = true;
    if (miss_square(&task, &values) > allowed * allowed * task.size_square) {
      Nearest led;
      start_nearest(&led);
      row_from_seed(arm, points, pose, &start, given, value, tolerance, false, 0, &led);
      found->effort.steps += led.effort.steps;
      is_row = led.count > 0;
      if (!is_row && led.effort.used_up) found->effort.used_up = true;
      for (int i = 0; i < found->count; ++i)
        if (is_row && (i < kept || i > k)) is_row = !are_one_row(found->rows[i].q, led.row.q);
      if (is_row) {
        memcpy(found->rows[k].q, led.row.q, sizeof led.row.q);
        found->rows[k].continuum = found->rows[k].continuum || led.row.continuum;
      }
    }
    if (is_row && kept < k) {
      const Row row = found->rows[k];
      found->rows[kept] = row;
    }
    kept += is_row ? 1 : 0;
  }
  found->count = kept;
  conclude(found);
}

/// The first number that no row has.
static int free_branch(const Solutions* rows) {
  for (int branch = 0; branch < rows->count; ++branch) {
    bool has_it = false;
    for (int i = 0; i < rows->count; ++i) has_it = has_it || rows->rows[i].branch == branch;
    if (!has_it) return branch;
  }
  return rows->count;
}

/// True if a set has a row that is this one but for rounding.
static bool has_row(const Solutions* found, const Row* row) {
  for (int k = 0; k < found->count; ++k)
    if (are_one_row(found->rows[k].q, row->q)) return true;
  return false;
}

/// Puts a row next to the seed in front of all solutions, which stand by their distance from it, if there is
/// one that these do not have: in place of the nearest one where a joint is free or nearly free, and else as
/// one that has been missed, as others may be, with a number that no other has.
static void add_row_at_seed(const Arm* arm, int points, const Pose* pose, const Preference* seed, int given,
                            double value, double tolerance, int most_rows_of_set, Solutions* found) {
  Nearest nearest;
  start_nearest(&nearest);
  nearest.count = found->count > 0 ? 1 : 0;
  if (found->count > 0) nearest.row = row_of(&found->rows[0]);
  if (found->status == status_invalid) return;
  const bool is_sure = found->effort.passes == 0;
  const double row_apart = nearest_apart(&nearest, seed);
  // Steps that rounding makes on a continuum would add up.
  if (is_sure ? is_next_to(&nearest, seed) : row_apart < tolerance_at_seed) return;
  follow_whole_arm(arm, points, pose, seed, given, value, tolerance, is_sure, &nearest);
  found->effort.steps += nearest.effort.steps;
  if (!(nearest_apart(&nearest, seed) < row_apart) || has_row(found, &nearest.row)) return;
  const bool is_joined = found->count > 0 && (is_sure || found->rows[0].continuum || nearest.row.continuum);
  const bool replaces = is_joined || found->count == most_rows_of_set;
  const int branch = replaces ? found->rows[0].branch : free_branch(found);
  if (!replaces) {
    for (int i = found->count++; i > 0; --i) {
      const Solution before = found->rows[i - 1];
      found->rows[i] = before;
    }
  }
  found->rows[0] = own_solution(&nearest.row);
  found->rows[0].branch = branch;
  conclude_solutions(found);
  if (!replaces) found->status = status_incomplete;
}
