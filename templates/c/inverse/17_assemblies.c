// Assemblies of closed loops: assembly.h of the C++ library says more of each.

/// Rows of assemblies, and which of them another one meets, by branch.
typedef struct Assembled {
  Rows rows;
  bool meeting[capacity];
  bool is_lost;  // an equation has lost its meaning
} Assembled;

static void start_assemblies(Assembled* found) {
  start_rows(&found->rows);
  for (int i = 0; i < capacity; ++i) found->meeting[i] = false;
  found->is_lost = false;
}

/// Boundary of steps of closed loops: taken at their word, and no farther outside than rounding.
static Boundary boundary_of_loops(void) {
  Boundary b = plain_boundary(0);
  b.accept = tolerance_end_of_loops;
  b.near = 1;
  return b;
}

/// Marks a branch with what is so of another one, which was followed apart from it.
static inline void join(const Branch* other, Branch* branch) {
  branch->exists = branch->exists && other->exists;
  branch->continuum = branch->continuum || other->continuum;
  branch->unsure = branch->unsure || other->unsure;
}

/// Squared distance of two rows, turns the short way round.
static double joint_square(const double* from, const double* to) {
  double off[dof];
  for (int i = 0; i < dof; ++i) {
    const double way = to[i] - from[i];
    off[i] = is_revolute[i] ? without_turns(way) : way;
  }
  return sum_of_squares(off, dof);
}

/// Appends a row, but for one that an earlier row it meets is.
static void append_assembly(Assembled* found, const double* q, int branch, bool is_free, bool meets) {
  const Rows* rows = &found->rows;
  for (int i = 0; meets && i < rows->count; ++i)
    if (found->meeting[rows->rows[i].branch] && sqrt(joint_square(rows->rows[i].q, q)) < tolerance_same_assembly) return;
  if (meets) found->meeting[branch] = true;
  append(&found->rows, q, branch, is_free);
}

static void conclude_assemblies(Assembled* found) {
  conclude(&found->rows);
  if (found->is_lost) found->rows.status = status_incomplete;
}

/// Brings angles next to those of the seed by whole turns, and sorts the rows by their distance from it.
static void put_near(Assembled* found, const double* seed, const bool* is_given) {
  double squares[capacity];
  for (int k = 0; k < found->rows.count; ++k) {
    double* q = found->rows.rows[k].q;
    for (int i = 0; i < dof; ++i)
      if (is_revolute[i] && !is_given[i]) q[i] = seed[i] + without_turns(q[i] - seed[i]);
    squares[k] = joint_square(q, seed);
  }
  sort_rows(found->rows.rows, found->rows.count, squares);
}

/// The largest absolute value; NaN if there is one.
static double largest_of(const double* numbers, int count) {
  double largest = 0;
  for (int i = 0; i < count && largest >= 0; ++i)
    if (!(fabs(numbers[i]) <= largest)) largest = fabs(numbers[i]);
  return largest;
}
