// Joints at the zero pose and the points that they carry, for Newton's steps; and the budget of those.

static inline double square_of(Rotor a) { return a.cosine * a.cosine + a.sine * a.sine; }

/// A difference of angles, rad, less the whole turns that bring it into [-pi, pi].
static inline double without_turns(double difference) {
  const double turn = constant_whole_turn;
  const double rounds = 1.5 / DBL_EPSILON;
  return difference - turn * ((difference * (1 / turn) + rounds) - rounds);
}

/// How often a pose may be worked at: counted, so that the bound holds by construction.
typedef struct Budget {
  int passes;
  int steps;
  Effort spent;
} Budget;

static bool take_of_budget(int* spent, int most, int* used_up) {
  if (*spent >= most) {
    *spent = most;
    *used_up = 1;
    return false;
  }
  *spent += 1;
  return true;
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

static const Held nothing_held = {{false}};

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
