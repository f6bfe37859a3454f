/// How often a pose may be worked at: counted, so that the bound holds by construction.
typedef struct Budget {
  int passes;
  int steps;
  Effort spent;
} Budget;

static bool take_of_budget(int* spent, int most, int* used_up) {
  const bool allowed = *spent < most;
  *spent += allowed ? 1 : 0;
  *used_up = *used_up || !allowed;
  return allowed;
}

static bool may_pass(Budget* budget) {
  return take_of_budget(&budget->spent.passes, budget->passes, &budget->spent.used_up);
}

static bool may_step(Budget* budget) {
  return take_of_budget(&budget->spent.steps, budget->steps, &budget->spent.used_up);
}

static inline void cross(const double* a, const double* b, double* result) {
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];
  result[2] = a[0] * b[1] - a[1] * b[0];
  result[0] = x;
  result[1] = y;
}

static inline double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static inline void difference(const double* a, const double* b, double* result) {
  for (int k = 0; k < 3; ++k) result[k] = a[k] - b[k];
}

static inline void set_triple(double* triple, double x, double y, double z) {
  triple[0] = x;
  triple[1] = y;
  triple[2] = z;
}

/// A joint at the zero pose: unit axis and, for a revolute one, a point on it.
typedef struct Screw {
  bool revolute;
  double axis[3], point[3];
} Screw;

/// A direction turned about a revolute joint's axis, in place.
static void turn_direction(const Screw* screw, Rotor value, double* v) {
  double side[3];
  cross(screw->axis, v, side);
  const double along = dot(screw->axis, v) * (1 - value.cosine);
  for (int k = 0; k < 3; ++k) v[k] = value.cosine * v[k] + value.sine * side[k] + along * screw->axis[k];
}

/// A point carried by a joint, in place. Value of a joint: an angle as its pair, a length in the cosine's
/// place.
static void move_point(const Screw* screw, Rotor value, double x[3]) {
  if (screw->revolute) {
    difference(x, screw->point, x);
    turn_direction(screw, value, x);
  }
  for (int k = 0; k < 3; ++k) x[k] += screw->revolute ? screw->point[k] : screw->axis[k] * value.cosine;
}

/// Joints that are to carry points to their goals: one point is a position, three that are no line a whole
/// pose, the second and third in two directions at right angles from the first, the arm's size away.
typedef struct Matching {
  int joints, points;
  Screw arm[most_joints];
  double start[3][3], goal[3][3];
  double size_square;
} Matching;

typedef struct JointValues {
  Rotor of[most_joints];
} JointValues;

/// Joints that keep their values while the others are polished.
typedef struct Held {
  bool is[most_joints];
} Held;

static const Held nothing_held = {{false}};

static double values_apart(int joints, const JointValues* a, const JointValues* b) {
  double sum = 0;
  for (int i = 0; i < joints; ++i) {
    const double x = a->of[i].cosine - b->of[i].cosine;
    const double y = a->of[i].sine - b->of[i].sine;
    sum += x * x + y * y;
  }
  return sum;
}

/// A joint's value changed by so many radians or metres.
static void advance(const Matching* task, int joint, double by, JointValues* values) {
  Rotor* value = &values->of[joint];
  if (task->arm[joint].revolute)
    *value = turned_by(*value, by);
  else
    value->cosine += by;
}

static void normalise(const Matching* task, JointValues* values) {
  for (int i = 0; i < task->joints; ++i)
    if (task->arm[i].revolute) values->of[i] = scaled(1 / sqrt(square_of(values->of[i])), values->of[i]);
}

static double length_of_arc(const Matching* task, int joint, double angle) {
  return task->arm[joint].revolute ? angle : angle * sqrt(task->size_square);
}

/// A least-squares problem's columns.
typedef struct Columns {
  int count, rows;
  double of[most_joints][most_rows];
} Columns;

typedef struct Steps {
  double by[most_joints];
} Steps;

static double sum_of_products(const double* a, const double* b, int size) {
  if (size % 2 == 0) {
    // As two numbers in a register.
    double even = a[0] * b[0], odd = a[1] * b[1];
    for (int i = 2; i < size; i += 2) {
      even += a[i] * b[i];
      odd += a[i + 1] * b[i + 1];
    }
    return even + odd;
  }
  double sum = 0;
  for (int i = 0; i < size; ++i) sum += a[i] * b[i];
  return sum;
}

/// Takes a column's direction out of v and returns how much of the column that was; `scale` is 1 / its
/// square.
static double take_out(const double* column, double scale, double* v, int rows) {
  const double share = sum_of_products(column, v, rows) * scale;
  for (int i = 0; i < rows; ++i) v[i] += -share * column[i];
  return share;
}

/// The x for which the columns' combination comes nearest to b, by modified Gram-Schmidt. A column that adds
/// less than `nothing`, as a share of the longest, is left out: a free joint stays. Uses up columns and b.
static Steps least_squares(Columns* a, double* b, double nothing) {
  double longest = 0;
  for (int i = 0; i < a->count; ++i) longest = larger(longest, sum_of_products(a->of[i], a->of[i], a->rows));
  double r[most_joints][most_joints] = {{0}};
  Steps x = {{0}};
  for (int i = 0; i < a->count; ++i) {
    const double square = sum_of_products(a->of[i], a->of[i], a->rows);
    if (!(square > nothing * nothing * longest)) continue;
    r[i][i] = square;
    const double scale = 1 / square;
    for (int j = i + 1; j < a->count; ++j) r[i][j] = take_out(a->of[i], scale, a->of[j], a->rows);
    x.by[i] = take_out(a->of[i], scale, b, a->rows);
  }
  for (int i = a->count; i-- > 0;)
    for (int j = i + 1; j < a->count && r[i][i] > 0; ++j) x.by[i] -= r[i][j] * x.by[j];
  return x;
}

/// The columns that add less than a share of the longest to the others, and the one that adds least.
typedef struct Dependent {
  Held columns;
  int least;      // as many as there are: none
  double square;  // of what that one adds
} Dependent;

/// Always takes the longest of what is left. Uses up the columns.
static Dependent dependent(Columns* a) {
  const double nothing = digits(1e-5);
  Dependent result;
  for (int i = 0; i < a->count; ++i) result.columns.is[i] = true;
  result.square = 0;
  double limit = 0;
  for (int taken = 0; taken < a->count; ++taken) {
    int longest = a->count;
    double square[most_joints] = {0};
    result.least = a->count;
    for (int i = 0; i < a->count; ++i) {
      if (!result.columns.is[i]) continue;
      square[i] = sum_of_products(a->of[i], a->of[i], a->rows);
      if (longest == a->count || square[i] > square[longest]) longest = i;
      if (result.least == a->count || square[i] <= square[result.least]) result.least = i;
    }
    limit = larger(limit, nothing * nothing * square[longest]);
    if (!(square[longest] > limit)) {
      result.square = square[result.least];
      return result;
    }
    result.columns.is[longest] = false;
    const double scale = 1 / square[longest];
    for (int i = 0; i < a->count; ++i)
      if (result.columns.is[i]) take_out(a->of[longest], scale, a->of[i], a->rows);
  }
  result.least = a->count;
  return result;
}

/// Place that joint values reach, with derivatives. Rows: the position; for a whole pose also the orientation, as a
/// rotation vector times the size.
typedef struct Reached {
  double jacobian[most_joints][6];
  double off[6];  // goal - reached
  double error;   // its square, of turns beyond the first order too
} Reached;

static int rows_of_task(const Matching* task) { return task->points == 1 ? 3 : 6; }

static void reached_position(const Matching* task, const JointValues* values, Reached* result) {
  double x[3];
  memcpy(x, task->start[0], sizeof x);
  for (int i = task->joints; i-- > 0;) {
    const Screw* screw = &task->arm[i];
    double* column = result->jacobian[i];
    move_point(screw, values->of[i], x);
    if (screw->revolute) {
      difference(x, screw->point, column);
      cross(screw->axis, column, column);
    } else {
      memcpy(column, screw->axis, sizeof screw->axis);
    }
    for (int k = i + 1; screw->revolute && k < task->joints; ++k)
      turn_direction(screw, values->of[i], result->jacobian[k]);
  }
  difference(task->goal[0], x, result->off);
  result->error = dot(result->off, result->off);
}

/// The columns of a rotation matrix.
typedef struct Frame {
  double of[3][3];
} Frame;

static void turn_by_frame(const Frame* frame, double x, double y, double z, double* result) {
  for (int k = 0; k < 3; ++k) result[k] = x * frame->of[0][k] + y * frame->of[1][k] + z * frame->of[2][k];
}

/// The frame after a turn about an axis of its own.
static void turn_frame(const double* a, Rotor turn, Frame* frame) {
  const Frame before = *frame;
  const double along = 1 - turn.cosine;
  const double side[3] = {turn.sine * a[0], turn.sine * a[1], turn.sine * a[2]};
  const double xy = along * a[0] * a[1], yz = along * a[1] * a[2], zx = along * a[2] * a[0];
  turn_by_frame(&before, turn.cosine + along * a[0] * a[0], xy + side[2], zx - side[1], frame->of[0]);
  turn_by_frame(&before, xy - side[2], turn.cosine + along * a[1] * a[1], yz + side[0], frame->of[1]);
  turn_by_frame(&before, zx + side[1], yz - side[0], turn.cosine + along * a[2] * a[2], frame->of[2]);
}

/// The directions from the first point to the others, and at right angles to both, against those of the
/// goals.
static void set_miss(const Matching* task, const Frame* frame, const double* x, double size,
                     Reached* result) {
  const double scale = 1 / size;
  double now[3][3], then[3][3], away[3], turn[3] = {0, 0, 0};
  for (int p = 0; p < 2; ++p) {
    double from[3], to[3], way[3];
    difference(task->start[p + 1], task->start[0], way);
    turn_by_frame(frame, way[0], way[1], way[2], from);
    difference(task->goal[p + 1], task->goal[0], to);
    for (int k = 0; k < 3; ++k) {
      now[p][k] = scale * from[k];
      then[p][k] = scale * to[k];
    }
  }
  cross(now[0], now[1], now[2]);
  cross(then[0], then[1], then[2]);
  difference(task->goal[0], x, away);
  double gap_square = 0;
  for (int p = 0; p < 3; ++p) {
    double side[3], gap[3];
    cross(now[p], then[p], side);
    difference(then[p], now[p], gap);
    gap_square += dot(gap, gap);
    for (int k = 0; k < 3; ++k) turn[k] += side[k];
  }
  for (int k = 0; k < 3; ++k) {
    result->off[k] = away[k];
    result->off[3 + k] = 0.5 * size * turn[k];
  }
  result->error = dot(away, away) + 0.5 * task->size_square * gap_square;
}

/// `place` is where the point `at` of the zero pose has come: from there to another point.
static void go_to(const Frame* frame, const double* to, double* at, double* place) {
  double way[3], turned[3];
  difference(to, at, way);
  turn_by_frame(frame, way[0], way[1], way[2], turned);
  for (int k = 0; k < 3; ++k) place[k] += turned[k];
  memcpy(at, to, sizeof way);
}

/// Frames from joint to joint.
static void reached_pose(const Matching* task, const JointValues* values, Reached* result) {
  Frame frame = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double at[3] = {0, 0, 0}, place[3] = {0, 0, 0}, axis[most_joints][3], point[most_joints][3];
  for (int i = 0; i < task->joints; ++i) {
    const Screw* screw = &task->arm[i];
    turn_by_frame(&frame, screw->axis[0], screw->axis[1], screw->axis[2], axis[i]);
    if (!screw->revolute) {
      for (int k = 0; k < 3; ++k) place[k] += values->of[i].cosine * axis[i][k];
      continue;
    }
    go_to(&frame, screw->point, at, place);
    memcpy(point[i], place, sizeof place);
    turn_frame(screw->axis, values->of[i], &frame);
  }
  go_to(&frame, task->start[0], at, place);
  const double size = sqrt(task->size_square);
  for (int i = 0; i < task->joints; ++i) {
    const bool revolute = task->arm[i].revolute;
    double way[3];
    memcpy(way, axis[i], sizeof way);
    if (revolute) {
      difference(place, point[i], way);
      cross(axis[i], way, way);
    }
    for (int k = 0; k < 3; ++k) {
      result->jacobian[i][k] = way[k];
      result->jacobian[i][3 + k] = revolute ? size * axis[i][k] : 0;
    }
  }
  set_miss(task, &frame, place, size, result);
}

static void reach(const Matching* task, const JointValues* values, Reached* result) {
  if (task->points == 1)
    reached_position(task, values, result);
  else
    reached_pose(task, values, result);
}

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
  for (int i = 0; i < a.count; ++i) {
    if (held->is[i]) continue;
    memcpy(a.of[i], at->jacobian[i], (size_t)rows * sizeof(double));
    if (damped) a.of[i][rows + i] = lambda;
  }
  return least_squares(&a, b, nothing);
}

static Steps newton_step(const Matching* task, const Reached* at, double lambda, double nothing,
                         const Held* held) {
  const bool is_near = at->error < digits(1e-12) * task->size_square;
  return least_squares_of(task, at, at->off, !is_near, lambda, nothing, held);
}

/// The step of all joints in which one goes so far and the others make up for what it does, to first order.
static Steps following(const Matching* task, const Reached* at, int joint, double by) {
  Held held = nothing_held;
  held.is[joint] = true;
  double off[6] = {0};
  for (int k = 0; k < rows_of_task(task); ++k) off[k] = -by * at->jacobian[joint][k];
  Steps result = least_squares_of(task, at, off, false, 0, digits(1e-5), &held);
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
  if (!may_step(budget)) return false;
  reach(task, values, best);
  JointValues now = *values;
  Reached at = *best;
  bool halves = false;
  bool stuck = false;
  for (int idle = 0; best->error > 64 * rounding && idle < until.idle_steps && may_step(budget);) {
    // Directions that hardly move the points are left alone, unless it does not go on without them.
    const double nothing = stuck ? 64 * DBL_EPSILON : half_the_digits;
    const Steps by = newton_step(task, &at, 1e-1 * sqrt(at.error), nothing, held);
    for (int i = 0; i < task->joints; ++i) advance(task, i, halves ? 2 * by.by[i] : by.by[i], &now);
    const double before = at.error;
    reach(task, &now, &at);
    // The square of a square: half the way to a double root leaves a sixteenth.
    halves = at.error > 0.03 * before && at.error < 0.13 * before;
    idle = at.error < until.gain * best->error ? 0 : idle + 1;
    if (!stuck && until.idle_steps > 1 && 2 * idle >= until.idle_steps && best->error > 256 * rounding) {
      stuck = true;
      idle = 0;
    }
    if (!(at.error < best->error)) continue;
    *best = at;
    *values = now;
  }
  const double share = larger(until.allowed, 16 * DBL_EPSILON);
  return best->error <= share * share * task->size_square;
}
