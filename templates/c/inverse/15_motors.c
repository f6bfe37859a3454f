// Whole turns that bring motors inside their limits. joints = A motors, exactly, and a whole turn of a joint moves several
// motors: motors.h and motor_turns.h of the C++ library say how representatives are found. The robot's tables, `motor_of` to
// `turn_motion`, and `values_of` stand in front of all.

/// Limits of values, and those that one motion moves alone, ready to be brought next to their centres.
typedef struct WithinMotors {
  Values lower, upper, centre, per_motion;
  double square_of_motion[bounded], per_square[bounded];
  TurnRange ranges[bounded];
  Values alone_lower, alone_upper, alone_step, alone_per_step, alone_middle;
  int settled[bounded], settled_count;  // values that stay or are moved alone
  int joined[bounded], joined_count;    // levels that are not alone
} WithinMotors;

/// The first value that is settled by a level; those before the first pivot are by level -1.
static inline int level_begin(int level) { return level < 0 ? 0 : turn_pivot[level]; }

static inline double motion_of(int level, int value) { return turn_motion[level * bounded + value]; }

/// True if a motion moves its pivot alone, and no other one does.
static bool is_alone(int level) {
  return turn_ends_block[level] && level_begin(level + 1) - level_begin(level) == 1 &&
         (level == 0 || turn_ends_block[level - 1]);
}

static inline bool is_between(double lower, double value, double upper) {
  return value >= lower - limit_tolerance && value <= upper + limit_tolerance;
}

/// Limits that are not a range admit nothing: no value is between these.
static void set_value_limits(WithinMotors* within, int place, double lower, double upper) {
  const bool is_range = lower <= upper && lower < tolerance_farthest_joint && upper > -tolerance_farthest_joint;
  within->lower.of[place] = is_range ? lower : tolerance_farthest_joint;
  within->upper.of[place] = is_range ? upper : -tolerance_farthest_joint;
}

/// Sets the bounds of what a level moves, alone or with others.
static void set_level(WithinMotors* within, int level) {
  const int pivot = level_begin(level);
  const TurnRange range = turn_range(motion_of(level, pivot), within->lower.of[pivot], within->upper.of[pivot],
                                     within->centre.of[pivot]);
  within->ranges[level] = range;
  if (is_alone(level)) {
    within->settled[within->settled_count++] = pivot;
    within->alone_lower.of[pivot] = range.lower - limit_tolerance;
    within->alone_upper.of[pivot] = range.upper + limit_tolerance;
    within->alone_step.of[pivot] = range.step;
    within->alone_per_step.of[pivot] = range.per_step;
    within->alone_middle.of[pivot] = range.middle;
    return;
  }
  within->joined[within->joined_count++] = level;
  double square = 0;
  for (int i = pivot; i < level_begin(level + 1); ++i) {
    const double motion = motion_of(level, i);
    within->per_motion.of[i] = motion != 0 ? 1 / motion : 0;
    if (motor_of[i] >= 0) square += motion * motion;
  }
  within->square_of_motion[level] = square;
  within->per_square[level] = square != 0 ? 1 / square : 0;
}

/// Sets limits of values and a centre alone. A centre beyond which whole turns are lost in rounding is none, nor is what is
/// no number.
static void set_limits_of_values(WithinMotors* within, const double* lower, const double* upper, const double* centre) {
  double sensible[whole_dof];
  for (int i = 0; i < whole_dof; ++i) sensible[i] = fabs(centre[i]) < tolerance_lost_centre ? centre[i] : 0;
  within->centre = values_of(sensible);
  for (int i = 0; i < bounded; ++i) {
    const int motor = motor_of[i];
    set_value_limits(within, i, motor >= 0 ? lower[motor] : own_lower[i], motor >= 0 ? upper[motor] : own_upper[i]);
  }
}

/// Makes the search for turns ready, by limits of values.
static void set_levels(WithinMotors* within) {
  memset(within->per_motion.of, 0, sizeof within->per_motion.of);
  memset(within->square_of_motion, 0, sizeof within->square_of_motion);
  memset(within->per_square, 0, sizeof within->per_square);
  for (int i = 0; i < level_begin(0); ++i) {
    within->settled[i] = i;
    within->alone_lower.of[i] = within->lower.of[i] - limit_tolerance;
    within->alone_upper.of[i] = within->upper.of[i] + limit_tolerance;
    within->alone_step.of[i] = within->alone_per_step.of[i] = within->alone_middle.of[i] = 0;
  }
  within->settled_count = level_begin(0);
  within->joined_count = 0;
  for (int level = 0; level < turn_count; ++level) set_level(within, level);
}

/// Sets limits of motors next to a centre, and makes the search ready.
static void set_within_motors(WithinMotors* within, const double* lower, const double* upper, const double* centre) {
  set_limits_of_values(within, lower, upper, centre);
  set_levels(within);
}

static void turn_values(int level, double number, Values* values) {
  for (int i = level_begin(level); i < bounded; ++i) values->of[i] += number * motion_of(level, i);
}

/// True if the values that no later motion moves, behind those of the level before, are inside.
static bool is_inside(const WithinMotors* within, int level, const Values* values) {
  for (int i = level_begin(level); i < level_begin(level + 1); ++i)
    if (!is_between(within->lower.of[i], values->of[i], within->upper.of[i])) return false;
  return true;
}

/// Motors of values that are inside: on their limits where rounding has moved them outside.
static void take_motors(const WithinMotors* within, const Values* values, double* motors) {
  for (int i = 0; i < bounded; ++i)
    if (motor_of[i] >= 0)
      motors[motor_of[i]] = smaller(larger(values->of[i], within->lower.of[i]), within->upper.of[i]);
}

/// True if motors, which are then put on their limits, and joints with limits are inside.
static bool take_inside(const WithinMotors* within, double* motors) {
  const Values values = values_of(motors);
  for (int level = -1; level < turn_count; ++level)
    if (!is_inside(within, level, &values)) return false;
  take_motors(within, &values, motors);
  return true;
}

/// Share of a level's motors in the square of the distance from the centre.
static double part_of_square(const WithinMotors* within, int level, const Values* values) {
  double sum = 0;
  for (int i = level_begin(level); i < level_begin(level + 1); ++i) {
    const double off = values->of[i] - within->centre.of[i];
    if (motor_of[i] >= 0) sum += off * off;
  }
  return sum;
}

/// Values of a level move along a line, on which limits leave a piece and the distance has one least value.
static TurnPiece turn_piece(const WithinMotors* within, int level, const Values* values) {
  TurnPiece piece = new_turn_piece;
  double wanted = 0;
  for (int i = level_begin(level); i < level_begin(level + 1); ++i) {
    const double per_motion = within->per_motion.of[i], value = values->of[i];
    if (per_motion != 0)
      cut_line(&piece, within->lower.of[i] - limit_tolerance - value, within->upper.of[i] + limit_tolerance - value,
               per_motion);
    else
      piece.inside = piece.inside && is_between(within->lower.of[i], value, within->upper.of[i]);
    if (motor_of[i] >= 0) wanted += motion_of(level, i) * (within->centre.of[i] - value);
  }
  piece.nearest = wanted * within->per_square[level];
  keep_whole_numbers(&piece);
  return piece;
}

/// Settles the last level of a block: no number is tried. Returns false if nothing is inside.
static bool settle_last(const WithinMotors* within, int level, Values* values) {
  const TurnPiece piece = turn_piece(within, level, values);
  turn_values(level, nearest_inside(piece), values);
  return piece.inside;
}

/// The last level of a level's block.
static int last_of_block(int level) {
  while (!turn_ends_block[level]) ++level;
  return level;
}

/// A level of a block that is searched. `square`: that of the distance of the levels before; `least_square`: with the
/// least one of this level.
typedef struct SearchedLevel {
  Values from;
  Outwards tried;
  double square, least_square;
  bool is_open;
} SearchedLevel;

static SearchedLevel searched_level(const WithinMotors* within, int level, const Values* from, double square) {
  const TurnPiece piece = turn_piece(within, level, from);
  SearchedLevel searched;
  searched.from = *from;
  searched.square = searched.least_square = square;
  searched.is_open = piece.inside;
  start_outwards(&searched.tried, piece);
  return searched;
}

/// Turns by the number that is tried, and sets the square of the distance with this level.
static Values turned_by_number(const WithinMotors* within, int level, SearchedLevel* searched, double* reached) {
  Values at = searched->from;
  turn_values(level, searched->tried.number, &at);
  *reached = searched->square + part_of_square(within, level, &at);
  searched->least_square = *reached - square_beyond_least(searched->tried, within->square_of_motion[level]);
  return at;
}

/// Goes to the next number. What lies beyond one with which this level alone is as far as the best is farther still.
static void go_outwards(const WithinMotors* within, int level, double best, SearchedLevel* searched) {
  const bool is_inside = next_outwards(&searched->tried);
  const double beyond = square_beyond_least(searched->tried, within->square_of_motion[level]);
  searched->is_open = is_inside && may_be_best(searched->least_square + beyond, best);
}

/// Searches a block from a level on for its values nearest to the centre. The most numbers that are tried are 4096; `is_cut`
/// is set if these have led to nothing.
static bool search_block(const WithinMotors* within, int first, Values* values, bool* is_cut) {
  const int last = last_of_block(first), most_tries = 4096;
  SearchedLevel levels[bounded];
  double best = HUGE_VAL;
  int tries = 0, level = first;
  levels[first] = searched_level(within, first, values, 0);
  while (level >= first) {
    SearchedLevel* here = &levels[level];
    if (!here->is_open || tries >= most_tries) {
      --level;
      if (level >= first) go_outwards(within, level, best, &levels[level]);
      continue;
    }
    ++tries;
    double reached = 0;
    Values at = turned_by_number(within, level, here, &reached);
    if (reached < best && level + 1 < last) {
      ++level;
      levels[level] = searched_level(within, level, &at, reached);
      continue;
    }
    if (reached < best && settle_last(within, last, &at)) {
      const double whole = reached + part_of_square(within, last, &at);
      if (whole < best) *values = at;
      best = smaller(whole, best);
    }
    go_outwards(within, level, best, here);
  }
  if (!(best < HUGE_VAL) && tries >= most_tries) *is_cut = true;
  return best < HUGE_VAL;
}

/// Takes the only number of a level that may be inside.
static bool take_only(const WithinMotors* within, int level, Values* values) {
  turn_values(level, turns_from(&within->ranges[level], values->of[level_begin(level)]), values);
  return is_inside(within, level, values);
}

/// Brings the values that are moved alone next to their centres, others stay. Returns false if one is outside.
static bool settle_alone(const WithinMotors* within, Values* values) {
  for (int k = 0; k < within->settled_count; ++k) {
    const int i = within->settled[k];
    const double off = within->alone_middle.of[i] - values->of[i];
    const double value = values->of[i] + within->alone_step.of[i] * nearest_whole(off * within->alone_per_step.of[i]);
    if (!(value - within->alone_lower.of[i] >= 0 && within->alone_upper.of[i] - value >= 0)) return false;
    values->of[i] = value;
  }
  return true;
}

/// Settles all levels that are not alone, a block or a level at a time.
static bool settle_levels(const WithinMotors* within, Values* values, bool* is_cut) {
  for (int k = 0; k < within->joined_count; ++k) {
    const int level = within->joined[k];
    if (turn_ends_block[level]) {
      if (!settle_last(within, level, values)) return false;
    } else if (has_one_place(&within->ranges[level])) {
      if (!take_only(within, level, values)) return false;
    } else {
      if (!search_block(within, level, values, is_cut)) return false;
      k += last_of_block(level) - level;
    }
  }
  return true;
}

/// Puts the representative in place of a row that is inside and nearest to the centre, and sets the square of its distance.
/// Returns false if there is none; `is_cut` is then set if the search was given up.
static bool take_nearest_turn(const WithinMotors* within, double* motors, double* square, bool* is_cut) {
  Values values = values_of(motors);
  if (!settle_alone(within, &values) || !settle_levels(within, &values, is_cut)) return false;
  *square = 0;
  for (int i = 0; i < bounded; ++i) {
    const double off = values.of[i] - within->centre.of[i];
    if (motor_of[i] >= 0) *square += off * off;
  }
  take_motors(within, &values, motors);
  return true;
}
