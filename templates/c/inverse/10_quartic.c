// Newton steps for arms with a quartic, whose roots carry so few digits that much has to be tried.

static inline double clamped(double x, double low, double high) { return smaller(larger(x, low), high); }

/// Place to which a point of the zero pose has moved.
static void carried(const PointMatching* task, const JointValues* values, int point, double x[3]) {
  memcpy(x, task->start[point], sizeof task->start[point]);
  for (int i = task->joints; i-- > 0;) move_point(&task->arm[i], values->of[i], x);
}

/// Sum of the squared distances between the points and their goals.
static double miss(const PointMatching* task, const JointValues* values) {
  double sum = 0;
  for (int p = 0; p < task->points; ++p) {
    double x[3];
    carried(task, values, p, x);
    difference(task->goal[p], x, x);
    sum += dot(x, x);
  }
  return sum;
}

static void add_point(const PointMatching* task, int p, const JointValues* values, Columns* jacobian, Vector* off) {
  double columns[most_joints][3], x[3];
  memcpy(x, task->start[p], sizeof x);
  for (int i = task->joints; i-- > 0;) {
    const Screw* screw = &task->arm[i];
    move_point(screw, values->of[i], x);
    if (screw->revolute) {
      difference(x, screw->point, columns[i]);
      cross(screw->axis, columns[i], columns[i]);
    } else {
      memcpy(columns[i], screw->axis, sizeof screw->axis);
    }
    for (int k = i + 1; screw->revolute && k < task->joints; ++k)
      turn_direction(screw, values->of[i], columns[k]);
  }
  difference(task->goal[p], x, x);
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < task->joints; ++i) jacobian->of[i].of[3 * p + k] = columns[i][k];
    off->of[3 * p + k] = x[k];
  }
}

static int rows_of_points(const PointMatching* task) { return 3 * task->points + task->joints; }

static void point_columns(const PointMatching* task, const JointValues* values, Columns* jacobian, Vector* off) {
  const Columns no_columns = {{{{0}}}};
  const Vector nothing = {{0}};
  *jacobian = no_columns;
  *off = nothing;
  for (int p = 0; p < task->points; ++p) add_point(task, p, values, jacobian, off);
}

static Vector step_of_points(const PointMatching* task, const JointValues* values, double lambda, double nothing,
                             const Held* held) {
  const Vector no_column = {{0}};
  Columns jacobian;
  Vector off;
  point_columns(task, values, &jacobian, &off);
  for (int i = 0; i < task->joints; ++i) {
    jacobian.of[i].of[3 * task->points + i] = lambda;
    if (held->of[i]) jacobian.of[i] = no_column;
  }
  return least_squares(task->joints, rows_of_points(task), &jacobian, &off, nothing);
}

static Dependent idle_joints_at(const PointMatching* task, const JointValues* values) {
  Columns jacobian;
  Vector off;
  point_columns(task, values, &jacobian, &off);
  return dependent(task->joints, rows_of_points(task), jacobian, tolerance_idle);
}

/// Brings joint values to where they carry the points to their goals, by damped Newton steps.
static bool polish_points(const PointMatching* task, double allowed, JointValues* values, Budget* budget, const Held* held) {
  const int most_steps = 60;
  const int most_waits = 6;
  normalise(task, values);
  JointValues now = *values;
  double error = miss(task, &now);
  double least = error;
  const double enough = DBL_EPSILON * DBL_EPSILON * task->size_square;
  const double half_the_digits = sqrt(DBL_EPSILON);
  int waited = 0;
  for (int step = 0; step < most_steps && waited < most_waits && least > enough && may_step(budget); ++step) {
    // Directions that hardly move the points are left alone, unless it does not go on without them.
    const bool stuck = waited >= most_waits / 2 && least > tolerance_stuck * enough;
    const Vector by =
        step_of_points(task, &now, tolerance_damping * sqrt(error), stuck ? tolerance_noise * DBL_EPSILON : half_the_digits, held);
    for (int i = 0; i < task->joints; ++i) advance(task, i, by.of[i], &now);
    error = miss(task, &now);
    ++waited;
    if (!(error < least)) continue;
    least = error;
    *values = now;
    waited = 0;
  }
  const double share = larger(allowed, tolerance_reached * DBL_EPSILON);
  return least <= share * share * task->size_square;
}

static bool points_go_on(const PointMatching* task, const JointValues* values, double allowed, Budget* budget) {
  if (!may_step(budget)) return false;
  const Dependent idle = idle_joints_at(task, values);
  if (idle.least == task->joints) return false;
  const double little = length_of_arc(task, idle.least, tolerance_way_along);
  for (int side = 1; side >= -1; side -= 2) {
    JointValues moved_on = *values;
    advance(task, idle.least, (double)side * little, &moved_on);
    if (polish_points(task, allowed, &moved_on, budget, &idle.is)) return true;
  }
  return false;
}

static bool is_continuum_of_points(const PointMatching* task, const JointValues* values, Budget* budget) {
  return points_go_on(task, values, tolerance_noise * DBL_EPSILON, budget);
}

/// True if values that miss the goals by very little can be moved on and miss them by not much more.
static bool is_nearly_continuum(const PointMatching* task, const JointValues* values, Budget* budget) {
  const double share = miss(task, values) / task->size_square;
  return share < tolerance_nearly_on_continuum && points_go_on(task, values, 4 * sqrt(share), budget);
}

/// True if values that reach the goals can be moved on and miss them by little. Where two solutions merely meet what is
/// missing then is a hundred times as much.
static bool is_next_to_continuum(const PointMatching* task, const JointValues* values, Budget* budget) {
  return points_go_on(task, values, tolerance_next_to_continuum, budget);
}

/// One step of `move_on`, shorter if it does not get nearer; false if none does.
static bool improve(const PointMatching* task, JointValues* values, Budget* budget) {
  if (!may_step(budget)) return false;
  const Dependent idle = idle_joints_at(task, values);
  if (idle.least == task->joints) return polish_points(task, 0, values, budget, &nothing_held);
  const double least = miss(task, values);
  Vector by = step_of_points(task, values, tolerance_damping_along * sqrt(least), 2 * DBL_EPSILON, &nothing_held);
  for (int attempt = 0; attempt < 4; ++attempt) {
    JointValues moved_on = *values;
    for (int i = 0; i < task->joints; ++i) {
      if (!idle.is.of[i]) continue;
      const double most = length_of_arc(task, i, tolerance_longest_along);
      by.of[i] = clamped(by.of[i], -most, most);
      advance(task, i, by.of[i], &moved_on);
      by.of[i] = by.of[i] / 4;
    }
    polish_points(task, 0, &moved_on, budget, &idle.is);
    if (miss(task, &moved_on) < least) {
      *values = moved_on;
      return true;
    }
  }
  return false;
}

/// Moves values that are nearly on a continuum along it, to where it meets the goals. Returns whether it
/// does.
static bool move_on(const PointMatching* task, JointValues* values, Budget* budget) {
  const int rounds = 24;
  const double enough = tolerance_stuck * DBL_EPSILON * DBL_EPSILON * task->size_square;
  for (int round = 0; round < rounds; ++round) {
    if (!improve(task, values, budget)) return false;
    if (miss(task, values) <= enough) return true;
  }
  return false;
}

static bool points_are_joined(const PointMatching* task, const JointValues* a, const JointValues* b, Budget* budget) {
  if (!may_step(budget)) return false;
  const Dependent idle = idle_joints_at(task, a);
  if (idle.least == task->joints) return false;
  JointValues place = place_between(task->joints, a, b);
  return polish_points(task, 0, &place, budget, &idle.is) && lies_between(task->joints, &place, a, b);
}

/// Branches that have led to a solution; that came near one and have none; that have been left to a pass that
/// chooses; that have come near a continuum, and to no solution of their own on it; that near one have come to
/// the solution of another branch alone; whose wrist cannot follow to what has been chosen.
typedef enum Mark { has_settled, has_missed, is_left, has_strayed, has_shared, has_turned_back, marks } Mark;

/// State of each branch, and the solutions so far.
typedef struct Visited {
  int branches;
  bool marked[marks][most_branches];
  Known known;
  Budget budget;
  bool again;  // branches that have led to a solution are followed again, to others
  bool before[marks][most_branches];
} Visited;

/// Begins or ends a pass in which branches that have led to a solution are followed again, to others. It changes no
/// branch's marks.
static void follow_again(Visited* visited, bool again) {
  if (again)
    memcpy(visited->before, visited->marked, sizeof visited->marked);
  else
    memcpy(visited->marked, visited->before, sizeof visited->marked);
  visited->again = again;
}

static void start_visits(Visited* visited, int branches, int passes, int steps) {
  const Budget budget = {passes, steps, {0, 0, 0}};
  visited->budget = budget;
  memset(visited->marked, 0, sizeof visited->marked);
  visited->branches = branches;
  visited->known.count = 0;
  visited->again = false;
}

/// True if a branch that is not settled is marked so.
static bool is_open(const Visited* visited, Mark mark) {
  for (int i = 0; i < visited->branches; ++i)
    if (visited->marked[mark][i] && !visited->marked[has_settled][i]) return true;
  return false;
}

/// Leaves those that share a solution at that.
static void settle_shared(Visited* visited) {
  for (int i = 0; i < visited->branches; ++i)
    visited->marked[has_settled][i] = visited->marked[has_settled][i] || visited->marked[has_shared][i];
}

static bool visit_is_settled(const Visited* visited, int label) {
  return visited->marked[has_settled][label] && !visited->again;
}

/// Takes back the last solution: a wrist cannot follow there.
static void reopen_visit(Visited* visited, int label, bool continuum) {
  visited->marked[has_settled][label] = false;
  visited->marked[has_missed][label] = true;
  if (continuum && !visited->marked[has_shared][label]) visited->marked[has_turned_back][label] = true;
  --visited->known.count;
}

static bool is_visited(Visited* visited, const PointMatching* task, const JointValues* values) {
  for (int k = 0; k < visited->known.count; ++k) {
    const JointValues* other = &visited->known.of[k];
    const double square = distance_square(task->joints, other, values);
    if (square < tolerance_same_rows * DBL_EPSILON) return true;
    if (square < tolerance_may_be_joined && points_are_joined(task, other, values, &visited->budget)) return true;
  }
  return false;
}

/// Polishes where a branch has led; true if that is a solution and a new one, to half the digits. On a
/// continuum the place is to be one that a pass has chosen, or the one next to the seed, if there is one.
static bool settle_visit(Visited* visited, int label, const PointMatching* task, const Boundary* boundary,
                         const JointValues* seed, JointValues* values, Branch* branch) {
  Budget* budget = &visited->budget;
  if (visited->again && (!branch->exists || is_known(&visited->known, task->joints, values))) return false;
  bool reached = branch->exists && polish_points(task, boundary->miss, values, budget, &nothing_held);
  const bool strays = branch->exists && !reached && is_nearly_continuum(task, values, budget);
  if (strays) reached = move_on(task, values, budget);
  visited->marked[has_strayed][label] = visited->marked[has_strayed][label] || strays;
  visited->marked[has_missed][label] = visited->marked[has_missed][label] || !reached;
  if (!reached) return false;
  bool* left = &visited->marked[is_left][label];
  if (is_continuum_of_points(task, values, budget)) {
    *left = !branch->continuum && !boundary->take;
    if (*left) return false;
    branch->continuum = true;
    JointValues at;
    if (seed != NULL) {
      at = *seed;
      if (polish_points(task, 0, &at, budget, &nothing_held) && !is_visited(visited, task, &at) &&
          is_continuum_of_points(task, &at, budget))
        *values = at;
    }
  }
  const bool known = is_visited(visited, task, values);
  // Near a continuum two branches may have been led to the one solution and left another; and so may a choice
  // lead.
  bool* shared = &visited->marked[has_shared][label];
  const bool astray = strays || *left || *shared;
  *shared = *shared || (known && !astray && !visited->marked[has_turned_back][label] &&
                        is_next_to_continuum(task, values, budget));
  visited->marked[has_settled][label] = !(known && (astray || *shared));
  if (known) return false;
  if (visited->known.count == visited->branches) {
    // A row is lost; but where branches are followed again each has a row of its own then.
    if (!visited->again) budget->spent.used_up = true;
    return false;
  }
  remember(&visited->known, values);
  return true;
}

/// A pose moved and turned a little, another way for every k: the fractional parts of multiples of square
/// roots of primes are spread evenly. Returns how far the joint whose value is given is to be held from that
/// value.
static double displaced(const Pose* pose, double size, int k, Pose* moved) {
  static const double roots[7] = {constant_root_of_2, constant_root_of_3, constant_root_of_5,
                                  constant_root_of_7, constant_root_of_11,    constant_root_of_13,
                                  constant_root_of_17};
  double by[7];
  for (int i = 0; i < 7; ++i) {
    const double multiple = (k + 1) * roots[i];
    by[i] = tolerance_nearby * (2 * (multiple - floor(multiple)) - 1);
  }
  const Quaternion turn = {{1, by[3], by[4], by[5]}};
  moved->orientation = unit_quaternion(turn_after(turn, pose->orientation));
  for (int i = 0; i < 3; ++i) moved->position[i] = pose->position[i] + size * by[i];
  return by[6];
}
