// Platforms on six rods, all of whose places paths lead to: six_rods/ of the C++ library says more of each. Complex numbers, then the
// equations in Study's parameters, paths, and proofs; sums are in the order of C++, so that all bits are those of C++.

typedef struct Complex {
  double re, im;
} Complex;

static inline Complex complex_number(double re, double im) {
  const Complex c = {re, im};
  return c;
}
static inline Complex complex_sum(Complex a, Complex b) { return complex_number(a.re + b.re, a.im + b.im); }
static inline Complex complex_difference(Complex a, Complex b) { return complex_number(a.re - b.re, a.im - b.im); }
static inline Complex complex_negative(Complex a) { return complex_number(-a.re, -a.im); }
static inline Complex scaled_by(double b, Complex a) { return complex_number(a.re * b, a.im * b); }
static inline Complex complex_product(Complex a, Complex b) {
  return complex_number(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}
static inline Complex sum_of_three(Complex a, Complex b, Complex c) { return complex_sum(complex_sum(a, b), c); }
static inline Complex sum_of_four(Complex a, Complex b, Complex c, Complex d) { return complex_sum(sum_of_three(a, b, c), d); }
static inline double complex_square(Complex a) { return a.re * a.re + a.im * a.im; }
static inline double complex_size(Complex a) { return sqrt(complex_square(a)); }
static inline Complex complex_reciprocal(Complex a) {
  const double scale = 1 / complex_square(a);
  return complex_number(a.re * scale, -a.im * scale);
}

/// The largest absolute value.
static double largest_complex(const Complex* values, int count) {
  double most = 0;
  for (int i = 0; i < count; ++i) {
    const double square = complex_square(values[i]);
    most = most < square ? square : most;
  }
  return sqrt(most);
}

static bool are_finite_complex(const Complex* values, int count) {
  for (int i = 0; i < count; ++i)
    if (!(fabs(values[i].re) <= DBL_MAX && fabs(values[i].im) <= DBL_MAX)) return false;
  return true;
}

/// A quaternion x of the turn, and y = t x.
typedef struct StudyPoint {
  Complex of[8];
} StudyPoint;

/// x . y, then the equations of the rods.
typedef struct RodValues {
  Complex of[7];
} RodValues;

typedef struct RodGradients {
  StudyPoint of[7];
} RodGradients;

typedef struct RodSquares {
  Complex of[6];
} RodSquares;

/// The plane in which points are followed.
typedef struct StudyPatch {
  Complex of[4];
} StudyPatch;

typedef struct RodPoints {
  double of[6][3];
} RodPoints;

typedef struct RodEnds {
  RodPoints base, platform;
} RodEnds;

/// A platform whose places are known for some complex lengths.
typedef struct RodStart {
  double unit;
  double base_centre[3], platform_centre[3];
  RodEnds ends;
  RodSquares squares;
  StudyPatch patch;
} RodStart;

/// The products of coordinates that the equations are made of.
typedef struct StudyProducts {
  Complex study, turn, place;
  Complex matrix[9], slide[3], cross[3];
} StudyProducts;

static const StudyProducts no_products = {{0, 0}, {0, 0}, {0, 0}, {{0, 0}}, {{0, 0}}, {{0, 0}}};

static Complex both_orders(const Complex* u, const Complex* v, int i, int j) { return complex_sum(complex_product(u[i], v[j]), complex_product(u[j], v[i])); }

static void add_products(const StudyPoint* first, const StudyPoint* second, StudyProducts* sum) {
  const Complex *u = first->of, *v = second->of;
  const Complex s0 = complex_product(u[0], v[0]), s1 = complex_product(u[1], v[1]), s2 = complex_product(u[2], v[2]), s3 = complex_product(u[3], v[3]);
  const Complex x01 = both_orders(u, v, 0, 1), x02 = both_orders(u, v, 0, 2), x03 = both_orders(u, v, 0, 3);
  const Complex x12 = both_orders(u, v, 1, 2), x13 = both_orders(u, v, 1, 3), x23 = both_orders(u, v, 2, 3);
  const Complex study = sum_of_four(both_orders(u, v, 0, 4), both_orders(u, v, 1, 5), both_orders(u, v, 2, 6), both_orders(u, v, 3, 7));
  const Complex place = sum_of_four(complex_product(u[4], v[4]), complex_product(u[5], v[5]), complex_product(u[6], v[6]), complex_product(u[7], v[7]));
  sum->study = complex_sum(sum->study, scaled_by(0.5, study));
  sum->turn = complex_sum(sum->turn, scaled_by(0.5, sum_of_four(s0, s1, s2, s3)));
  sum->place = complex_sum(sum->place, scaled_by(0.5, place));
  const Complex more[9] = {sum_of_four(s0, s1, complex_negative(s2), complex_negative(s3)), complex_difference(x12, x03), complex_sum(x13, x02),
                           complex_sum(x12, x03), sum_of_four(s0, complex_negative(s1), s2, complex_negative(s3)), complex_difference(x23, x01),
                           complex_difference(x13, x02), complex_sum(x23, x01), sum_of_four(s0, complex_negative(s1), complex_negative(s2), s3)};
  for (int k = 0; k < 9; ++k) sum->matrix[k] = complex_sum(sum->matrix[k], more[k]);
  for (int i = 0; i < 3; ++i) {
    const int j = 1 + (i + 1) % 3, k = 1 + (i + 2) % 3;
    const Complex slide = complex_difference(both_orders(u, v, 0, 5 + i), both_orders(u, v, 4, 1 + i));
    const Complex across = complex_difference(both_orders(u, v, j, 4 + k), both_orders(u, v, k, 4 + j));
    sum->slide[i] = complex_sum(sum->slide[i], scaled_by(0.5, slide));
    sum->cross[i] = complex_sum(sum->cross[i], scaled_by(0.5, across));
  }
}

typedef struct RodForm {
  double squares, outer[9], form[4][4], difference[3], sum[3];
} RodForm;

typedef struct RodEquations {
  RodForm rods[6];
} RodEquations;

static double square_in_order(const double* a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; }

static void rod_of(const double* a, const double* b, RodForm* rod) {
  rod->squares = square_in_order(a) + square_in_order(b);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rod->outer[3 * i + j] = a[i] * b[j];
    rod->difference[i] = b[i] - a[i];
    rod->sum[i] = a[i] + b[i];
  }
  const double* o = rod->outer;
  const double form[4][4] = {{o[0] + o[4] + o[8], o[7] - o[5], o[2] - o[6], o[3] - o[1]},
                             {o[7] - o[5], o[0] - o[4] - o[8], o[1] + o[3], o[2] + o[6]},
                             {o[2] - o[6], o[1] + o[3], o[4] - o[0] - o[8], o[5] + o[7]},
                             {o[3] - o[1], o[2] + o[6], o[5] + o[7], o[8] - o[0] - o[4]}};
  memcpy(rod->form, form, sizeof rod->form);
}

static void rod_equations_of(const RodEnds* ends, RodEquations* equations) {
  for (int i = 0; i < 6; ++i) rod_of(ends->base.of[i], ends->platform.of[i], &equations->rods[i]);
}

static Complex rod_factor(const RodForm* rod, Complex square) { return complex_difference(complex_number(rod->squares, 0), square); }

static void rod_values(const RodEquations* equations, const StudyProducts* of, const RodSquares* squares, RodValues* values) {
  values->of[0] = of->study;
  for (int i = 0; i < 6; ++i) {
    const RodForm* rod = &equations->rods[i];
    Complex value = of->place;
    for (int k = 0; k < 9; ++k) value = complex_difference(value, scaled_by(rod->outer[k], of->matrix[k]));
    for (int k = 0; k < 3; ++k)
      value = complex_sum(value, complex_difference(scaled_by(rod->difference[k], of->slide[k]), scaled_by(rod->sum[k], of->cross[k])));
    values->of[i + 1] = complex_sum(value, complex_product(rod_factor(rod, squares->of[i]), of->turn));
  }
}

static void rod_gradient(const RodForm* rod, Complex factor, const StudyPoint* point, StudyPoint* gradient) {
  const double *d = rod->difference, *s = rod->sum;
  const Complex* z = point->of;
  Complex* g = gradient->of;
  for (int i = 0; i < 4; ++i) {
    g[i] = complex_product(factor, z[i]);
    for (int j = 0; j < 4; ++j) g[i] = complex_difference(g[i], scaled_by(2.0, scaled_by(rod->form[i][j], z[j])));
    g[4 + i] = z[4 + i];
  }
  g[0] = complex_sum(g[0], sum_of_three(scaled_by(d[0], z[5]), scaled_by(d[1], z[6]), scaled_by(d[2], z[7])));
  g[4] = complex_difference(g[4], sum_of_three(scaled_by(d[0], z[1]), scaled_by(d[1], z[2]), scaled_by(d[2], z[3])));
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Complex by_place = complex_difference(scaled_by(s[k], z[5 + j]), scaled_by(s[j], z[5 + k]));
    const Complex by_turn = complex_difference(scaled_by(s[j], z[1 + k]), scaled_by(s[k], z[1 + j]));
    g[1 + i] = complex_difference(g[1 + i], complex_sum(scaled_by(d[i], z[4]), by_place));
    g[5 + i] = complex_sum(g[5 + i], complex_difference(scaled_by(d[i], z[0]), by_turn));
  }
}

static void rod_gradients(const RodEquations* equations, const StudyPoint* z, const RodSquares* squares, RodGradients* rows) {
  for (int i = 0; i < 8; ++i) rows->of[0].of[i] = z->of[(i + 4) % 8];
  for (int i = 0; i < 6; ++i)
    rod_gradient(&equations->rods[i], rod_factor(&equations->rods[i], squares->of[i]), z, &rows->of[i + 1]);
}

/// Sums of the sizes of an equation's second derivatives: by two coordinates of x, by one of each, by two of y.
typedef struct Curvature {
  double turn, mixed, place;
} Curvature;

static double weighted_curvature(const Curvature* c, double weight) { return c->turn + weight * (c->mixed + weight * c->place); }

static void rod_curvatures(const RodEquations* equations, const RodSquares* squares, Curvature* sums) {
  sums[0].turn = sums[0].place = 0;
  sums[0].mixed = 8;
  for (int i = 0; i < 6; ++i) {
    Curvature* sum = &sums[i + 1];
    sum->turn = 4 * (complex_size(complex_number(equations->rods[i].squares, 0)) + complex_size(squares->of[i]));
    sum->mixed = 0;
    sum->place = 4;
    for (int k = 0; k < 4; ++k) {
      StudyPoint unit, row;
      for (int j = 0; j < 8; ++j) unit.of[j] = complex_number(j == k ? 1 : 0, 0);
      rod_gradient(&equations->rods[i], complex_number(0, 0), &unit, &row);
      for (int j = 0; j < 4; ++j) sum->turn += complex_size(row.of[j]);
      for (int j = 4; j < 8; ++j) sum->mixed += 2 * complex_size(row.of[j]);
    }
  }
}

typedef struct RodMatrix {
  Complex rows[7][7];
} RodMatrix;

/// Factors of seven equations; not regular if a pivot is zero or not finite.
typedef struct RodFactors {
  RodMatrix m;
  int row[7];
  Complex pivot[7];
  bool regular;
} RodFactors;

static void eliminate_column(RodFactors* f, int k) {
  int best = k;
  for (int i = k + 1; i < 7; ++i)
    if (complex_square(f->m.rows[f->row[i]][k]) > complex_square(f->m.rows[f->row[best]][k])) best = i;
  const int taken = f->row[k];
  f->row[k] = f->row[best];
  f->row[best] = taken;
  const Complex* top = f->m.rows[f->row[k]];
  f->pivot[k] = complex_reciprocal(top[k]);
  f->regular = are_finite_complex(&f->pivot[k], 1);
  for (int i = k + 1; i < 7; ++i) {
    Complex* row = f->m.rows[f->row[i]];
    row[k] = complex_product(row[k], f->pivot[k]);
    for (int j = k + 1; j < 7; ++j) row[j] = complex_difference(row[j], complex_product(row[k], top[j]));
  }
}

static void factor_rods(const RodMatrix* matrix, RodFactors* f) {
  f->m = *matrix;
  f->regular = true;
  for (int k = 0; k < 7; ++k) f->row[k] = k;
  for (int k = 0; k < 7 && f->regular; ++k) eliminate_column(f, k);
}

static void solve_rods(const RodFactors* f, const RodValues* right, RodValues* x) {
  for (int i = 0; i < 7; ++i) {
    x->of[i] = right->of[f->row[i]];
    for (int j = 0; j < i; ++j) x->of[i] = complex_difference(x->of[i], complex_product(f->m.rows[f->row[i]][j], x->of[j]));
  }
  for (int i = 6; i >= 0; --i) {
    for (int j = i + 1; j < 7; ++j) x->of[i] = complex_difference(x->of[i], complex_product(f->m.rows[f->row[i]][j], x->of[j]));
    x->of[i] = complex_product(x->of[i], f->pivot[i]);
  }
}
