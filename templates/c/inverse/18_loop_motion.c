// Motion of closed loops: loop_motion.h of the C++ library says more of each.

/// Factors of a square matrix by elimination with row pivots. Solutions of a singular system are not finite.
typedef struct LoopSystem {
  int size;
  double rows[system_size][system_size];  // factors below the diagonal, on it and above
  int order[system_size];                 // of rows, as pivots come
  double reciprocals[system_size];        // of pivots: a system divides as often as it has rows
  double sign;
} LoopSystem;

/// Brings the row with the largest entry of column k to place k; rows stay where they are, their order changes.
static void bring_pivot_to(LoopSystem* s, int k) {
  int best = k;
  for (int i = k + 1; i < s->size; ++i)
    if (fabs(s->rows[s->order[i]][k]) > fabs(s->rows[s->order[best]][k])) best = i;
  if (best == k) return;
  const int row = s->order[k];
  s->order[k] = s->order[best];
  s->order[best] = row;
  s->sign = -s->sign;
}

/// Factors the matrix that stands in the rows.
static void factor_system(LoopSystem* s, int size) {
  s->size = size;
  s->sign = 1;
  for (int i = 0; i < system_size; ++i) s->order[i] = i;
  for (int k = 0; k < size; ++k) {
    bring_pivot_to(s, k);
    const double* pivots = s->rows[s->order[k]];
    const double pivot = pivots[k], reciprocal = 1 / pivot;
    s->reciprocals[k] = reciprocal;
    for (int i = k + 1; i < size && pivot != 0; ++i) {
      double* lower = s->rows[s->order[i]];
      const double factor = lower[k] * reciprocal;
      lower[k] = factor;
      for (int j = k + 1; j < size; ++j) lower[j] -= factor * pivots[j];
    }
  }
}

static double system_determinant(const LoopSystem* s) {
  double product = s->sign;
  for (int k = 0; k < s->size; ++k) product *= s->rows[s->order[k]][k];
  return product;
}

/// Solves matrix * x = right.
static void solve_system(const LoopSystem* s, const double* right, double* x) {
  for (int i = 0; i < s->size; ++i) x[i] = right[s->order[i]];
  for (int k = 0; k < s->size; ++k)
    for (int i = k + 1; i < s->size; ++i) x[i] -= s->rows[s->order[i]][k] * x[k];
  for (int k = s->size - 1; k >= 0; --k) {
    x[k] *= s->reciprocals[k];
    for (int i = 0; i < k; ++i) x[i] -= s->rows[s->order[i]][k] * x[k];
  }
}

/// Solves matrix^T * x = right.
static void solve_transposed_system(const LoopSystem* s, const double* right, double* x) {
  double y[system_size];
  for (int k = 0; k < s->size; ++k) {
    y[k] = right[k];
    for (int i = 0; i < k; ++i) y[k] -= s->rows[s->order[i]][k] * y[i];
    y[k] *= s->reciprocals[k];
  }
  for (int k = s->size - 1; k >= 0; --k)
    for (int i = k + 1; i < s->size; ++i) y[k] -= s->rows[s->order[i]][k] * y[i];
  for (int i = 0; i < s->size; ++i) x[s->order[i]] = y[i];
}

/// Derivative of the loops' equations by all joints.
typedef struct LoopJacobian {
  double rows[passive_count][dof];
} LoopJacobian;

/// Factors the columns of some joints of the loops' equations.
static void factor_loops(const LoopJacobian* jacobian, const int* joints, LoopSystem* s) {
  for (int i = 0; i < passive_count; ++i)
    for (int k = 0; k < passive_count; ++k) s->rows[i][k] = jacobian->rows[i][joints[k]];
  factor_system(s, passive_count);
}

/// Measure, from 0 to 1, of how well some joints are held by the loops if the others are given.
static double loop_measure(const LoopJacobian* jacobian, const int* held) {
  double squares[passive_count], sum = 0, lengths = 1;
  for (int i = 0; i < passive_count; ++i) {
    squares[i] = sum_of_squares(jacobian->rows[i], dof);
    sum += squares[i];
  }
  const double least = tolerance_least_row * sqrt(sum);
  for (int i = 0; i < passive_count; ++i) lengths *= larger(sqrt(squares[i]), least);
  LoopSystem s;
  factor_loops(jacobian, held, &s);
  return lengths > 0 ? fabs(system_determinant(&s)) / lengths : 0;
}
