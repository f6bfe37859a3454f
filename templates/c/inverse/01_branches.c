// State of a branch, and how equations treat the ends of their ranges: branch.h, boundary.h and target.h of the C++
// library say more of each. Each tolerance_NAME is the number of that name in tolerances.h; bounds of rounding are wider in
// float: single_precision.h.

typedef struct Branch {
  bool exists;     // false: no such solution
  bool continuum;  // an angle was free and has been chosen
  bool doubtful;   // rounding may have decided what exists, on this branch or on one before
  bool unsure;     // the same on this branch alone, in passes near singular poses too
} Branch;

static const Branch new_branch = {true, false, false, false};

typedef struct Boundary {
  double accept, doubt, beyond, unsure, floor, near, gap, miss, fold;
  bool wide, choose, take, opposite;
} Boundary;

static const Boundary boundary_of_nothing = {0, 0, 0, tolerance_end_inside, 0, tolerance_nearly_free, tolerance_gap, 0, 0, true, false, false, false};

/// Boundary of regular poses.
static Boundary plain_boundary(double tolerance) {
  Boundary b = boundary_of_nothing;
  b.doubt = tolerance_end_inside + tolerance_range_per_size * tolerance;
  b.beyond = tolerance_end_outside + tolerance_range_per_size * tolerance;
  b.miss = tolerance;
  b.fold = tolerance;
  return b;
}

/// From the ends of the ranges, taking no miss but rounding.
static Boundary careful_boundary(double tolerance) {
  Boundary b = boundary_of_nothing;
  b.accept = tolerance_end_careful + tolerance_range_per_size * tolerance;
  b.gap = tolerance_gap_careful;
  b.fold = tolerance > tolerance_least_fold ? tolerance : tolerance_least_fold;
  return b;
}

static Boundary ends_boundary(double tolerance) {
  Boundary b = careful_boundary(tolerance);
  b.unsure = tolerance_end_inside + tolerance_range_per_size * tolerance;
  b.wide = false;
  b.miss = tolerance;
  return b;
}

/// Pass `careful` with a choice where an angle is nearly free.
static Boundary chosen_boundary(double tolerance) {
  Boundary b = ends_boundary(tolerance);
  b.choose = true;
  return b;
}

/// Boundary of a pass that chooses, with a choice of which joints can follow in two ranges in the other one.
static Boundary in_other_range(Boundary b) {
  b.opposite = true;
  return b;
}

/// Pass `choosing` for a choice that leaves the joints after it out of reach.
static Boundary stretched_boundary(double tolerance) {
  Boundary b = chosen_boundary(tolerance);
  b.accept = tolerance_end_anywhere;
  b.gap = tolerance_gap_anything;
  return b;
}

// Passes of arms with a quartic.

static Boundary choosing_boundary(double tolerance) {
  Boundary b = careful_boundary(tolerance);
  b.choose = true;
  b.take = true;
  return b;
}

static Boundary reaching_boundary(double tolerance) {
  Boundary b = choosing_boundary(tolerance);
  b.accept = tolerance_end_anywhere;
  return b;
}

static Boundary taking_boundary(double tolerance) {
  Boundary b = careful_boundary(tolerance);
  b.take = true;
  return b;
}

static Boundary apart_boundary(double tolerance) {
  Boundary b = choosing_boundary(tolerance);
  b.floor = tolerance_end_apart;
  return b;
}

static Boundary tolerant_boundary(double tolerance) {
  Boundary b = taking_boundary(tolerance);
  b.miss = tolerance;
  return b;
}

/// True if this is the pass of a regular pose.
static inline bool is_plain(const Boundary* boundary) { return boundary->doubt > 0; }

/// Two roots closer than this share of their range are one double root.
static inline double merge_share(void) { return 18 * DBL_EPSILON; }

/// Back to a fork; doubts stay.
static inline void resume(Branch* branch, const Branch* fork) {
  branch->exists = fork->exists;
  branch->continuum = fork->continuum;
  branch->unsure = fork->unsure;
}

static inline void doubt(Branch* branch, bool condition) {
  branch->doubtful = branch->doubtful || (branch->exists && condition);
  branch->unsure = branch->unsure || condition;
}

/// Takes the choice where an angle is free and the equation holds, and the result of a regular block elsewhere.
static inline void take(Branch* branch, bool is_free, bool holds, const Branch* regular) {
  branch->doubtful = branch->doubtful || (branch->exists && is_free) || regular->doubtful;
  branch->unsure = branch->unsure || is_free || regular->unsure;
  branch->exists = (is_free && branch->exists && holds) || (!is_free && regular->exists);
  branch->continuum = branch->continuum || (branch->exists && is_free);
}

static inline double smaller(double a, double b) { return a < b ? a : b; }

static inline double larger(double a, double b) { return a > b ? a : b; }

static inline double not_negative(double a) { return a > 0 ? a : 0; }

/// |magnitude| with the sign of `sign`, +0 and -0 counting as positive.
static inline double with_sign(double magnitude, double sign) { return sign < 0 ? -magnitude : magnitude; }

/// -a where the sign bit is set.
static inline double flipped(double a, double sign) { return a * copysign(1.0, sign); }

static inline double negated(bool condition, double a) { return condition ? -a : a; }

static inline double clamped(double x, double low, double high) { return smaller(larger(x, low), high); }
