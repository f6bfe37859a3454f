// Paths to the places of a platform on six rods, and proofs of their ends: path.h, proof.h and places.h in six_rods/ of the C++
// library say more of each.

static const int series_order = 10;

/// Follows one point while the squares of the lengths go along a line.
typedef struct RodPath {
  const RodEquations* equations;
  const StudyPatch* patch;
  RodSquares from, change;
} RodPath;

/// A path's coefficients.
typedef struct RodSeries {
  StudyPoint of[11];  // series_order and one more
} RodSeries;

/// Jacobian in the patch, by all coordinates but the first, which follows the others there.
static void within_patch(const StudyPatch* patch, const RodGradients* rows, RodMatrix* m) {
  const Complex scale = complex_reciprocal(patch->of[0]);
  for (int i = 0; i < 7; ++i) {
    const Complex first = complex_product(rows->of[i].of[0], scale);
    for (int j = 0; j < 7; ++j) {
      m->rows[i][j] = rows->of[i].of[j + 1];
      if (j < 3) m->rows[i][j] = complex_difference(m->rows[i][j], complex_product(first, patch->of[j + 1]));
    }
  }
}

/// Step of all coordinates by a step of all but the first.
static void full_step(const StudyPatch* patch, const RodValues* step, StudyPoint* all) {
  const Complex sum = sum_of_three(complex_product(step->of[0], patch->of[1]), complex_product(step->of[1], patch->of[2]), complex_product(step->of[2], patch->of[3]));
  all->of[0] = complex_negative(complex_product(sum, complex_reciprocal(patch->of[0])));
  for (int i = 0; i < 7; ++i) all->of[i + 1] = step->of[i];
}

static void squares_on_path(const RodPath* path, double at, RodSquares* squares) {
  for (int i = 0; i < 6; ++i) squares->of[i] = complex_sum(path->from.of[i], scaled_by(at, path->change.of[i]));
}

static void rod_gaps(const RodEquations* equations, const StudyPoint* z, const RodSquares* squares, RodValues* gaps) {
  StudyProducts products = no_products;
  add_products(z, z, &products);
  rod_values(equations, &products, squares, gaps);
}

/// One of Newton's steps, whose factors stay; false if these are not regular.
static bool newton_of_rods(const RodPath* path, StudyPoint* z, const RodSquares* squares, RodFactors* factors, StudyPoint* step) {
  RodGradients rows;
  RodMatrix matrix;
  RodValues gaps, solved;
  rod_gradients(path->equations, z, squares, &rows);
  within_patch(path->patch, &rows, &matrix);
  factor_rods(&matrix, factors);
  if (!factors->regular) return false;
  rod_gaps(path->equations, z, squares, &gaps);
  solve_rods(factors, &gaps, &solved);
  full_step(path->patch, &solved, step);
  return true;
}

static void take_step(const StudyPoint* step, StudyPoint* z) {
  for (int i = 0; i < 8; ++i) z->of[i] = complex_difference(z->of[i], step->of[i]);
}

/// Newton's step; returns its size as a share of the point's, or infinity.
static double newton_on_path(const RodPath* path, StudyPoint* z, const RodSquares* squares) {
  RodFactors factors;
  StudyPoint step;
  if (!newton_of_rods(path, z, squares, &factors, &step)) return HUGE_VAL;
  take_step(&step, z);
  return largest_complex(step.of, 8) / largest_complex(z->of, 8);
}

static bool correct_on_path(const RodPath* path, StudyPoint* z, double at) {
  RodSquares squares;
  squares_on_path(path, at, &squares);
  return newton_on_path(path, z, &squares) < 1e-2;
}

/// Newton's steps at the end, as long as they help.
static bool polish_end(const RodPath* path, StudyPoint* z) {
  RodSquares squares;
  squares_on_path(path, 1, &squares);
  double last = 1;
  for (int k = 0; k < 4; ++k) {
    const double step = newton_on_path(path, z, &squares);
    if (!(step < 1e-3)) return false;
    if (step > 0.5 * last || step < 1e-15) break;
    last = step;
  }
  return are_finite_complex(z->of, 8);
}

/// Newton's steps at the end from a point that need not be regular.
static void approach_end(const RodPath* path, StudyPoint* z) {
  RodSquares squares;
  squares_on_path(path, 1, &squares);
  for (int k = 0; k < 60; ++k) {
    StudyPoint next = *z;
    if (!(newton_on_path(path, &next, &squares) < 0.1)) return;
    *z = next;
  }
}

/// Coefficient k of |x|^2 / 2.
static Complex turn_of_series(const RodSeries* series, int k) {
  Complex sum = {0, 0};
  for (int a = 0; a <= k; ++a)
    for (int i = 0; i < 4; ++i) sum = complex_sum(sum, complex_product(series->of[a].of[i], series->of[k - a].of[i]));
  return scaled_by(0.5, sum);
}

/// Right side of the equations of coefficient k.
static void right_of_series(const RodPath* path, const RodSeries* series, int k, const RodSquares* squares, Complex turn, RodValues* right) {
  StudyProducts products = no_products;
  for (int a = 1; 2 * a < k; ++a) {
    StudyPoint twice = series->of[a];
    for (int i = 0; i < 8; ++i) twice.of[i] = scaled_by(2, twice.of[i]);
    add_products(&twice, &series->of[k - a], &products);
  }
  if (k % 2 == 0) add_products(&series->of[k / 2], &series->of[k / 2], &products);
  rod_values(path->equations, &products, squares, right);
  for (int i = 0; i < 7 && k == 1; ++i) right->of[i] = complex_number(0, 0);
  for (int i = 0; i < 6; ++i) right->of[i + 1] = complex_difference(right->of[i + 1], complex_product(path->change.of[i], turn));
}

/// One more of Newton's steps, which has to be tiny, and the coefficients of the series from there.
static bool expand_path(const RodPath* path, StudyPoint* z, double at, RodSeries* series) {
  RodSquares squares;
  RodFactors factors;
  StudyPoint step;
  squares_on_path(path, at, &squares);
  if (!newton_of_rods(path, z, &squares, &factors, &step)) return false;
  if (!(largest_complex(step.of, 8) < 1e-6 * largest_complex(z->of, 8))) return false;
  take_step(&step, z);
  series->of[0] = *z;
  Complex turn = turn_of_series(series, 0);
  for (int k = 1; k <= series_order; ++k) {
    RodValues right, solved;
    right_of_series(path, series, k, &squares, turn, &right);
    solve_rods(&factors, &right, &solved);
    full_step(path->patch, &solved, &series->of[k]);
    for (int i = 0; i < 8; ++i) series->of[k].of[i] = complex_negative(series->of[k].of[i]);
    turn = turn_of_series(series, k);
  }
  return true;
}

static double reach_by(const RodSeries* series, double allowed, int k) {
  return pow(allowed / (largest_complex(series->of[k].of, 8) + 1e-300), 1.0 / k);
}

/// How far a series may be followed.
static double reach_of_series(const RodSeries* series, double error) {
  const double allowed = error * largest_complex(series->of[0].of, 8);
  const double first = reach_by(series, allowed, series_order), second = reach_by(series, allowed, series_order - 1);
  return second < first ? second : first;
}

static StudyPoint sum_of_series(const RodSeries* series, double step) {
  StudyPoint z = series->of[series_order];
  for (int k = series_order - 1; k >= 0; --k)
    for (int i = 0; i < 8; ++i) z.of[i] = complex_sum(scaled_by(step, z.of[i]), series->of[k].of[i]);
  return z;
}

/// Moves a point at the start to the end, in so many steps at most, taken or tried. False if these do not suffice or the path is lost.
static bool follow_path(const RodPath* path, StudyPoint* z, double error, int steps) {
  RodSeries series, next_series;
  if (!correct_on_path(path, z, 0) || !expand_path(path, z, 0, &series)) return false;
  double at = 0, step = reach_of_series(&series, error);
  for (int k = 0; k < steps && step > 1e-12; ++k) {
    const double next = at + step < 1 ? at + step : 1;
    StudyPoint moved = sum_of_series(&series, next - at);
    if (!correct_on_path(path, &moved, next) || !expand_path(path, &moved, next, &next_series)) {
      step = 0.5 * (next - at);
      continue;
    }
    *z = moved;
    if (next == 1) return polish_end(path, z);
    at = next;
    series = next_series;
    step = reach_of_series(&series, error);
  }
  return false;
}

/// A point with the zero that is known to be there. Radii are in the maximum norm of x and of y / weight.
typedef struct RodProof {
  StudyPoint z;
  int one;
  double weight, within, alone;
  bool proven;
} RodProof;

static double unit_of_proof(const RodProof* proof, int coordinate) { return coordinate < 4 ? 1 : proof->weight; }

static double imaginary_of_proof(const RodProof* proof) {
  double most = 0;
  for (int i = 0; i < 8; ++i) most = larger(fabs(proof->z.of[i].im) / unit_of_proof(proof, i), most);
  return most;
}

static bool is_real_proof(const RodProof* proof) {
  return proof->proven && 2 * imaginary_of_proof(proof) + proof->within < proof->alone;
}

static bool is_not_real_proof(const RodProof* proof) { return proof->proven && imaginary_of_proof(proof) > proof->within; }

static StudyPoint scaled_point(const StudyPoint* z, int one) {
  const Complex factor = complex_reciprocal(z->of[one]);
  StudyPoint result;
  for (int i = 0; i < 8; ++i) result.of[i] = complex_product(z->of[i], factor);
  result.of[one] = complex_number(1, 0);
  return result;
}

static int largest_of_turn(const StudyPoint* z) {
  int best = 0;
  for (int i = 1; i < 4; ++i)
    if (complex_square(z->of[i]) > complex_square(z->of[best])) best = i;
  return best;
}

/// An approximate inverse of the Jacobian by all coordinates but one, a column each.
typedef struct RodInverse {
  RodMatrix matrix;
  RodValues columns[7];
  double units[7];
} RodInverse;

static bool invert_rods(const RodGradients* rows, const RodProof* proof, RodInverse* inverse) {
  RodFactors factors;
  for (int j = 0; j < 7; ++j) {
    const int coordinate = j < proof->one ? j : j + 1;
    for (int i = 0; i < 7; ++i) inverse->matrix.rows[i][j] = rows->of[i].of[coordinate];
    inverse->units[j] = unit_of_proof(proof, coordinate);
  }
  factor_rods(&inverse->matrix, &factors);
  for (int k = 0; k < 7 && factors.regular; ++k) {
    RodValues unit;
    for (int i = 0; i < 7; ++i) unit.of[i] = complex_number(i == k ? 1 : 0, 0);
    solve_rods(&factors, &unit, &inverse->columns[k]);
  }
  return factors.regular;
}

static const double rod_roundings = 32 * DBL_EPSILON;

/// Bound of the inverse times values that are off by so much each.
static double bound_of_inverse(const RodInverse* inverse, const RodValues* values, const double* off) {
  double most = 0;
  for (int i = 0; i < 7; ++i) {
    Complex sum = {0, 0};
    double more = 0;
    for (int k = 0; k < 7; ++k) {
      sum = complex_sum(sum, complex_product(inverse->columns[k].of[i], values->of[k]));
      more += complex_size(inverse->columns[k].of[i]) * (off[k] + rod_roundings * complex_size(values->of[k]));
    }
    most = larger((complex_size(sum) + more) / inverse->units[i], most);
  }
  return most;
}

static double missing_entry(const RodInverse* inverse, int i, int j) {
  Complex entry = {i == j ? 1.0 : 0.0, 0};
  double terms = 1;
  for (int k = 0; k < 7; ++k) {
    entry = complex_difference(entry, complex_product(inverse->columns[k].of[i], inverse->matrix.rows[k][j]));
    terms += complex_size(inverse->columns[k].of[i]) * complex_size(inverse->matrix.rows[k][j]);
  }
  return complex_size(entry) + rod_roundings * terms;
}

/// Bound of what the inverse times the Jacobian lacks of 1.
static double missing_of_inverse(const RodInverse* inverse) {
  double most = 0;
  for (int i = 0; i < 7; ++i) {
    double sum = 0;
    for (int j = 0; j < 7; ++j) sum += missing_entry(inverse, i, j) * inverse->units[j];
    most = larger(sum / inverse->units[i], most);
  }
  return most;
}

/// Proves the zero next to a point, for real lengths.
static void prove_place(const RodEquations* equations, const Curvature* curvatures, const RodSquares* squares, const StudyPoint* near, RodProof* proof) {
  RodGradients rows;
  RodInverse inverse;
  RodValues gaps, none;
  double bends[7], rounded[7];
  proof->proven = false;
  proof->one = largest_of_turn(near);
  proof->z = scaled_point(near, proof->one);
  proof->weight = 1;
  proof->within = proof->alone = 0;
  if (!are_finite_complex(proof->z.of, 8)) return;
  for (int i = 4; i < 8; ++i) proof->weight = larger(complex_size(proof->z.of[i]), proof->weight);
  rod_gradients(equations, &proof->z, squares, &rows);
  if (!invert_rods(&rows, proof, &inverse)) return;
  for (int i = 0; i < 7; ++i) {
    bends[i] = weighted_curvature(&curvatures[i], proof->weight);
    rounded[i] = rod_roundings * bends[i];
    none.of[i] = complex_number(0, 0);
  }
  rod_gaps(equations, &proof->z, squares, &gaps);
  const double newton = bound_of_inverse(&inverse, &gaps, rounded), bend = bound_of_inverse(&inverse, &none, bends);
  proof->within = 2 * newton;
  proof->alone = 0.5 / bend;
  proof->proven = missing_of_inverse(&inverse) <= 0.1 && newton * bend <= 0.05;
}

/// True if two proven points stand for different zeros.
static bool are_different_places(const RodProof* a, const RodProof* b) {
  const double at = complex_size(b->z.of[a->one]);
  if (at <= 2 * b->within) return true;
  const StudyPoint moved = scaled_point(&b->z, a->one);
  for (int i = 0; i < 8; ++i) {
    const double size = complex_size(moved.of[i]);
    const double blur = b->within * (unit_of_proof(b, i) + size) / (at - b->within);
    if (complex_size(complex_difference(moved.of[i], a->z.of[i])) > a->within * unit_of_proof(a, i) + blur + rod_roundings * size) return true;
  }
  return false;
}
