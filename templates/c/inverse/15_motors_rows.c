// Rows of joints as rows of motors: the representative nearest to a seed, one beside it, or all of them, one after the other.

/// Rows of joints as rows of motors. Returns how many there are.
static int rows_in_motors(Solutions* found) {
  double joints[dof];
  for (int k = 0; k < found->count; ++k) {
    memcpy(joints, found->rows[k].q, sizeof joints);
    motors_by(joints, found->rows[k].q);
  }
  return found->count;
}

/// Keeps of each row the representative whose motors are nearest to the seed, if it has one inside the limits; the nearest row
/// first.
static int keep_within_motors(Solutions* found, const double* seed, const double* lower, const double* upper) {
  WithinMotors within;
  double squares[capacity];
  bool is_cut = false;
  int kept = 0;
  set_within_motors(&within, lower, upper, seed);
  for (int k = 0; k < found->count; ++k) {
    Solution row = found->rows[k];
    double square = 0;
    if (!take_nearest_turn(&within, row.q, &square, &is_cut)) continue;
    squares[kept] = square;
    found->rows[kept++] = row;
  }
  const int status = is_cut ? status_incomplete : found->status;
  found->status = status;
  found->count = kept;
  sort_rows(found->rows, kept, squares);
  // A row inside the limits may be among those that an incomplete set lacks.
  if (status != status_invalid && status != status_incomplete) conclude_solutions(found);
  return kept;
}

/// Keeps a row that is within limits; neither another branch nor whole turns are looked for.
static int keep_near_within_motors(const double* lower, const double* upper, Solutions* found) {
  if (found->count == 0) return 0;
  WithinMotors within;
  set_within_motors(&within, lower, upper, found->rows[0].q);
  if (take_inside(&within, found->rows[0].q)) return 1;
  found->count = 0;
  found->status = status_unreachable;
  return 0;
}

/// Numbers of whole turns that bring a pivot inside: the nearest to the middle first, then alternately above and below.
static void start_turns(Turns* turns, const Values* from, int level, const TurnRange* range) {
  memcpy(turns->values, from->of, sizeof turns->values);
  turns->nearest = turns_from(range, from->of[level_begin(level)]);
  turns->away[0] = 0;
  turns->away[1] = 1;
  turns->is_over[0] = turns->is_over[1] = turns->has_one = 0;
}

/// Goes to the next number; false if there is none.
static bool next_turn(Turns* turns, int level, const TurnRange* range, double* number) {
  while (!(turns->is_over[0] != 0 && turns->is_over[1] != 0)) {
    const bool goes_down = turns->is_over[0] != 0 || (turns->is_over[1] == 0 && turns->away[1] < turns->away[0]);
    const int side = goes_down ? 1 : 0;
    const double next = turns->nearest + (goes_down ? -turns->away[1] : turns->away[0]);
    const bool is_over = !contains(range, turns->values[level_begin(level)] + next * range->step) ||
                         turns->away[side] > range->farthest;
    turns->is_over[side] = is_over ? 1 : 0;
    *number = next;
    if (is_over) continue;
    turns->away[side] += 1;
    return true;
  }
  return false;
}

static Values turned_values(const Turns* turns, int level, double number) {
  Values values;
  memcpy(values.of, turns->values, sizeof values.of);
  turn_values(level, number, &values);
  return values;
}

static void start_motor_representatives(const MotorRows* found, const double* lower, const double* upper,
                                        Representatives* all) {
  all->solutions = found;
  all->next_row = 0;
  memcpy(all->lower, lower, sizeof all->lower);
  memcpy(all->upper, upper, sizeof all->upper);
  all->level = -1;
}

static void open_level(WithinMotors* within, const Values* from, Representatives* all) {
  ++all->level;
  find_range(within, all->level);
  start_turns(&all->turns[all->level], from, all->level, &within->ranges[all->level]);
}

/// Goes to the next representative of a row; false if there is none.
static bool next_of_row(WithinMotors* within, Representatives* all) {
  double number = 0;
  while (all->level >= 0) {
    const int level = all->level;
    Turns* turns = &all->turns[level];
    find_range(within, level);
    if ((within->ranges[level].is_open && turns->has_one != 0) ||
        !next_turn(turns, level, &within->ranges[level], &number)) {
      --all->level;
      continue;
    }
    const Values values = turned_values(turns, level, number);
    if (!is_inside(within, level, &values)) continue;
    if (level + 1 < turn_count) {
      open_level(within, &values, all);
      continue;
    }
    take_motors(within, &values, all->row.q);
    for (int i = 0; i < bounded; ++i) all->turns[i].has_one = 1;
    return true;
  }
  return false;
}

/// Begins with a row that has a representative inside. Returns true if that stands in `row` already.
static bool begin_row(WithinMotors* within, Representatives* all) {
  const Values values = values_of(all->row.q);
  if (!is_inside(within, -1, &values)) return false;
  if (turn_count > 0) {
    open_level(within, &values, all);
    return next_of_row(within, all);
  }
  take_motors(within, &values, all->row.q);
  return true;
}

/// Goes through the turns of a row's joints, then to the next row that has a representative inside.
static bool next_motor_representative(Representatives* all) {
  const double zero[whole_dof] = {0};
  WithinMotors within;
  set_limits_of_values(&within, all->lower, all->upper, zero);
  if (next_of_row(&within, all)) return true;
  set_levels(&within);
  while (all->next_row < all->solutions->count) {
    double square = 0;
    bool is_cut = false;
    all->row = all->solutions->rows[all->next_row++];
    double nearest[whole_dof];
    memcpy(nearest, all->row.q, sizeof nearest);
    if (take_nearest_turn(&within, nearest, &square, &is_cut) && begin_row(&within, all)) return true;
  }
  return false;
}
