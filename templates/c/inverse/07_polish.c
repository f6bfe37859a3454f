// Newton's steps from joint values to the goals.

/// The joints that move the points next to nothing beyond what the others can do.
static Dependent idle_joints(const Matching* task, const Reached* at) {
  return dependent(task->joints, rows_of_task(task), at->jacobian, tolerance_idle);
}

/// The least squares of J step = off and, damped, lambda step = 0, some joints held.
static Vector least_squares_of(const Matching* task, const Reached* at, const double* off, bool damped,
                               double lambda, double nothing, const Held* held) {
  const int rows = rows_of_task(task);
  Columns a = {{{{0}}}};
  Vector b = {{0}};
  for (int k = 0; k < rows; ++k) b.of[k] = off[k];
  for (int i = 0; i < most_joints; ++i) {  // GCC 12 does not see that there are no more
    if (i >= task->joints || held->of[i]) continue;
    for (int k = 0; k < rows; ++k) a.of[i].of[k] = at->jacobian.of[i].of[k];
    if (damped) a.of[i].of[rows + i] = lambda;
  }
  return least_squares(task->joints, damped ? rows + task->joints : rows, &a, &b, nothing);
}

static Vector newton_step(const Matching* task, const Reached* at, double lambda, double nothing,
                          const Held* held) {
  const bool is_near = at->error < tolerance_undamped * task->size_square;
  return least_squares_of(task, at, at->off, !is_near, lambda, nothing, held);
}

/// The step of all joints in which one goes so far and the others make up for what it does, to first order.
static Vector following(const Matching* task, const Reached* at, int joint, double by) {
  Held held = nothing_held;
  held.of[joint] = true;
  double off[6] = {0};
  for (int k = 0; k < rows_of_task(task); ++k) off[k] = -by * at->jacobian.of[joint].of[k];
  Vector result = least_squares_of(task, at, off, false, 0, tolerance_idle, &held);
  result.of[joint] = by;
  return result;
}

/// When polishing ends.
typedef struct Patience {
  double allowed;  // how far off their goals the points may be left, as a share of the size
  int idle_steps;  // so many steps in a row may leave more than `gain` of the squared distances
  double gain;
} Patience;

static Patience patience(double allowed) {
  const Patience usual = {allowed, 3, 0.5};
  return usual;
}

/// Brings joint values to where they carry the points to their goals, by damped Newton steps (Levenberg,
/// Marquardt). Returns whether what the best of them miss is no more than is allowed or than rounding; NaN is
/// not. At a double root a step halves what is left, and is doubled then; it may have to step aside first:
/// hence the patience.
static bool polish(const Matching* task, Patience until, JointValues* values, Reached* best, Budget* budget,
                   const Held* held) {
  normalise(task, values);
  const double rounding = DBL_EPSILON * DBL_EPSILON * task->size_square;
  const double half_the_digits = sqrt(DBL_EPSILON);
  if (!may_step(budget)) {
    const Columns none = {{{{0}}}};
    best->jacobian = none;
    memset(best->off, 0, sizeof best->off);
    best->error = task->size_square;  // far off
    return false;
  }
  reach(task, values, best);
  JointValues now = *values;
  Reached at = *best;
  bool halves = false;
  bool stuck = false;
  for (int idle = 0; best->error > tolerance_settled * rounding && idle < until.idle_steps && may_step(budget);) {
    // Directions that hardly move the points are left alone, unless it does not go on without them.
    const double nothing = stuck ? tolerance_noise * DBL_EPSILON : half_the_digits;
    const Vector by = newton_step(task, &at, tolerance_damping * sqrt(at.error), nothing, held);
    for (int i = 0; i < task->joints; ++i) advance(task, i, halves ? 2 * by.of[i] : by.of[i], &now);
    const double before = at.error;
    reach(task, &now, &at);
    // The square of a square: half the way to a double root leaves a sixteenth.
    halves = at.error > tolerance_least_halved * before && at.error < tolerance_most_halved * before;
    idle = at.error < until.gain * best->error ? 0 : idle + 1;
    if (!stuck && until.idle_steps > 1 && 2 * idle >= until.idle_steps && best->error > tolerance_stuck * rounding) {
      stuck = true;
      idle = 0;
    }
    if (!(at.error < best->error)) continue;
    *best = at;
    *values = now;
  }
  const double share = larger(until.allowed, tolerance_reached * DBL_EPSILON);
  return best->error <= share * share * task->size_square;
}
