// The three angles of a wrist: wrist.h of the C++ library.

/// The three angles of a spherical wrist.
typedef struct WristAngles {
  double first, middle, last;
} WristAngles;

/// Below this share of the whole length of U11 and U12 an argument is noise: the angle is free.
static const double wrist_noise = 18 * DBL_EPSILON;

/// Largest noise of a wrist behind an ill-conditioned arm, as a multiple of its square.
static const double widest_wrist_noise = 1024;

/// Which of two complex numbers, given by their squares, is noise next to the other.
typedef struct Vanishing {
  bool u, v;
  double noise;  // square below which it is
} Vanishing;

static inline Vanishing vanishing(double u_square, double v_square) {
  Vanishing is_free;
  is_free.noise = wrist_noise * wrist_noise * (u_square + v_square);
  is_free.u = u_square <= is_free.noise;
  is_free.v = v_square <= is_free.noise;
  return is_free;
}

/// Says which vectors vanish at a wrist before further joints. If one is nearly free, the further joints decide the
/// angles.
static Vanishing vanishing_before_joints(double u_square, double v_square, const Boundary* boundary,
                                         Branch* branch) {
  Vanishing is_free = vanishing(u_square, v_square);
  const double little = boundary->near * is_free.noise;
  const double choosable = branch->unsure || boundary->wide ? tolerance_choosable_behind_double_root : tolerance_choosable;
  const double doubtful = boundary->wide ? little : choosable * is_free.noise;
  branch->unsure = branch->unsure || u_square <= little || v_square <= little;
  doubt(branch, u_square <= doubtful || v_square <= doubtful);
  branch->continuum = branch->continuum || (branch->exists && (is_free.u || is_free.v));
  const double least = boundary->choose ? choosable * is_free.noise : is_free.noise;
  is_free.u = u_square <= least;
  is_free.v = v_square <= least;
  return is_free;
}

/// How far the argument of the smaller number, whose square is `least`, is to be turned: next to where it is
/// free the first angle comes as near to the choice as rounding allows, or to the opposite direction. Zero
/// elsewhere.
static double turn_to_choice(double first, double choice, double least, double noise) {
  if (!is_blurred(least, noise)) return 0;
  const double quarter = 0.5 * pi;
  const double most = quarter * sqrt(widest_wrist_noise * noise / larger(least, noise));
  const double off = wrapped(choice - first);
  const double nearer = off + (off > quarter ? -pi : off <= -quarter ? pi : 0);
  return clamped(nearer, -most, most);
}

/// A wrist's two branches: (first, middle, last) and (first + pi, -middle, last + pi).
typedef struct WristBranches {
  WristAngles one, other;
} WristBranches;

static inline WristBranches wrist_branches(Opposites first, double middle, Opposites last) {
  const WristBranches both = {{first.one, middle, last.one},
                              {first.other, middle >= pi ? pi : -middle, last.other}};
  return both;
}

/// Sets the branches where u or v vanishes: the first angle is the choice, the last follows from the other number, the
/// middle angle is 0 or pi.
static WristBranches aligned_wrist(WristBranches regular, Rotor u, Rotor v, Vanishing is_free, bool swapped,
                                   double choice) {
  if (!is_free.u && !is_free.v) return regular;
  const double rest = 2 * (is_free.u ? arctangent(v.sine, v.cosine) : arctangent(u.sine, u.cosine)) - choice;
  Opposites first, last;
  first.one = wrapped(choice);
  first.other = opposite(first.one);
  last.one = wrapped(is_free.u ? -rest : rest);
  last.other = opposite(last.one);
  return wrist_branches(first, (swapped ? is_free.u : is_free.v) ? 0 : pi, last);
}

/// The argument of u, or else of v, turned.
static WristBranches turned_wrist(WristBranches regular, double turn, bool is_u) {
  if (turn == 0) return regular;
  Opposites first, last;
  first.one = wrapped(regular.one.first + turn);
  first.other = opposite(first.one);
  last.one = wrapped(regular.one.last + (is_u ? turn : -turn));
  last.other = opposite(last.one);
  return wrist_branches(first, regular.one.middle, last);
}

/// Wrist with right angles between neighbouring axes. u, v: the entries of the wrist's SU(2) matrix, of any
/// length, turned so that first = arg u + arg v, last = arg u - arg v and middle = 2 atan2(|v|, |u|), in [0,
/// pi] (with `swapped` the other way round).
static WristBranches right_wrist(Rotor u, Rotor v, bool swapped, double seed, Branch* branch) {
  const double u_square = square_of(u);
  const double v_square = square_of(v);
  // |u v|, of which all three angles' tangents are made: sums of arguments are the arguments of products.
  const double length = sqrt(u_square * v_square);
  const double gap = swapped ? v_square - u_square : u_square - v_square;
  const double sum = u_square + v_square;
  const double cc = u.cosine * v.cosine;
  const double ss = u.sine * v.sine;
  const double cs = u.cosine * v.sine;
  const double sc = u.sine * v.cosine;
  const Opposites first = output_angles(cc - ss, sc + cs, length);
  const Opposites last = output_angles(cc + ss, sc - cs, length);
  const double middle = arctangent_of_length(length, 0.5 * gap, 0.5 * sum);
  const WristBranches regular = wrist_branches(first, middle, last);
  const Vanishing is_free = vanishing(u_square, v_square);
  const double least = smaller(u_square, v_square);
  branch->unsure = branch->unsure || least <= tolerance_nearly_free * is_free.noise;
  if (!is_blurred(least, is_free.noise)) return regular;
  branch->continuum = branch->continuum || (branch->exists && least <= widest_wrist_noise * is_free.noise);
  const double turn = turn_to_choice(regular.one.first, seed, least, is_free.noise);
  return aligned_wrist(turned_wrist(regular, turn, u_square < v_square), u, v, is_free, swapped, seed);
}

/// A wrist's angles as cosines and sines, for arms that go on from there.
typedef struct WristTurns {
  Rotor first, middle, last;
} WristTurns;

/// The directions of the two numbers. One of them vanishes at most: what it leaves free makes the first angle
/// the choice.
static void turns(Rotor u, Rotor v, Vanishing is_free, Rotor choice, Rotor* along_u, Rotor* along_v) {
  const Rotor unit_u = scaled(1 / sqrt(is_free.u ? 1 : square_of(u)), u);
  const Rotor unit_v = scaled(1 / sqrt(is_free.v ? 1 : square_of(v)), v);
  *along_u = is_free.u ? product(choice, inverse(unit_v)) : unit_u;
  *along_v = is_free.v ? product(choice, inverse(unit_u)) : unit_v;
}

/// Both branches of `right_wrist`, by sign, without any arctangent.
static WristTurns right_wrist_turns(Rotor u, Rotor v, bool swapped, Rotor choice, double sign,
                                    const Boundary* boundary, Branch* branch) {
  const double u_square = square_of(u);
  const double v_square = square_of(v);
  const double sum = u_square + v_square;
  const Vanishing is_free = vanishing_before_joints(u_square, v_square, boundary, branch);
  const double both = is_free.u || is_free.v ? 0 : 2 * sqrt(u_square * v_square);
  const double gap = swapped ? v_square - u_square : u_square - v_square;
  Rotor along_u, along_v;
  turns(u, v, is_free, choice, &along_u, &along_v);
  const double scale = 1 / sum;
  WristTurns found;
  found.first = scaled(sign, product(along_u, along_v));
  found.middle = rotor(gap * scale, sign * both * scale);
  found.last = scaled(sign, product(along_u, inverse(along_v)));
  return found;
}

/// Constants of a wrist with any angles a, a' between its axes: cosine and sine of (a+a')/2 and (a-a')/2, sin
/// a sin a'.
typedef struct WristShape {
  double cosine_sum, sine_sum, cosine_difference, sine_difference, product;
} WristShape;

/// Squares of sine and cosine of half the middle angle of a wrist with oblique axes.
typedef struct ObliqueSquares {
  double u11, u12;
  double sine, cosine;
  bool right_sum,
      right_difference;  // then sine or cosine vanishes where an angle is free, else at a double root
} ObliqueSquares;

static ObliqueSquares oblique_squares(Rotor first, Rotor second, const WristShape* shape) {
  ObliqueSquares square;
  square.u11 = square_of(first);
  square.u12 = square_of(second);
  square.sine = (square.u11 - shape->cosine_sum * shape->cosine_sum) / shape->product;
  square.cosine = (square.u12 - shape->sine_difference * shape->sine_difference) / shape->product;
  square.right_sum = shape->cosine_sum == 0;
  square.right_difference = shape->sine_difference == 0;
  return square;
}

/// Two complex numbers from sine and cosine of half the middle angle: first = arg z1 + arg z2, last = arg z1
/// - arg z2.
static void oblique_products(Rotor u11, Rotor u12, const WristShape* shape, const ObliqueSquares* square,
                             double s, double c, double sign, Rotor* one, Rotor* two) {
  const double m11_real = shape->cosine_sum * c;
  const double m11_imaginary = -sign * (square->right_sum ? 1 : shape->cosine_difference * s);
  const double m12_real = -sign * (shape->sine_difference * s);
  const double m12_imaginary = -(square->right_difference ? 1 : shape->sine_sum * c);
  *one = product(rotor(m11_real, m11_imaginary), inverse(u11));
  *two = product(rotor(m12_real, m12_imaginary), inverse(u12));
}

/// Arguments of the two complex numbers; one that vanishes gets what makes their sum equal to `first`.
static void arguments(Rotor u, Rotor v, double u_square, double v_square, Vanishing is_free, double first,
                      double* u_argument, double* v_argument, Branch* branch) {
  const double u_angle = angle_of(u);
  const double v_angle = angle_of(v);
  *u_argument = is_free.u ? first - v_angle : u_angle;
  *v_argument = is_free.v ? first - u_angle : v_angle;
  const double least = smaller(u_square, v_square);
  branch->unsure = branch->unsure || least <= tolerance_nearly_free * is_free.noise;
  if (!is_blurred(least, is_free.noise)) return;
  const double turn =
      is_free.u || is_free.v ? 0 : turn_to_choice(wrapped(u_angle + v_angle), first, least, is_free.noise);
  if (u_square < v_square)
    *u_argument += turn;
  else
    *v_argument += turn;
  branch->continuum = branch->continuum || (branch->exists && least <= widest_wrist_noise * is_free.noise);
}

/// Beyond the end of its range by less than the boundary's `fold` it is folded; by less than `beyond`
/// doubtful.
static WristAngles oblique_wrist(Rotor u11, Rotor u12, WristShape shape, double sign, double seed,
                                 const Boundary* boundary, Branch* branch) {
  // Two roots closer than this share of their range are one double root.
  const double merge_share = 18 * DBL_EPSILON;
  const ObliqueSquares square = oblique_squares(u11, u12, &shape);
  const Vanishing is_free = vanishing(square.u11, square.u12);
  const double margin = smaller(square.sine, square.cosine);
  const bool sine_twin = (square.sine <= merge_share && !square.right_sum) || is_free.u;
  const bool cosine_twin = (square.cosine <= merge_share && !square.right_difference) || is_free.v;
  const bool is_near = margin >= -boundary->fold;
  doubt(branch, !is_near && margin > -boundary->beyond);
  branch->exists = branch->exists && is_near && !((sine_twin || cosine_twin) && sign < 0);
  const double s = sine_twin ? 0 : sqrt(not_negative(square.sine));
  const double c = cosine_twin ? 0 : sqrt(not_negative(square.cosine));
  Rotor one, two;
  oblique_products(u11, u12, &shape, &square, s, c, sign, &one, &two);
  double a, b;
  arguments(one, two, square.u11, square.u12, is_free, seed, &a, &b, branch);
  const WristAngles found = {wrapped(a + b), 2 * sign * acute_arctangent(s, c), wrapped(a - b)};
  return found;
}

/// Returns the angles of an oblique wrist as cosines and sines, `delta` the angle between the normals.
static WristTurns oblique_wrist_turns(Rotor u11, Rotor u12, WristShape shape, Rotor delta, Rotor choice,
                                      double sign, const Boundary* boundary, Branch* branch) {
  const ObliqueSquares square = oblique_squares(u11, u12, &shape);
  const Vanishing is_free = vanishing_before_joints(square.u11, square.u12, boundary, branch);
  const double margin =
      smaller(square.right_sum ? 1 : square.sine, square.right_difference ? 1 : square.cosine);
  const Limits limits = limits_of(boundary);
  admit(margin, &limits, false, branch);
  const double s = is_free.u ? 0 : sqrt(larger(square.sine, square.right_sum ? 0 : boundary->floor));
  const double c = is_free.v ? 0 : sqrt(larger(square.cosine, square.right_difference ? 0 : boundary->floor));
  Rotor one, two, along_1, along_2;
  oblique_products(u11, u12, &shape, &square, s, c, sign, &one, &two);
  turns(one, two, is_free, choice, &along_1, &along_2);
  const double scale = 1 / (c * c + s * s);
  const Rotor middle = rotor((c - s) * (c + s) * scale, sign * (2 * c * s * scale));
  WristTurns found;
  found.first = product(along_1, along_2);
  found.middle = product(middle, inverse(delta));
  found.last = product(along_1, inverse(along_2));
  return found;
}
