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
  set_limits_of_values(&within, lower, upper, found->rows[0].q);
  if (take_inside(&within, found->rows[0].q)) return 1;
  found->count = 0;
  found->status = status_unreachable;
  return 0;
}

/// Sets the values that a level moves: it settles those from its pivot to `end`, the others of its block go on to the next
/// level. Sets what a turn moves the pivot by, and the pivot's limits.
static void set_turns(const WithinMotors* within, int level, Turns* turns) {
  const TurnRange* range = &within->ranges[level];
  turns->pivot = level_begin(level);
  turns->end = level_begin(level + 1);
  turns->block_end = level_begin(last_of_block(level) + 1);
  turns->step = range->step;
  turns->least = range->lower - limit_tolerance;
  turns->most = range->upper + limit_tolerance;
  turns->middle = range->middle;
  turns->farthest = range->farthest;
  turns->is_open = range->is_open ? 1 : 0;
}

/// Numbers of whole turns that bring a pivot inside: the nearest to the middle first, then alternately above and below.
static void start_turns(Turns* turns) {
  turns->nearest = nearest_whole((turns->middle - turns->values[turns->pivot]) * (1 / turns->step));
  turns->away[0] = 0;
  turns->away[1] = 1;
  turns->is_over[0] = turns->is_over[1] = turns->has_one = 0;
}

/// Goes to the next number; false if there is none. A level without end has one at most.
static bool next_turn(Turns* turns, double* number) {
  if (turns->is_open != 0 && turns->has_one != 0) return false;
  while (turns->is_over[0] == 0 || turns->is_over[1] == 0) {
    const double up = turns->away[0], down = turns->away[1];
    const bool goes_down = turns->is_over[0] != 0 || (turns->is_over[1] == 0 && down < up);
    const double away = goes_down ? down : up, next = turns->nearest + (goes_down ? -down : up);
    const double value = turns->values[turns->pivot] + next * turns->step;
    if (value >= turns->least && value <= turns->most && away <= turns->farthest) {
      turns->away[goes_down ? 1 : 0] = away + 1;
      *number = next;
      return true;
    }
    turns->is_over[goes_down ? 1 : 0] = 1;
  }
  return false;
}

/// Puts a motor's value that is inside into the row: on its limit where rounding has moved it outside.
static inline void put_value(int i, double value, Representatives* all) {
  if (motor_of[i] >= 0) all->row.q[motor_of[i]] = smaller(larger(value, all->lower[i]), all->upper[i]);
}

/// Turns by a number, and puts the values that the level settles into the row. The others of its block go on to the next
/// level. Returns false if a value is outside.
static bool put_turned(int level, double number, Representatives* all) {
  const Turns* turns = &all->turns[level];
  put_value(turns->pivot, turns->values[turns->pivot] + number * turns->step, all);
  for (int i = turns->pivot + 1; i < turns->end; ++i) {
    const double value = turns->values[i] + number * motion_of(level, i);
    if (!is_between(all->lower[i], value, all->upper[i])) return false;
    put_value(i, value, all);
  }
  for (int i = turns->end; i < turns->block_end; ++i)
    all->turns[level + 1].values[i] = turns->values[i] + number * motion_of(level, i);
  return true;
}

/// Prepares the search in all rows, and finds those that have a representative inside.
static void start_motor_representatives(const MotorRows* found, const double* lower, const double* upper,
                                        Representatives* all) {
  const double zero[whole_dof] = {0};
  WithinMotors within;
  set_within_motors(&within, lower, upper, zero);
  memcpy(all->lower, within.lower.of, sizeof all->lower);
  memcpy(all->upper, within.upper.of, sizeof all->upper);
  for (int level = 0; level < turn_count; ++level) set_turns(&within, level, &all->turns[level]);
  for (int k = 0; k < found->count; ++k) {
    double nearest[whole_dof], square = 0;
    bool is_cut = false;
    memcpy(nearest, found->rows[k].q, sizeof nearest);
    all->has_one[k] = take_nearest_turn(&within, nearest, &square, &is_cut) ? 1 : 0;
  }
  all->solutions = found;
  all->next_row = 0;
  all->place = -1;
}

/// Settles a level that moves one value alone and has exactly one number. Returns false of any other level.
static bool settle_only(int level, Representatives* all) {
  double number = 0, other = 0;
  if (!is_alone(level) || !next_turn(&all->turns[level], &number)) return false;
  return !next_turn(&all->turns[level], &other) && put_turned(level, number, all);
}

/// Goes to the next representative of a row; false if there is none.
static bool next_of_row(Representatives* all) {
  double number = 0;
  while (all->place >= 0) {
    const int level = all->levels[all->place];
    if (!next_turn(&all->turns[level], &number)) {
      --all->place;
      continue;
    }
    if (!put_turned(level, number, all)) continue;
    if (all->place + 1 < all->level_count) {
      ++all->place;
      start_turns(&all->turns[all->levels[all->place]]);
      continue;
    }
    for (int i = 0; i < all->level_count; ++i) all->turns[all->levels[i]].has_one = 1;
    return true;
  }
  return false;
}

/// Begins with a row that has a representative inside. Levels with one number are settled for the whole row. Returns true
/// if a representative stands in `row`.
static bool begin_row(Representatives* all) {
  const Values values = values_of(all->row.q);
  for (int i = 0; i < level_begin(0); ++i) {
    if (!is_between(all->lower[i], values.of[i], all->upper[i])) return false;
    put_value(i, values.of[i], all);
  }
  all->level_count = 0;
  for (int level = 0; level < turn_count; ++level) {
    memcpy(all->turns[level].values, values.of, sizeof values.of);
    start_turns(&all->turns[level]);
    if (!settle_only(level, all)) all->levels[all->level_count++] = level;
  }
  if (all->level_count == 0) return true;
  all->place = 0;
  start_turns(&all->turns[all->levels[0]]);
  return next_of_row(all);
}

/// Goes through the turns of a row's joints, then to the next row that has a representative inside.
static bool next_motor_representative(Representatives* all) {
  if (next_of_row(all)) return true;
  while (all->next_row < all->solutions->count) {
    const int k = all->next_row++;
    if (all->has_one[k] == 0) continue;
    all->row = all->solutions->rows[k];
    if (begin_row(all)) return true;
  }
  return false;
}
