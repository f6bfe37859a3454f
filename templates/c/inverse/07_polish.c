// Newton's steps from joint values to the goals.

/// The joints that move the points next to nothing beyond what the others can do.
static Dependent idle_joints(const Matching* task, const Reached* at) {
  Columns a;
  a.count = task->joints;
  a.rows = rows_of_task(task);
  for (int i = 0; i < a.count; ++i) memcpy(a.of[i], at->jacobian[i], (size_t)a.rows * sizeof(double));
  return dependent(&a);
}

/// The least squares of J step = off and, damped, lambda step = 0, some joints held.
static Steps least_squares_of(const Matching* task, const Reached* at, const double* off, bool damped,
                              double lambda, double nothing, const Held* held) {
  const int rows = rows_of_task(task);
  Columns a;
  double b[most_rows] = {0};
  a.count = task->joints;
  a.rows = damped ? rows + a.count : rows;
  memcpy(b, off, (size_t)rows * sizeof(double));
  memset(a.of, 0, sizeof a.of);
  for (int i = 0; i < most_joints; ++i) {  // GCC 12 does not see that count is no more
    if (i >= a.count || held->is[i]) continue;
    memcpy(a.of[i], at->jacobian[i], (size_t)rows * sizeof(double));
    if (damped) a.of[i][rows + i] = lambda;
  }
  return least_squares(&a, b, nothing);
}

static Steps newton_step(const Matching* task, const Reached* at, double lambda, double nothing,
                         const Held* held) {
  const bool is_near = at->error < tolerance_undamped * task->size_square;
  return least_squares_of(task, at, at->off, !is_near, lambda, nothing, held);
}

/// The step of all joints in which one goes so far and the others make up for what it does, to first order.
static Steps following(const Matching* task, const Reached* at, int joint, double by) {
  Held held = nothing_held;
  held.is[joint] = true;
  double off[6] = {0};
  for (int k = 0; k < rows_of_task(task); ++k) off[k] = -by * at->jacobian[joint][k];
  Steps result = least_squares_of(task, at, off, false, 0, tolerance_idle, &held);
  result.by[joint] = by;
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
    memset(best->jacobian, 0, sizeof best->jacobian);
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
    const Steps by = newton_step(task, &at, tolerance_damping * sqrt(at.error), nothing, held);
    for (int i = 0; i < task->joints; ++i) advance(task, i, halves ? 2 * by.by[i] : by.by[i], &now);
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
