// Rows of a task that have to reach more than its equations say: pose_filter.h of the C++ library.

/// Keeps the rows that also reach the tool's point (`points` 1) or the whole pose (3), of rows that solve less than
/// that.
typedef struct Reaching {
  PointMatching task;
  double tolerance;
  bool is_incomplete;
  int capacity;
  Budget budget;
  JointValues known[capacity];
  JointValues starts[capacity];  // of the first round, by branch
} Reaching;

static void start_reaching(Reaching* kept, const Arm* arm, const Pose* pose, int points, double tolerance,
                           int rows, int steps, Solutions* found) {
  const Budget budget = {0, steps, false, {0, 0, 0}};
  set_matching(arm, pose, points, &kept->task);
  kept->tolerance = tolerance;
  kept->is_incomplete = false;
  kept->capacity = rows;
  kept->budget = budget;
  memset(kept->starts, 0, sizeof kept->starts);
  start_solutions(found);
}

static void add_effort(const Effort* more, Effort* effort) {
  effort->passes += more->passes;
  effort->steps += more->steps;
  effort->used_up = effort->used_up || more->used_up;
}

static void keep_reaching(Reaching* kept, const double* q, const JointValues* values, int branch,
                          bool continuum, Solutions* found) {
  if (found->count == kept->capacity) return;
  for (int k = 0; k < found->count; ++k)
    if (are_same(kept->task.joints, &kept->known[k], values)) return;
  // Two places of one continuum have its branch; each row has its own.
  for (int k = 0; k < found->count; ++k) {
    if (found->rows[k].branch != branch) continue;
    branch = (branch + 1) % kept->capacity;
    k = -1;
  }
  kept->known[found->count] = *values;
  Solution* row = &found->rows[found->count++];
  memcpy(row->q, q, dof * sizeof *row->q);
  row->branch = branch;
  row->continuum = continuum;
}

/// Next to a continuum, not on it, all choices lead to one place, and the tool's orientation asks for another,
/// up to a quarter of a turn away, where nothing says to which side: goes along what is idle, another way each
/// round. False if there is no budget left.
static bool go_along_idle(Reaching* kept, int round, JointValues* values, Reached* at) {
  const PointMatching* task = &kept->task;
  const double golden_angle = constant_golden_angle;
  const Dependent idle = idle_joints(task->joints, task->points, at);
  if (idle.least == task->joints) return true;
  const Reached here = *at;
  move_along(task, &here, idle.least, without_turns(round * golden_angle), values);
  if (!may_step(&kept->budget)) return false;
  reach(task, values, at);
  return true;
}

static bool has_branch(const Solutions* found, int branch) {
  for (int k = 0; k < found->count; ++k)
    if (found->rows[k].branch == branch) return true;
  return false;
}

static void look_at_row(Reaching* kept, const Row* from, double near, int round, Solutions* found) {
  const PointMatching* task = &kept->task;
  const double exact = 4 * DBL_EPSILON, same = tolerance_same_start;
  double q[dof];
  JointValues values;
  memcpy(q, from->q, sizeof q);
  for (int i = 0; i < dof; ++i)
    values.of[i] = task->arm[i].revolute ? rotor(cos(q[i]), sin(q[i])) : rotor(q[i], 0);
  if (!may_step(&kept->budget)) return;
  Reached at;
  reach(task, &values, &at);
  JointValues* start = &kept->starts[from->branch % kept->capacity];
  const bool next_to_continuum =
      from->continuum && round > 0 && distance_square(task->joints, start, &values) < same * same;
  if (round == 0) *start = values;
  if (next_to_continuum && !go_along_idle(kept, round, &values, &at)) return;
  const double off = at.error / task->size_square;
  if (!(from->continuum || off < near * near)) return;
  const bool reaches = off < exact * exact;
  if (!reaches && !polish(task, patience(kept->tolerance), &values, &at, &kept->budget, &nothing_held)) return;
  for (int i = 0; i < dof && (!reaches || round > 0); ++i)
    q[i] = task->arm[i].revolute ? output_angle(values.of[i].cosine, values.of[i].sine, 1)
                                 : values.of[i].cosine;
  const bool continuum = from->continuum && is_continuum(task, &values, &at, &kept->budget);
  if (continuum && round > 0 && (!next_to_continuum || has_branch(found, from->branch))) return;
  keep_reaching(kept, q, &values, from->branch, continuum, found);
}

/// How far off a row may be that Newton's steps are to bring to the pose: near a singular pose what a direction is
/// may have but few digits; a pose off by the tolerance moves a double root by the square root of that.
static double near_enough(const Effort* effort, double tolerance) {
  const double few_digits = effort->steps > 0 ? tolerance_near_enough_singular : tolerance_near_enough;
  const double moved = tolerance_near_enough_by_tolerance * sqrt(tolerance);
  if (!(moved > few_digits)) return few_digits;
  return moved < tolerance_near_enough_at_most ? moved : tolerance_near_enough_at_most;
}

/// Looks at every row, all on continua from wherever they are; in rounds after the first at other places of these.
static void look_at_rows(Reaching* kept, const Rows* rows, int round, Solutions* found) {
  add_effort(&rows->effort, &found->effort);
  kept->is_incomplete = kept->is_incomplete || rows->status == status_incomplete;
  for (int i = 0; i < rows->count; ++i)
    if (round == 0 || rows->rows[i].continuum)
      look_at_row(kept, &rows->rows[i], near_enough(&rows->effort, kept->tolerance), round, found);
}

static void conclude_reaching(Reaching* kept, Solutions* found) {
  add_effort(&kept->budget.spent, &found->effort);
  for (int i = 1; i < found->count; ++i) {
    const Solution row = found->rows[i];
    int at = i;
    for (; at > 0 && row.branch < found->rows[at - 1].branch; --at) found->rows[at] = found->rows[at - 1];
    found->rows[at] = row;
  }
  conclude_solutions(found);
  if (kept->is_incomplete) found->status = status_incomplete;
}
