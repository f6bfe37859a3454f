// Angles and slides that a quartic gives: conic_circle.h and slide_and_turn.h of the C++ library.

typedef struct CubicRoots {
  int count;
  double root[3];
} CubicRoots;

static inline double cubic(double x, double b, double c, double d) { return ((x + b) * x + c) * x + d; }

/// Two Newton steps on x^3 + b x^2 + c x + d, taken only where they help.
static double polished_cubic_root(double x, double b, double c, double d) {
  for (int step = 0; step < 2; ++step) {
    const double slope = (3 * x + 2 * b) * x + c;
    if (slope == 0) return x;
    const double next = x - cubic(x, b, c, d) / slope;
    if (!(fabs(cubic(next, b, c, d)) < fabs(cubic(x, b, c, d)))) return x;
    x = next;
  }
  return x;
}

/// Real roots of x^3 + b x^2 + c x + d (Cardano, with the trigonometric form where all three are real).
static CubicRoots real_cubic(double b, double c, double d) {
  const double shift = b / 3;
  const double p = c - b * shift;
  const double q = 2 * shift * shift * shift - shift * c + d;
  const double middle = q / 2;
  const double discriminant = middle * middle + p * p * p / 27;
  CubicRoots found;
  if (discriminant > 0) {
    const double u = cbrt(-middle - with_sign(sqrt(discriminant), middle));
    found.count = 1;
    found.root[0] = u == 0 ? u : u - p / (3 * u);
  } else {
    const double radius = 2 * sqrt(not_negative(-p / 3));
    const double third = atan2(sqrt(not_negative(-discriminant)), -middle) / 3;
    found.count = 3;
    for (int k = 0; k < 3; ++k) found.root[k] = radius * cos(third - 2 * k * pi / 3);
  }
  for (int k = 0; k < found.count; ++k) found.root[k] = polished_cubic_root(found.root[k] - shift, b, c, d);
  return found;
}

/// xx c^2 + xy c s + yy s^2 + x c + y s + one = 0 for the unit vector (c, s).
typedef struct Conic {
  double xx, xy, yy, x, y, one;
} Conic;

typedef struct CircleRoots {
  int count;
  Rotor root[4];
} CircleRoots;

/// g (c^2 - s^2) + 2 p c + 2 q s + k on the unit circle: the conic turned to its axes, its trace moved into
/// k.
typedef struct Aligned {
  double g, p, q, k;
} Aligned;

static double conic_value(const Aligned* f, Rotor u) {
  return f->g * (u.cosine - u.sine) * (u.cosine + u.sine) + 2 * (f->p * u.cosine + f->q * u.sine) + f->k;
}

static double conic_slope(const Aligned* f, Rotor u) {
  return -4 * f->g * u.cosine * u.sine + 2 * (f->q * u.cosine - f->p * u.sine);
}

static double conic_curvature(const Aligned* f, Rotor u) {
  return -4 * f->g * (u.cosine - u.sine) * (u.cosine + u.sine) - 2 * (f->p * u.cosine + f->q * u.sine);
}

/// The degenerate member of the pencil conic + x (circle - 1) that splits into two real lines, as the
/// symmetric matrix of the pair of lines plus the skew matrix of their common point: a matrix of rank one.
static void line_pair(const Aligned* f, double m[3][3]) {
  const double square = f->p * f->p + f->q * f->q;
  const CubicRoots roots =
      real_cubic(-f->k, square - f->g * f->g, f->g * f->g * f->k - f->g * (f->p * f->p - f->q * f->q));
  double best = -1;
  double lambda = 0;
  int column = 0;
  for (int i = 0; i < roots.count; ++i) {
    const double x = roots.root[i];
    const double entries[3] = {f->q * f->q - (x - f->g) * (f->k - x), f->p * f->p - (f->g + x) * (f->k - x),
                               -(f->g + x) * (x - f->g)};
    for (int j = 0; j < 3; ++j) {
      if (entries[j] > best || (i == 0 && j == 0)) {
        best = entries[j];
        lambda = x;
        column = j;
      }
    }
  }
  const double pair[3][3] = {{f->g + lambda, 0, f->p}, {0, lambda - f->g, f->q}, {f->p, f->q, f->k - lambda}};
  memcpy(m, pair, sizeof pair);
  if (!(best > 0)) return;
  double point[3];
  for (int r = 0; r < 3; ++r) {
    const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
    point[r] = (m[r1][c2] * m[r2][c1] - m[r1][c1] * m[r2][c2]) / sqrt(best);
  }
  for (int r = 0; r < 3; ++r) {
    const int r1 = (r + 1) % 3, r2 = (r + 2) % 3;
    m[r1][r2] -= point[r];
    m[r2][r1] += point[r];
  }
}

/// Moves a root along the circle: Newton, near a double root the local parabola's root or its extremum.
static Rotor polished_root(const Aligned* f, Rotor u) {
  for (int step = 0; step < 6; ++step) {
    const double value = conic_value(f, u), slope = conic_slope(f, u), curvature = conic_curvature(f, u);
    const double discriminant = slope * slope - 2 * value * curvature;
    double move = 0;
    if (fabs(slope) < tolerance_little_slope && discriminant > 0) {
      const double below = slope + with_sign(sqrt(discriminant), slope);
      if (below != 0) move = -2 * value / below;
    } else if (!(discriminant > 0) && fabs(slope) < tolerance_slope_to_extremum * fabs(curvature)) {
      move = -slope / curvature;
    } else if (slope != 0) {
      move = -value / slope;
    }
    if (fabs(move) > tolerance_longest_step) move = with_sign(tolerance_longest_step, move);
    u = turned_by(u, move);
    if (fabs(move) < DBL_EPSILON / 2) break;
  }
  return scaled(1 / sqrt(square_of(u)), u);
}

/// The candidates for roots, each once; two that nearly meet count as two even where they are one.
typedef struct RootSearch {
  Aligned f;
  double accept, least;
  CircleRoots found;
  Rotor middle[2];
  int pairs;
} RootSearch;

static double roots_apart(Rotor u, Rotor v) { return fabs(u.cosine - v.cosine) + fabs(u.sine - v.sine); }

static void push_root(RootSearch* search, Rotor u, double least_distance) {
  if (search->found.count == 4) return;
  for (int i = 0; i < search->found.count; ++i)
    if (roots_apart(u, search->found.root[i]) < least_distance) return;
  search->found.root[search->found.count++] = u;
}

/// About the extremum next to u: the local parabola's roots, or the extremum itself twice.
static void add_root_pair(RootSearch* search, Rotor u) {
  const Aligned* f = &search->f;
  const Rotor middle = turned_by(u, -conic_slope(f, u) / conic_curvature(f, u));
  for (int i = 0; i < search->pairs; ++i)
    if (roots_apart(middle, search->middle[i]) < tolerance_same_extremum) return;
  if (search->pairs < 2) search->middle[search->pairs++] = middle;
  const double square = -2 * conic_value(f, middle) / conic_curvature(f, middle);
  const double offset = sqrt(larger(square, search->least));
  push_root(search, turned_by(middle, -offset), 0);
  push_root(search, turned_by(middle, offset), 0);
}

static void add_root(RootSearch* search, Rotor start) {
  const Aligned* f = &search->f;
  const Rotor u = polished_root(f, start);
  if (!(fabs(conic_value(f, u)) < search->accept)) return;
  if (fabs(conic_slope(f, u)) < tolerance_slope_of_pair * fabs(conic_curvature(f, u))) {
    add_root_pair(search, u);
    return;
  }
  if (fabs(conic_value(f, u)) < tolerance_simple_root_value) push_root(search, u, tolerance_same_simple_root);
}

/// The points of the line a.u + d = 0 on the unit circle; a line that misses it narrowly touches it.
static void intersect_line(RootSearch* search, double x, double y, double one) {
  const double length = sqrt(x * x + y * y);
  if (!(length > tolerance_line_direction * fabs(one))) return;
  const double a = x / length, b = y / length, d = -one / length;
  if (fabs(d) > 1 + tolerance_line_touches) return;
  const double foot = smaller(1, fabs(d));
  const double height = sqrt((1 - foot) * (1 + foot));
  const double along = with_sign(foot, d);
  add_root(search, rotor(a * along - b * height, b * along + a * height));
  add_root(search, rotor(a * along + b * height, b * along - a * height));
}

/// The two lines of a matrix of rank one.
static void intersect_lines(RootSearch* search, double lines[3][3]) {
  int row = 0, column = 0;
  for (int i = 0; i < 9; ++i) {
    if (fabs(lines[i / 3][i % 3]) > fabs(lines[row][column])) {
      row = i / 3;
      column = i % 3;
    }
  }
  intersect_line(search, lines[row][0], lines[row][1], lines[row][2]);
  intersect_line(search, lines[0][column], lines[1][column], lines[2][column]);
}

/// The up to four angles of a conic on the unit circle, by the pencil of the two conics: a real root of one
/// cubic, then two lines. Ordered by angle. Nearly double roots count as two: Newton steps on the joints are
/// to decide.
static CircleRoots conic_circle(Conic conic, const Boundary* boundary) {
  RootSearch search = {{0, 0, 0, 0}, tolerance_value_per_accepted * boundary->accept, boundary->floor, {0, {{0, 0}}}, {{0, 0}}, 0};
  const double difference = (conic.xx - conic.yy) / 2;
  const double mixed = conic.xy / 2;
  const double g = sqrt(difference * difference + mixed * mixed);
  const double one = conic.one + (conic.xx + conic.yy) / 2;
  const double scale = g + fabs(conic.x) + fabs(conic.y) + fabs(one);
  if (!(scale > 0)) return search.found;
  const Rotor axis = g > 0 ? half(rotor(difference / g, mixed / g)) : rotor(1, 0);
  search.f.g = g / scale;
  search.f.p = (axis.cosine * conic.x + axis.sine * conic.y) / 2 / scale;
  search.f.q = (axis.cosine * conic.y - axis.sine * conic.x) / 2 / scale;
  search.f.k = one / scale;
  if (search.f.g < tolerance_conic_direction) {
    intersect_line(&search, 2 * search.f.p, 2 * search.f.q, search.f.k);
  } else {
    double lines[3][3];
    line_pair(&search.f, lines);
    intersect_lines(&search, lines);
  }
  CircleRoots* found = &search.found;
  double order[4];
  for (int i = 0; i < found->count; ++i) {
    const Rotor root = product(axis, found->root[i]);
    const double angle = angle_of(root);
    int at = i;
    for (; at > 0 && angle < order[at - 1]; --at) {
      order[at] = order[at - 1];
      found->root[at] = found->root[at - 1];
    }
    order[at] = angle;
    found->root[at] = root;
  }
  return *found;
}

/// A slide t and a unit vector u that a linear equation and a distance bind: divisor t = l(u) and t^2 + 2 h t
/// + m(u) = 0 with l(u) = level + l.u, m(u) = mean + m.u; divisor is a part of a unit vector.
typedef struct SlideAndTurn {
  double divisor, h;
  double level;
  Rotor l;
  double mean;
  Rotor m;
} SlideAndTurn;

typedef struct SlideTurn {
  Rotor turn;
  double slide;
  bool chosen;  // the slide was free
} SlideTurn;

typedef struct SlideTurns {
  int count;
  SlideTurn root[4];
} SlideTurns;

static void add_slide_turn(SlideTurns* found, Rotor turn, double slide, bool chosen) {
  const SlideTurn root = {turn, slide, chosen};
  found->root[found->count++] = root;
}

/// The two unit vectors with v.u = rhs, as far as they exist or nearly so.
static CircleRoots on_line(Rotor v, double rhs, const Boundary* boundary) {
  CircleRoots found;
  found.count = 0;
  const double length = sqrt(square_of(v));
  Branch branch = new_branch;
  for (int sign = 1; sign >= -1; sign -= 2) {
    const Rotor turn = circle_angle(length - rhs, length + rhs, 1 / (2 * length), sign, boundary, &branch);
    if (branch.exists) found.root[found.count++] = scaled(1 / length, product(turn, v));
  }
  return found;
}

/// The divisor in the way: the slide eliminated, and squared, it is a quartic for u.
static void slide_by_quartic(const SlideAndTurn* e, const Boundary* boundary, SlideTurns* found) {
  const double square = e->divisor * e->divisor;
  const double twice = 2 * (e->level + e->h * e->divisor);
  const Conic conic = {e->l.cosine * e->l.cosine,
                       2 * e->l.cosine * e->l.sine,
                       e->l.sine * e->l.sine,
                       twice * e->l.cosine + square * e->m.cosine,
                       twice * e->l.sine + square * e->m.sine,
                       e->level * e->level + 2 * e->h * e->divisor * e->level + square * e->mean};
  const CircleRoots roots = conic_circle(conic, boundary);
  for (int i = 0; i < roots.count; ++i) {
    const Rotor u = roots.root[i];
    add_slide_turn(found, u, (e->level + e->l.cosine * u.cosine + e->l.sine * u.sine) / e->divisor, false);
  }
}

/// Next to no divisor: the linear equation gives u, the distance then the slide.
static void turn_then_slide(const SlideAndTurn* e, double tiny, const Boundary* boundary, SlideTurns* found) {
  const CircleRoots roots = on_line(e->l, -e->level, boundary);
  for (int i = 0; i < roots.count; ++i) {
    const Rotor u = roots.root[i];
    const double m = e->mean + e->m.cosine * u.cosine + e->m.sine * u.sine;
    for (int sign = 1; sign >= -1; sign -= 2) {
      Branch branch = new_branch;
      const double root = signed_root(e->h * e->h - m, e->h * e->h, tiny, sign, boundary, &branch);
      if (branch.exists) add_slide_turn(found, u, root - e->h, false);
    }
  }
}

/// Without a linear equation the slide is free: chosen, as far as the turn can follow.
static void slide_chosen(const SlideAndTurn* e, double choice, Rotor spread, const Boundary* boundary,
                         SlideTurns* found) {
  const double most = sqrt(square_of(e->m));
  const double middle = e->h * e->h - e->mean;
  const double t = slide_between(rotor(e->h, 0), rotor(1, 0), middle - most, middle + most, choice, spread);
  const CircleRoots roots = on_line(e->m, -(t * (t + 2 * e->h) + e->mean), boundary);
  for (int i = 0; i < roots.count; ++i) add_slide_turn(found, roots.root[i], t, true);
}

/// All solutions. Where the divisor vanishes the quartic falls apart into double roots that do not tell the
/// slide; there the starts that lack no more than the divisor's share are as good, for Newton's steps.
static SlideTurns slide_and_turn(SlideAndTurn e, double tiny, double size_square, double choice, Rotor spread,
                                 const Boundary* boundary) {
  const double little = tolerance_lost_divisor;
  SlideTurns found;
  found.count = 0;
  if (fabs(e.divisor) > little)
    slide_by_quartic(&e, boundary, &found);
  else if (square_of(e.l) > little * little * size_square)
    turn_then_slide(&e, tiny, boundary, &found);
  else if (!(e.level * e.level > little * little * size_square))
    slide_chosen(&e, choice, spread, boundary, &found);
  return found;
}
