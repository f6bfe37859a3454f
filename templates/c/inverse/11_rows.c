// Rows, their order, and their representatives within limits.

/// Preferred value of each joint, taken if a pose leaves it free: zero or the caller's.
typedef struct Preference {
  double angle[row_size];
  double slide[row_size];
  Rotor turn[row_size];
  Rotor brief[row_size];  // the same as short as `span` wants them
  Rotor spread;           // (1, 0): slides are where they are preferred; turned: elsewhere in reach
  bool seeded;            // the caller's
} Preference;

static inline void choose_turn(Preference* preference, int joint, Rotor turn) {
  preference->turn[joint] = turn;
  preference->brief[joint] = scaled(brief_length, turn);
}

static void prefer_zero(Preference* preference) {
  for (int i = 0; i < row_size; ++i) {
    preference->angle[i] = preference->slide[i] = 0;
    choose_turn(preference, i, rotor(1, 0));
  }
  preference->spread = rotor(1, 0);
  preference->seeded = false;
}

/// Preference with zero for virtual joints, which come behind the arm's own.
static void prefer_seed(const double* seed, Preference* preference) {
  if (row_size > dof) prefer_zero(preference);
  preference->spread = rotor(1, 0);
  preference->seeded = true;
  for (int i = 0; i < dof; ++i) {
    preference->angle[i] = without_turns(seed[i]);
    preference->slide[i] = seed[i];
    choose_turn(preference, i, rotor(cos(seed[i]), sin(seed[i])));
  }
}

/// Every preferred angle further by one angle, slides elsewhere in reach.
static void choose_further(Preference* preference, Rotor turn, Rotor spread) {
  for (int i = 0; i < row_size; ++i) {
    choose_turn(preference, i, product(turn, preference->turn[i]));
    preference->angle[i] = angle_of(preference->turn[i]);
  }
  preference->spread = product(spread, preference->spread);
}

/// By the golden angle, which spreads any number of them evenly.
static void next_choice(Preference* preference) {
  choose_further(preference, rotor(constant_golden_cosine, constant_golden_sine),
                 rotor(constant_half_golden_cosine, constant_half_golden_sine));
}

/// By a 16th of a turn.
static void next_choice_of_quartic(Preference* preference) {
  choose_further(preference, rotor(constant_sixteenth_cosine, constant_sixteenth_sine),
                 rotor(constant_half_sixteenth_cosine, constant_half_sixteenth_sine));
}

/// An angle in (-pi, pi] less a phase in the same range, brought back into it.
static double less_phase(double angle, double phase) {
  const double less = angle - phase;
  if (less > pi) return less - 2 * pi;
  return less <= -pi ? less + 2 * pi : less;
}

/// Rows in the derivation's angles become rows in the description's. Slides have no phase.
static void subtract_phases(Row* rows, int count, const double* phases) {
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < row_size; ++i)
      if (phases[i] != 0) rows[k].q[i] = less_phase(rows[k].q[i], phases[i]);
}

/// Preferred values of free joints, in the derivation's angles.
static void add_phases(Preference* preference, const double* phases) {
  for (int i = 0; i < row_size; ++i) {
    if (phases[i] == 0) continue;
    preference->angle[i] += phases[i];
    choose_turn(preference, i, product(rotor(cos(phases[i]), sin(phases[i])), preference->turn[i]));
  }
}

static void start_rows(Rows* found) {
  found->status = status_unreachable;
  found->count = 0;
  found->effort.passes = found->effort.steps = found->effort.used_up = 0;
}

static void start_solutions(Solutions* found) {
  found->status = status_unreachable;
  found->count = 0;
  found->effort.passes = found->effort.steps = found->effort.used_up = 0;
  for (int i = 0; i < capacity; ++i) found->rows[i].branch = found->rows[i].continuum = 0;
}

static inline void append(Rows* found, const double* q, int branch, bool continuum) {
  if (found->count >= capacity) return;  // never so: a branch has one row
  Row* row = &found->rows[found->count++];
  memcpy(row->q, q, sizeof row->q);
  row->branch = branch;
  row->continuum = continuum;
}

/// True if a row stands for a continuum.
static bool has_continuum(const Rows* found) {
  for (int i = 0; i < found->count; ++i)
    if (found->rows[i].continuum) return true;
  return false;
}

/// From the rows that were found.
static void conclude(Rows* found) {
  found->status = found->effort.used_up  ? status_incomplete
                  : found->count == 0    ? status_unreachable
                  : has_continuum(found) ? status_singular
                                         : status_solved;
}

static bool is_branch_of_any(const Row* rows, int count, int branch) {
  for (int i = 0; i < count; ++i)
    if (rows[i].branch == branch) return true;
  return false;
}

/// Gives rows whose branch an earlier row has, too, the first number that no row has.
static void number_apart(Rows* found) {
  for (int k = 1; k < found->count; ++k) {
    if (!is_branch_of_any(found->rows, k, found->rows[k].branch)) continue;
    int branch = 0;
    while (branch < found->count && is_branch_of_any(found->rows, found->count, branch)) ++branch;
    found->rows[k].branch = branch;
  }
}

static void conclude_solutions(Solutions* found) {
  bool marked = false;
  for (int i = 0; i < found->count; ++i) marked = marked || found->rows[i].continuum;
  found->status = found->effort.used_up ? status_incomplete
                  : found->count == 0   ? status_unreachable
                  : marked              ? status_singular
                                        : status_solved;
}

/// Back into the order of branches, for rows that two passes have found.
static void sort_by_branch(Row* rows, int count) {
  for (int i = 1; i < count; ++i) {
    const Row row = rows[i];
    int at = i;
    for (; at > 0 && row.branch < rows[at - 1].branch; --at) rows[at] = rows[at - 1];
    rows[at] = row;
  }
}

/// Puts rows in the order of their squared distances from a seed; equal ones keep their order. Places are sorted, and each row
/// then moves once.
static void sort_rows(Solution* rows, int count, double* squares) {
  int from[capacity];
  for (int i = 0; i < count; ++i) {
    const double own = squares[i];
    int at = i;
    for (; at > 0 && own < squares[at - 1]; --at) {
      squares[at] = squares[at - 1];
      from[at] = from[at - 1];
    }
    squares[at] = own;
    from[at] = i;
  }
  for (int i = 0; i < count; ++i) {
    if (from[i] == i) continue;
    const Solution row = rows[i];
    int at = i;
    while (from[at] != i) {
      const int next = from[at];
      rows[at] = rows[next];
      from[at] = at;
      at = next;
    }
    rows[at] = row;
    from[at] = at;
  }
}

/// Sum of squares, in the order in which C++ adds them.
static inline double sum_of_squares(const double* numbers, int count) {
  double sums[4] = {0, 0, 0, 0};
  int i = 0;
  for (; i + 3 < count; i += 4) {
    sums[0] += numbers[i] * numbers[i];
    sums[1] += numbers[i + 1] * numbers[i + 1];
    sums[2] += numbers[i + 2] * numbers[i + 2];
    sums[3] += numbers[i + 3] * numbers[i + 3];
  }
  for (int k = 0; i + k < count; ++k) sums[k] += numbers[i + k] * numbers[i + k];
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

/// Revolute joints the short way round.
static void sort_by_distance(Solutions* found, const double* seed) {
  double squares[capacity];
  for (int k = 0; k < found->count; ++k) {
    double off[dof];
    for (int i = 0; i < dof; ++i) {
      const double way = seed[i] - found->rows[k].q[i];
      off[i] = is_revolute[i] ? without_turns(way) : way;
    }
    squares[k] = sum_of_squares(off, dof);
  }
  sort_rows(found->rows, found->count, squares);
}

static inline double between(double lower, double value, double upper) {
  const double raised = value > lower ? value : lower;
  return raised < upper ? raised : upper;
}

/// Limits of all joints, as far as they are the same for every row.
typedef struct Within {
  double middle[whole_dof];    // of a turn: the angle inside is next to it
  double turn[whole_dof];      // a whole turn, of a slide 0
  double per_turn[whole_dof];  // its inverse, or 0
  bool admits;                 // false: some joint has no value inside
} Within;

/// The middle of a turn's limits, or, where these are wide, the seed, half a turn away from them.
static Within within_limits_near(const double* seed, const double* lower, const double* upper) {
  const double far = tolerance_farthest_joint;
  const double half = 0.5 * constant_whole_turn - limit_tolerance;
  Within within;
  within.admits = true;
  for (int i = 0; i < whole_dof; ++i) {
    const double least = lower[i] + half, most = upper[i] - half;
    within.middle[i] = least < most ? between(least, seed[i], most) : 0.5 * (lower[i] + upper[i]);
    within.turn[i] = whole_is_revolute[i] ? constant_whole_turn : 0;
    within.per_turn[i] = whole_is_revolute[i] ? 1 / constant_whole_turn : 0;
    within.admits = within.admits && lower[i] <= upper[i] && lower[i] < far && upper[i] > -far;
    // 0 times what is not finite would not be 0.
    if (!whole_is_revolute[i]) within.middle[i] = 0;
  }
  return within;
}

/// Takes from each angle q the angle q + 2 pi k that is inside the limits and nearest to the seed; false if a joint has none.
/// A slide has itself.
static inline bool row_within(const Within* within, const double* lower, const double* upper, const double* q, double* inside) {
  double value[whole_dof];
  for (int i = 0; i < whole_dof; ++i)
    value[i] = q[i] + within->turn[i] * nearest_whole((within->middle[i] - q[i]) * within->per_turn[i]);
  for (int i = 0; i < whole_dof; ++i) {
    inside[i] = between(lower[i], value[i], upper[i]);
    if (!(fabs(inside[i] - value[i]) <= limit_tolerance)) return false;
  }
  return within->admits;
}

/// True if the pose leaves a joint free, or nearly: other places of the continuum may be inside limits that a row exceeds.
static bool stands_for_others(const Solutions* found) {
  bool marked = false;
  for (int i = 0; i < found->count; ++i) marked = marked || found->rows[i].continuum;
  return found->count > 0 && (marked || found->effort.passes > 0);
}

/// Keeps of each row the representative nearest to the seed, if it has one inside the limits; the nearest row
/// first. Without a row the set is incomplete if a free joint may have values inside that have not been looked for.
static void keep_within_limits(Solutions* found, bool has_looked, const double* seed, const double* lower,
                               const double* upper) {
  const Within within = within_limits_near(seed, lower, upper);
  double squares[capacity];
  int kept = 0;
  for (int k = 0; k < found->count; ++k) {
    double inside[whole_dof], off[whole_dof];
    if (!row_within(&within, lower, upper, found->rows[k].q, inside)) continue;
    for (int i = 0; i < whole_dof; ++i) off[i] = inside[i] - seed[i];
    squares[kept] = sum_of_squares(off, whole_dof);
    memcpy(found->rows[kept].q, inside, sizeof inside);
    found->rows[kept].branch = found->rows[k].branch;
    found->rows[kept].continuum = found->rows[k].continuum;
    ++kept;
  }
  const int status = found->status;
  if (kept == 0 && !has_looked && stands_for_others(found)) found->effort.used_up = 1;
  found->count = kept;
  sort_rows(found->rows, kept, squares);
  // A row inside the limits may be among those that an incomplete set lacks.
  if (status != status_invalid && status != status_incomplete) conclude_solutions(found);
}

/// Counts the whole turns that a joint inside its limits may go further down and up; none if it has not two finite
/// limits.
static void count_turns(int joint, double q, double lower, double upper, int* below, int* above) {
  const double turn = constant_whole_turn;
  const double most = tolerance_most_turns;
  *below = *above = 0;
  if (!whole_is_revolute[joint] || !(upper - lower >= turn - 2 * limit_tolerance && upper - lower < HUGE_VAL)) return;
  const double low = lower - limit_tolerance, high = upper + limit_tolerance;
  double down = nearest_whole((q - low) * (1 / turn));
  double up = nearest_whole((high - q) * (1 / turn));
  if (down > most) down = most;
  if (up > most) up = most;
  // The next whole number may be one too far: the angle decides.
  if (down > 0 && q - turn * down < low) down -= 1;
  if (up > 0 && q + turn * up > high) up -= 1;
  *below = (int)down;
  *above = (int)up;
}

/// Returns a joint's representative with that number: its own angle, then alternately above and below for as long as there
/// are both.
static double numbered_turn(double own, int below, int above, int number, double lower, double upper) {
  const double turn = constant_whole_turn;
  const int fewer = below < above ? below : above;
  int turns = number % 2 == 1 ? (number + 1) / 2 : -number / 2;
  if (number > 2 * fewer) turns = above > below ? number - fewer : fewer - number;
  return between(lower, own + turn * (double)turns, upper);
}

static void start_representatives(const Solutions* found, const double* lower, const double* upper, Representatives* all) {
  all->solutions = found;
  all->next_row = 0;
  memcpy(all->lower, lower, sizeof all->lower);
  memcpy(all->upper, upper, sizeof all->upper);
  for (int i = 0; i < whole_dof; ++i) all->below[i] = all->above[i] = all->number[i] = 0;
}

/// Goes to the next row that has a representative inside, and to that which is nearest to zero.
static bool next_row_inside(Representatives* all) {
  const double zero[whole_dof] = {0};
  const Within within = within_limits_near(zero, all->lower, all->upper);
  while (all->next_row < all->solutions->count) {
    all->row = all->solutions->rows[all->next_row++];
    if (!row_within(&within, all->lower, all->upper, all->row.q, all->own)) continue;
    memcpy(all->row.q, all->own, sizeof all->own);
    for (int i = 0; i < whole_dof; ++i)
      count_turns(i, all->own[i], all->lower[i], all->upper[i], &all->below[i], &all->above[i]);
    return true;
  }
  // Behind the last one there is none, however often it is asked for.
  for (int i = 0; i < whole_dof; ++i) all->below[i] = all->above[i] = 0;
  return false;
}

/// Counts through the turns of all joints like an odometer, then goes to the next row.
static bool next_representative(Representatives* all) {
  for (int i = 0; i < whole_dof; ++i) {
    const bool is_more = ++all->number[i] <= all->below[i] + all->above[i];
    if (!is_more) all->number[i] = 0;
    if (is_more || all->below[i] + all->above[i] > 0)
      all->row.q[i] = numbered_turn(all->own[i], all->below[i], all->above[i], all->number[i], all->lower[i], all->upper[i]);
    if (is_more) return true;
  }
  return next_row_inside(all);
}

/// The arm's own joints of rows that virtual ones stand behind.
static void own_joints(const Rows* rows, Solutions* found) {
  found->status = rows->status;
  found->effort = rows->effort;
  found->count = rows->count;
  for (int k = 0; k < rows->count; ++k) {
    memcpy(found->rows[k].q, rows->rows[k].q, dof * sizeof *found->rows[k].q);
    found->rows[k].branch = rows->rows[k].branch;
    found->rows[k].continuum = rows->rows[k].continuum;
  }
}

/// Preference by a seed of which one joint's value is given.
static void prefer_seed_with(const double* seed, int joint, double value, Preference* preference) {
  double q[dof];
  memcpy(q, seed, sizeof q);
  q[joint] = value;
  prefer_seed(q, preference);
}
