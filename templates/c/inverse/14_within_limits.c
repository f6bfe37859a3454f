// Rows within limits at and near singular poses: straight.h and along_continuum.h of the C++ library.

/// Joint values at which the axes before and behind a joint are in line, as those of a wrist are: there the joints of these
/// axes do the same. Closed forms take a wrist for regular up to rounding, and leave its first joint anywhere.
typedef struct Straight {
  bool exists[most_joints];
  double value[most_joints];
} Straight;

static void set_straight(const PointMatching* task, Straight* straight) {
  for (int i = 0; i < task->joints; ++i) straight->exists[i] = false;
  for (int i = 1; i + 1 < task->joints; ++i) {
    const Screw* before = &task->arm[i - 1];
    const Screw* here = &task->arm[i];
    const Screw* behind = &task->arm[i + 1];
    double first[3], last[3], across[3];
    cross(here->axis, before->axis, first);
    cross(here->axis, behind->axis, last);
    cross(last, first, across);
    const double inclined = dot(first, first), unlike = inclined - dot(last, last);
    if (!before->revolute || !here->revolute || !behind->revolute) continue;
    straight->exists[i] = inclined > tolerance_inclined && fabs(unlike) < tolerance_inclined;
    straight->value[i] = atan2(dot(here->axis, across), dot(last, first));
  }
}

/// True if some joint is next to such a value, or to the opposite one.
static bool is_straight(const Straight* straight, int joints, const Steps* q) {
  for (int i = 1; i + 1 < joints; ++i)
    if (straight->exists[i] && fabs(without_turns(2 * (q->of[i] - straight->value[i]))) < tolerance_idle) return true;
  return false;
}

/// Rows within limits that are asked for: of the arm without its given joint, which is -1 where none is.
typedef struct LimitedRows {
  PointMatching task;
  JointBounds limits;
  Straight straight;
  int given;
} LimitedRows;

static inline int place_beside(int given, int i) { return given >= 0 && i >= given ? i + 1 : i; }

static Steps steps_of(const LimitedRows* asked, const double* q) {
  Steps steps;
  memset(&steps, 0, sizeof steps);
  for (int i = 0; i < asked->task.joints; ++i) steps.of[i] = q[place_beside(asked->given, i)];
  return steps;
}

static void ask_for_rows(const Arm* whole, int points, const Pose* pose, int given, double value, const double* lower,
                         const double* upper, LimitedRows* asked) {
  const Arm arm = given >= 0 ? without_joint(whole, given, value) : *whole;
  set_matching(&arm, pose, points, &asked->task);
  asked->given = given;
  asked->limits.lower = steps_of(asked, lower);
  asked->limits.upper = steps_of(asked, upper);
  set_straight(&asked->task, &asked->straight);
}

static bool is_any_inside(const LimitedRows* asked, const Solutions* found) {
  for (int k = 0; k < found->count; ++k) {
    const Steps q = steps_of(asked, found->rows[k].q);
    if (are_joints_inside(&asked->task, &asked->limits, &q)) return true;
  }
  return false;
}

/// Moves a row that is outside to where it is inside, if there is such a place on what may be its continuum. Returns whether it
/// is inside then. `left_surface`: see walk_inside.
static bool bring_row(const LimitedRows* asked, bool is_near_singular, Solution* row, Effort* effort, bool* left_surface) {
  Steps q = steps_of(asked, row->q);
  if (are_joints_inside(&asked->task, &asked->limits, &q)) return true;
  const bool is_marked = row->continuum != 0;
  const bool is_free = is_near_singular || is_marked || is_straight(&asked->straight, asked->task.joints, &q);
  const bool is_inside = is_free ? walk_inside(&asked->task, &asked->limits, is_marked, &q, effort, left_surface)
                                 : press_back(&asked->task, &asked->limits, &q, effort);
  for (int i = 0; is_inside && i < asked->task.joints; ++i) row->q[place_beside(asked->given, i)] = q.of[i];
  return is_inside;
}

/// Moves the rows that are outside limits and that the pose leaves free, or nearly so, to where they are inside; at other poses
/// only if none is inside, and only by rounding. The given joint keeps its value. Where none comes inside, but the pose leaves
/// two joints free, the set is incomplete.
static void bring_inside(const Arm* arm, int points, const Pose* pose, int given, double value, const double* lower,
                         const double* upper, Solutions* found) {
  if (found->count == 0) return;
  LimitedRows asked;
  ask_for_rows(arm, points, pose, given, value, lower, upper, &asked);
  const bool is_near_singular = found->effort.passes > 0;
  const bool is_regular = found->status == status_solved && !is_near_singular;
  if (is_regular && is_any_inside(&asked, found)) return;
  bool has_row = false, left_surface = false;
  for (int k = 0; k < found->count; ++k) {
    Effort effort = {0, 0, 0};
    if (bring_row(&asked, is_near_singular, &found->rows[k], &effort, &left_surface)) has_row = true;
    found->effort.steps += effort.steps;
  }
  if (has_row || !left_surface) return;
  found->effort.used_up = 1;
  found->status = status_incomplete;
}

/// True if the row next to a seed is outside limits, if there is one.
static bool is_outside(const double* lower, const double* upper, const Solutions* found) {
  for (int i = 0; found->count > 0 && i < dof; ++i)
    if (!(found->rows[0].q[i] >= lower[i] && found->rows[0].q[i] <= upper[i])) return true;
  return false;
}

/// Adds whole turns until each angle of the row next to a seed is within half a turn of the seed's.
static void unwind_row(const double* seed, Solutions* found) {
  for (int i = 0; found->count > 0 && i < dof; ++i)
    if (is_revolute[i]) found->rows[0].q[i] = seed[i] + without_turns(found->rows[0].q[i] - seed[i]);
}
