// The row next to a seed: seed_branch.h of the C++ library.

/// One solution or none.
typedef struct Nearest {
  int status;
  int count;
  Effort effort;
  Row row;
} Nearest;

static void start_nearest(Nearest* found) {
  found->status = status_unreachable;
  found->count = 0;
  found->effort.passes = found->effort.steps = found->effort.used_up = 0;
  memset(&found->row, 0, sizeof found->row);
}

static void conclude_nearest(Nearest* found) {
  found->status = found->effort.used_up       ? status_incomplete
                  : found->count == 0         ? status_unreachable
                  : found->row.continuum != 0 ? status_singular
                                              : status_solved;
}

static inline void take_row(Nearest* found, const double* q, int branch, bool continuum) {
  found->count = 1;
  memcpy(found->row.q, q, sizeof found->row.q);
  found->row.branch = branch;
  found->row.continuum = continuum;
}

// Squared distances from the seed's values: of an angle that of the pairs, near zero its square.

static inline double turn_apart(double cosine, double sine, Rotor seed) {
  const double x = cosine - seed.cosine;
  const double y = sine - seed.sine;
  return x * x + y * y;
}

static inline double slide_apart(double slide, double seed) { return (slide - seed) * (slide - seed); }

static inline double wrist_apart(WristAngles angles, double first, double middle, double last) {
  const double x = without_turns(angles.first - first);
  const double y = without_turns(angles.middle - middle);
  const double z = without_turns(angles.last - last);
  return x * x + y * y + z * z;
}

/// Squared distance of a row; infinite if there is none.
static double nearest_apart(const Nearest* found, const Preference* seed) {
  if (found->count == 0) return HUGE_VAL;
  double sum = 0;
  for (int i = 0; i < row_size; ++i) {
    const double q = found->row.q[i];
    const double off = is_revolute[i] ? without_turns(q - seed->angle[i]) : q - seed->slide[i];
    sum += off * off;
  }
  return sum;
}

/// Takes the nearest of all rows.
static void take_nearest_row(const Rows* all, const Preference* seed, Nearest* found) {
  double from[row_size], turn[row_size], per_turn[row_size], off[row_size];
  double least = HUGE_VAL;
  int nearest = 0;
  for (int i = 0; i < row_size; ++i) {
    from[i] = is_revolute[i] ? seed->angle[i] : seed->slide[i];
    turn[i] = is_revolute[i] ? constant_whole_turn : 0;
    per_turn[i] = is_revolute[i] ? 1 / constant_whole_turn : 0;
  }
  for (int k = 0; k < all->count; ++k) {
    for (int i = 0; i < row_size; ++i) {
      const double way = all->rows[k].q[i] - from[i];
      off[i] = way - turn[i] * nearest_whole(way * per_turn[i]);
    }
    const double square = sum_of_squares(off, row_size);
    if (!(square < least)) continue;
    least = square;
    nearest = k;
  }
  found->count = all->count > 0 ? 1 : 0;
  if (all->count > 0) found->row = all->rows[nearest];
}

/// The choices between two solutions of an equation on the way along a branch.
typedef struct Forks {
  unsigned flipped;  // bit i: at the i-th the farther one is taken
  int count;
  double left[6];  // squared distance from the seed of what was not taken, infinite if it is nothing
  int label;
  bool may_stop, has_stopped;  // at what is not next to the seed
  double apart;                // squared distance from the seed of what was taken last
} Forks;

static const Forks no_forks = {0, 0, {0}, 0, false, false, 0};

/// True if two solutions meet, but for rounding: both in doubt, and as far from the seed to half the digits.
static bool are_one(const Branch* other, double other_apart, const Branch* branch, double apart) {
  const double difference = other_apart - apart;
  return other->unsure && branch->unsure && difference * difference <= tolerance_forks_meet * apart;
}

/// True if the other of two solutions is to be taken.
static bool takes_other(Forks* forks, const Branch* other, double other_apart, const Branch* branch,
                        double apart) {
  const bool is_nearer = other->exists && (!branch->exists || other_apart < apart);
  const bool is_other = is_nearer != ((forks->flipped >> forks->count & 1U) != 0);
  const bool has_rest =
      (is_other ? branch->exists : other->exists) && !are_one(other, other_apart, branch, apart);
  forks->left[forks->count++] = has_rest ? (is_other ? apart : other_apart) : HUGE_VAL;
  forks->label = 2 * forks->label + (is_other ? 1 : 0);
  forks->apart = is_other ? other_apart : apart;
  return is_other;
}

/// Leaves a way that leads to no row next to the seed, if it may stop.
static inline void leave_if_far(Forks* forks, Branch* branch) {
  if (!forks->may_stop || forks->apart < tolerance_by_seed) return;
  forks->has_stopped = true;
  branch->exists = false;
}

/// The forks at which another choice may lead nearer to the seed, a bit each.
static unsigned open_forks(const Forks* forks, double least) {
  unsigned open = 0;
  for (int i = 0; i < forks->count; ++i)
    if (forks->left[i] < 400 * least) open |= 1U << i;
  return open;
}

/// True if a row of the equations alone, which leave free joints where the seed has them, is so near to the seed that
/// no other needs to be asked for: 10 mrad.
static bool is_by_seed(const Nearest* found, const Preference* seed) {
  return nearest_apart(found, seed) < tolerance_by_seed;
}

/// True if a row that Newton's steps have found is so near to the seed that no other is needed. The steps may have
/// moved it along a continuum, on which it has to be within 2 mrad.
static bool is_next_to(const Nearest* found, const Preference* seed) {
  return is_by_seed(found, seed) && (!found->row.continuum || nearest_apart(found, seed) < tolerance_by_seed_on_continuum);
}

/// Keeps the row that is nearer to the seed, and counts what both have cost.
static void take_nearer(const Nearest* row, const Preference* seed, Nearest* found) {
  Effort effort;
  effort.passes = found->effort.passes + row->effort.passes;
  effort.steps = found->effort.steps + row->effort.steps;
  effort.used_up = 0;
  if (nearest_apart(row, seed) < nearest_apart(found, seed)) *found = *row;
  found->effort = effort;
}

static Row row_of(const Solution* own) {
  Row row;
  memset(row.q, 0, sizeof row.q);
  memcpy(row.q, own->q, dof * sizeof *own->q);
  row.branch = own->branch;
  row.continuum = own->continuum;
  return row;
}

static Solution own_solution(const Row* row) {
  Solution own;
  memset(own.q, 0, sizeof own.q);
  memcpy(own.q, row->q, dof * sizeof *own.q);
  own.branch = row->branch;
  own.continuum = row->continuum;
  return own;
}

/// The first of all solutions, which stand by their distance from the seed, or why there is none.
static void take_nearest(const Solutions* all, Nearest* found) {
  found->effort.passes += all->effort.passes;
  found->effort.steps += all->effort.steps;
  found->effort.used_up = all->count == 0 && all->effort.used_up;
  found->count = all->count > 0 ? 1 : 0;
  if (all->count > 0) found->row = row_of(&all->rows[0]);
  conclude_nearest(found);
  if (all->count == 0) found->status = all->status;
}

/// Whole turns added until each angle is within half a turn of the seed's.
static void unwind(Nearest* found, const double* seed) {
  for (int i = 0; i < dof; ++i)
    if (found->count > 0 && is_revolute[i])
      found->row.q[i] = seed[i] + without_turns(found->row.q[i] - seed[i]);
}

static int as_solutions(const Nearest* nearest, Solutions* found) {
  found->status = nearest->status;
  found->effort = nearest->effort;
  found->count = nearest->count;
  if (nearest->count > 0) found->rows[0] = own_solution(&nearest->row);
  return found->count;
}

/// Puts a solution that is outside limits by rounding on them, and drops one that is outside by more.
static int keep_near_within(int joints, const double* lower, const double* upper, Solutions* found) {
  for (int i = 0; found->count > 0 && i < joints; ++i) {
    double* q = &found->rows[0].q[i];
    const double inside = between(lower[i], *q, upper[i]);
    if (!(lower[i] <= upper[i] && fabs(inside - *q) <= limit_tolerance)) {
      found->count = 0;
      found->status = status_unreachable;
    }
    *q = inside;
  }
  return found->count;
}
