// Two angles from two equations that are linear in the cosine and sine of each: two_turns.h and two_turns_polynomial.h of
// the C++ library say more of each, in the same order of operations.

/// Coefficients of (1, cos u, sin u) times (1, cos v, sin v), row by row.
typedef struct TwoTurnsEquation {
  double c00, c01, c02, c10, c11, c12, c20, c21, c22;
} TwoTurnsEquation;

typedef struct TurnPair {
  Rotor first, second;
  bool meets;  // another solution is so near that rounding may have made two of one
} TurnPair;

typedef struct TurnPairs {
  int count;
  TurnPair root[8];
} TurnPairs;

/// one + c cos + s sin of an angle.
typedef struct Wave {
  double one, c, s;
} Wave;

static double wave_at(Wave wave, Rotor at) { return wave.one + wave.c * at.cosine + wave.s * at.sine; }

static double wave_slope(Wave wave, Rotor at) { return wave.s * at.cosine - wave.c * at.sine; }

static Wave crossed_waves(Wave a, Wave b) {
  const Wave w = {a.c * b.s - a.s * b.c, a.s * b.one - a.one * b.s, a.one * b.c - a.c * b.one};
  return w;
}

/// An equation at a value of u: a wave of v.
static Wave wave_of_second(const double* m, Rotor u) {
  const Wave w = {m[0] + m[3] * u.cosine + m[6] * u.sine, m[1] + m[4] * u.cosine + m[7] * u.sine,
                  m[2] + m[5] * u.cosine + m[8] * u.sine};
  return w;
}

/// Its derivative by u.
static Wave wave_of_second_by_first(const double* m, Rotor u) {
  const Wave w = {m[6] * u.cosine - m[3] * u.sine, m[7] * u.cosine - m[4] * u.sine, m[8] * u.cosine - m[5] * u.sine};
  return w;
}

/// Real trigonometric polynomial: one + the sum of c[k] cos((k + 1) u) + s[k] sin((k + 1) u).
typedef struct Harmonics {
  double one, c[4], s[4];
} Harmonics;

/// Adds a multiple of the square of a polynomial of degree two.
static void add_square(double factor, const Harmonics* f, Harmonics* sum) {
  const double twice = 2 * f->one, c1 = f->c[0], s1 = f->s[0], c2 = f->c[1], s2 = f->s[1];
  sum->one += factor * (f->one * f->one + 0.5 * ((c1 * c1 + s1 * s1) + (c2 * c2 + s2 * s2)));
  sum->c[0] += factor * (twice * c1 + (c1 * c2 + s1 * s2));
  sum->s[0] += factor * (twice * s1 + (c1 * s2 - s1 * c2));
  sum->c[1] += factor * (0.5 * (c1 * c1 - s1 * s1) + twice * c2);
  sum->s[1] += factor * (c1 * s1 + twice * s2);
  sum->c[2] += factor * (c1 * c2 - s1 * s2);
  sum->s[2] += factor * (c1 * s2 + s1 * c2);
  sum->c[3] += factor * (0.5 * (c2 * c2 - s2 * s2));
  sum->s[3] += factor * (c2 * s2);
}

static Wave wave_of_first(const double* m, int k) {
  const Wave w = {m[k], m[3 + k], m[6 + k]};
  return w;
}

static Harmonics product_of_waves(Wave a, Wave b) {
  const double cc = 0.5 * a.c * b.c, ss = 0.5 * a.s * b.s;
  const Harmonics f = {a.one * b.one + (cc + ss),
                       {a.one * b.c + a.c * b.one, cc - ss, 0, 0},
                       {a.one * b.s + a.s * b.one, 0.5 * (a.c * b.s + a.s * b.c), 0, 0}};
  return f;
}

/// The second angle eliminated from two equations.
static Harmonics eliminated_turn(const double* one, const double* other) {
  Harmonics sum = {0, {0, 0, 0, 0}, {0, 0, 0, 0}};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    Harmonics f = product_of_waves(wave_of_first(one, i), wave_of_first(other, j));
    const Harmonics crossed = product_of_waves(wave_of_first(one, j), wave_of_first(other, i));
    f.one -= crossed.one;
    for (int n = 0; n < 2; ++n) {
      f.c[n] -= crossed.c[n];
      f.s[n] -= crossed.s[n];
    }
    add_square(k == 0 ? -1.0 : 1.0, &f, &sum);
  }
  return sum;
}

/// Value and three derivatives of a polynomial.
typedef struct Jet {
  double value, slope, curvature, third;
} Jet;

/// Harmonics 1 to 4 of a polynomial at one angle, and the derivative of each by its own angle, k u.
typedef struct HarmonicsAt {
  double v1, v2, v3, v4, d1, d2, d3, d4;
} HarmonicsAt;

static HarmonicsAt harmonics_at(const Harmonics* f, Rotor at) {
  const double c1 = at.cosine, s1 = at.sine, c2 = c1 * c1 - s1 * s1, s2 = c1 * s1 + c1 * s1;
  const double c3 = c1 * c2 - s1 * s2, s3 = c1 * s2 + s1 * c2, c4 = c2 * c2 - s2 * s2, s4 = c2 * s2 + c2 * s2;
  const HarmonicsAt h = {f->c[0] * c1 + f->s[0] * s1, f->c[1] * c2 + f->s[1] * s2, f->c[2] * c3 + f->s[2] * s3,
                         f->c[3] * c4 + f->s[3] * s4, f->s[0] * c1 - f->c[0] * s1, f->s[1] * c2 - f->c[1] * s2,
                         f->s[2] * c3 - f->c[2] * s3, f->s[3] * c4 - f->c[3] * s4};
  return h;
}

static Jet jet_at(const Harmonics* f, Rotor at) {
  const HarmonicsAt h = harmonics_at(f, at);
  const Jet jet = {((f->one + h.v1) + h.v2) + (h.v3 + h.v4), (h.d1 + 2 * h.d2) + (3 * h.d3 + 4 * h.d4),
                   -((h.v1 + 4 * h.v2) + (9 * h.v3 + 16 * h.v4)), -((h.d1 + 8 * h.d2) + (27 * h.d3 + 64 * h.d4))};
  return jet;
}

/// Jets at a place and across the circle from it: there odd harmonics change their signs.
static void jets_across(const Harmonics* f, Rotor at, Jet* here, Jet* across) {
  const HarmonicsAt h = harmonics_at(f, at);
  const double even[4] = {f->one + (h.v2 + h.v4), 2 * h.d2 + 4 * h.d4, -4 * h.v2 - 16 * h.v4, -8 * h.d2 - 64 * h.d4};
  const double odd[4] = {h.v1 + h.v3, h.d1 + 3 * h.d3, -h.v1 - 9 * h.v3, -h.d1 - 27 * h.d3};
  here->value = even[0] + odd[0];
  here->slope = even[1] + odd[1];
  here->curvature = even[2] + odd[2];
  here->third = even[3] + odd[3];
  across->value = even[0] - odd[0];
  across->slope = even[1] - odd[1];
  across->curvature = even[2] - odd[2];
  across->third = even[3] - odd[3];
}

/// Bound of the fourth derivative.
static double fourth_bound(const Harmonics* f) {
  double sum = 0;
  for (int k = 0; k < 4; ++k)
    sum += (k + 1) * (k + 1) * (k + 1) * (k + 1) * sqrt(f->c[k] * f->c[k] + f->s[k] * f->s[k]);
  return sum;
}

/// Both equations, the polynomial that is left of them, and the solutions that have been found.
typedef struct TurnSearch {
  double e[2][9];
  Harmonics f;
  double fourth, noise;
  int most, visits;
  TurnPairs found;
} TurnSearch;

static Rotor turned_a_little(Rotor u, double angle) {
  const double t = angle / 2, scale = 1 / (1 + t * t);
  return product(rotor((1 - t) * (1 + t) * scale, 2 * t * scale), u);
}

static Rotor unit_turn(Rotor u) { return scaled(1 / sqrt(u.cosine * u.cosine + u.sine * u.sine), u); }

static double turns_apart(Rotor a, Rotor b) { return fabs(a.cosine - b.cosine) + fabs(a.sine - b.sine); }

/// Keeps a solution, but for one that is there: as near as rounding may have moved it.
static void keep_turns(Rotor u, Rotor v, double apart, TurnSearch* s) {
  for (int i = 0; i < 2; ++i)
    if (!(fabs(wave_at(wave_of_second(s->e[i], u), v)) < tolerance_equation_rounding * DBL_EPSILON)) return;
  const double least = tolerance_same_turn, most = tolerance_same_turn_at_most, moved = tolerance_turn_rounding * DBL_EPSILON;
  const double same = most * apart < moved ? most : moved < least * apart ? least : moved / apart;
  TurnPairs* found = &s->found;
  for (int i = 0; i < found->count; ++i)
    if (turns_apart(found->root[i].first, u) < same && turns_apart(found->root[i].second, v) < same) return;
  if (found->count == s->most) return;
  TurnPair* pair = &found->root[found->count++];
  pair->first = u;
  pair->second = v;
  pair->meets = apart < tolerance_curves_meet;
}

/// Newton's steps from a candidate; keeps where they end if both equations hold there.
static void take_turns(Rotor at, Rotor with, TurnSearch* s) {
  Rotor u = unit_turn(at), v = unit_turn(with);
  double last = 64, apart = 1;  // more than any gap; 0 where both equations' curves touch
  for (int step = 0; step < 40; ++step) {
    const Wave a = wave_of_second(s->e[0], u), b = wave_of_second(s->e[1], u);
    const double gap_a = wave_at(a, v), gap_b = wave_at(b, v), gap = fabs(gap_a) + fabs(gap_b);
    const double a_u = wave_at(wave_of_second_by_first(s->e[0], u), v), a_v = wave_slope(a, v);
    const double b_u = wave_at(wave_of_second_by_first(s->e[1], u), v), b_v = wave_slope(b, v);
    const double determinant = a_u * b_v - a_v * b_u;
    const double size = (fabs(a_u) + fabs(a_v)) * (fabs(b_u) + fabs(b_v));
    apart = size > 0 ? fabs(determinant) / size : 0;
    // Further steps would follow rounding alone: solutions meet here.
    if (gap < 64 * DBL_EPSILON && !(gap < 0.5 * last)) break;
    last = gap;
    if (!(apart > tolerance_curves_touch)) break;
    double du = (a_v * gap_b - b_v * gap_a) / determinant, dv = (b_u * gap_a - a_u * gap_b) / determinant;
    const double longest = larger(fabs(du), fabs(dv));
    if (!(longest < tolerance_lost_turn)) return;
    if (longest > 0.3) {
      du = du * 0.3 / longest;
      dv = dv * 0.3 / longest;
    }
    u = turned_a_little(u, du);
    v = turned_a_little(v, dv);
    if (longest < 2 * DBL_EPSILON) break;
  }
  keep_turns(unit_turn(u), unit_turn(v), apart, s);
}

/// Tries u with the v that both waves have in common. Returns whether they tell one.
static bool take_common_turn(Rotor u, TurnSearch* s) {
  const Wave common = crossed_waves(wave_of_second(s->e[0], u), wave_of_second(s->e[1], u));
  const double square = common.c * common.c + common.s * common.s;
  if (!(square > tolerance_common_wave)) return false;
  take_turns(u, scaled(with_sign(1 / sqrt(square), common.one), rotor(common.c, common.s)), s);
  return true;
}

/// Tries u with both v at which the longer wave vanishes: where the waves are (nearly) the same.
static void take_both_turns(Rotor u, TurnSearch* s) {
  const Wave a = wave_of_second(s->e[0], u), b = wave_of_second(s->e[1], u);
  const double square_a = a.c * a.c + a.s * a.s, square_b = b.c * b.c + b.s * b.s;
  const Wave wave = square_a < square_b ? b : a;
  const double square = larger(square_a, square_b);
  if (!(square > tolerance_flat_wave)) return;
  const double foot = -wave.one / square, height_square = 1 / square - foot * foot;
  const double height = height_square > 0 ? sqrt(height_square) : 0;
  take_turns(u, unit_turn(rotor(foot * wave.c - height * wave.s, foot * wave.s + height * wave.c)), s);
  take_turns(u, unit_turn(rotor(foot * wave.c + height * wave.s, foot * wave.s - height * wave.c)), s);
}

static void try_turns(Rotor u, TurnSearch* s) {
  take_common_turn(u, s);
  take_both_turns(u, s);
}

/// Newton's steps within the arc, where the slope has one sign. Those on both equations do the rest.
static void take_one_root(Rotor middle, Jet at, double half, TurnSearch* s) {
  Rotor u = middle;
  double from = 0;
  for (int step = 0; step < 8; ++step) {
    double to = from - at.value / at.slope;
    if (fabs(to) > 1.01 * half) {
      if (fabs(from) == 1.01 * half) return;  // the root is outside
      to = with_sign(1.01 * half, to);
    }
    const bool is_still = fabs(to - from) < tolerance_next_to_root;
    from = to;
    u = turned_a_little(middle, from);
    if (is_still) break;
    at = jet_at(&s->f, u);
  }
  if (!take_common_turn(u, s)) take_both_turns(u, s);
}

/// Tries the places where the arc's parabola vanishes, or is nearest to zero.
static void take_close_roots(Rotor middle, Jet at, double half, TurnSearch* s) {
  const double most = 4 * half;
  const double centre = -at.slope / at.curvature, square = centre * centre - 2 * at.value / at.curvature;
  const double off = square > 0 ? sqrt(square) : 0;
  if (!(fabs(at.curvature) > 0) || fabs(centre) > most || off > most) {
    try_turns(middle, s);
    return;
  }
  try_turns(turned_a_little(middle, centre - off), s);
  if (off > 0) try_turns(turned_a_little(middle, centre + off), s);
}

/// True if the arc's parabola stays farther from zero than the polynomial from the parabola.
static bool has_no_root(Jet at, double h, const TurnSearch* s) {
  const double steep = fabs(at.slope), bend = at.value < 0 ? -at.curvature : at.curvature;
  const double farthest = (fabs(at.third) + s->fourth * h / 4) * (h * h * h / 6) + s->noise;
  const double down = steep < bend * h ? steep * steep / (2 * bend) : (steep - bend * h / 2) * h;
  return fabs(at.value) - down > farthest;
}

/// True if the slope changes by less than it is in the middle of the arc.
static bool has_one_slope(Jet at, double h, const TurnSearch* s) {
  const double bend = fabs(at.third) + s->fourth * h / 3;
  return fabs(at.slope) > (fabs(at.curvature) + bend * h / 2) * h;
}

enum { arc_depths = 9, most_arcs = 1500, half_of_arcs = 8 };

/// Cosine and sine of the middles of the first arcs from -pi to 0.
static const double first_middles[half_of_arcs][2] = {
    {-0.9807852804032304, -0.1950903220161286}, {-0.8314696123025453, -0.5555702330196022},
    {-0.555570233019602, -0.8314696123025455},  {-0.1950903220161282, -0.9807852804032304},
    {0.19509032201612833, -0.9807852804032304}, {0.5555702330196021, -0.8314696123025453},
    {0.8314696123025453, -0.5555702330196021},  {0.9807852804032304, -0.19509032201612847}};

/// Cosine and sine of a sixteenth of half a turn, of half of it, ...
static const double arc_turns[arc_depths + 1][2] = {
    {0.9807852804032304, 0.19509032201612825},   {0.9951847266721969, 0.0980171403295606},
    {0.9987954562051724, 0.049067674327418015},  {0.9996988186962042, 0.024541228522912288},
    {0.9999247018391445, 0.012271538285719925},  {0.9999811752826011, 0.006135884649154475},
    {0.9999952938095762, 0.003067956762965976},  {0.9999988234517019, 0.0015339801862847655},
    {0.9999997058628822, 0.0007669903187427045}, {0.9999999264657179, 0.00038349518757139556}};

/// Halves an arc, whose middle has the jet `at`, until it has a verdict, at most `arc_depths` times.
static void visit_arc(Rotor middle, Jet at, double half, int depth, TurnSearch* s) {
  if (++s->visits >= most_arcs) return;
  const double h = 1.0001 * half;
  if (has_no_root(at, h, s)) return;
  if (has_one_slope(at, h, s)) {
    take_one_root(middle, at, half, s);
  } else if (depth > arc_depths) {
    take_close_roots(middle, at, half, s);
  } else {
    const Rotor turn = rotor(arc_turns[depth][0], arc_turns[depth][1]);
    const Rotor left = product(middle, inverse(turn)), right = product(middle, turn);
    visit_arc(left, jet_at(&s->f, left), half / 2, depth + 1, s);
    visit_arc(right, jet_at(&s->f, right), half / 2, depth + 1, s);
  }
}

/// Visits the first arcs: those whose middles are listed, then those across the circle.
static void visit_first_arcs(TurnSearch* s) {
  Jet across[half_of_arcs];
  for (int i = 0; i < half_of_arcs; ++i) {
    Jet here;
    const Rotor middle = rotor(first_middles[i][0], first_middles[i][1]);
    jets_across(&s->f, middle, &here, &across[i]);
    visit_arc(middle, here, pi / 16, 1, s);
  }
  for (int i = 0; i < half_of_arcs; ++i)
    visit_arc(rotor(-first_middles[i][0], -first_middles[i][1]), across[i], pi / 16, 1, s);
}

/// Sets an equation with its largest coefficient one; all zeros stay.
static void set_equation(TwoTurnsEquation from, double* m) {
  const double all[9] = {from.c00, from.c01, from.c02, from.c10, from.c11, from.c12, from.c20, from.c21, from.c22};
  double largest = 0;
  for (int i = 0; i < 9; ++i)
    if (!(fabs(all[i]) < largest)) largest = fabs(all[i]);
  for (int i = 0; i < 9; ++i) m[i] = largest > 0 ? all[i] / largest : all[i];
}

/// All pairs of angles at which both equations vanish; one that is not a number where they hold along a curve.
static TurnPairs two_turns(TwoTurnsEquation one, TwoTurnsEquation other, bool at_most_six) {
  TurnSearch s;
  set_equation(one, s.e[0]);
  set_equation(other, s.e[1]);
  s.f = eliminated_turn(s.e[0], s.e[1]);
  s.fourth = fourth_bound(&s.f);
  s.noise = 32 * DBL_EPSILON * sqrt(s.fourth);
  s.most = at_most_six ? 6 : 8;
  s.visits = 0;
  s.found.count = 0;
  visit_first_arcs(&s);
  if (s.visits < most_arcs) return s.found;
  const Rotor none = rotor(NAN, NAN);
  s.found.count = 1;
  s.found.root[0].first = s.found.root[0].second = none;
  s.found.root[0].meets = true;
  return s.found;
}
