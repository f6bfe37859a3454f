// Angles of one equation, and what ends of ranges and free directions do: roots.h of the C++ library.

/// A boundary in the units of an equation's range, what is outside negative.
typedef struct Limits {
  double doubt, beyond, accept, unsure;
  bool wide;
} Limits;

static inline Limits limits_of(const Boundary* boundary) {
  const Limits limits = {boundary->doubt, -boundary->beyond, -boundary->accept, boundary->unsure,
                         boundary->wide};
  return limits;
}

static inline Limits limits_in_range(const Boundary* boundary, double range) {
  Limits limits = limits_of(boundary);
  limits.doubt = boundary->doubt * range;
  limits.beyond = -boundary->beyond * range;
  limits.accept = -boundary->accept * range;
  limits.unsure = boundary->doubt > 0 ? limits.doubt : boundary->unsure * range;
  return limits;
}

/// True if a branch exists that is `margin` from the end of a range.
static inline void admit(double margin, const Limits* limits, bool nearly_free, Branch* branch) {
  const bool close = margin < limits->doubt && margin > limits->beyond;
  doubt(branch, close || (limits->wide && nearly_free));
  branch->unsure = branch->unsure || margin < limits->unsure || nearly_free;
  branch->exists = branch->exists && (margin >= limits->accept || nearly_free);
}

static inline Rotor circle_from(double low, double high, double scale, double sign, const Boundary* boundary,
                                bool nearly_free, Branch* branch) {
  const double sine2 = low * scale;
  const double cosine2 = high * scale;
  const double least = boundary->floor;
  const Limits limits = limits_of(boundary);
  admit(smaller(sine2, cosine2), &limits, nearly_free, branch);
  const double height = sqrt(larger(low * high, least == 0 ? least : least / (scale * scale)));
  return rotor(larger(cosine2, least) - larger(sine2, least), (2 * sign * fabs(scale)) * height);
}

/// cos phi = (high - low) / (high + low), the two angles +-phi at which a line or circle meets a circle;
/// scale = 1 / (low + high).
static inline Rotor circle_angle(double low, double high, double scale, double sign, const Boundary* boundary,
                                 Branch* branch) {
  return circle_from(low, high, scale, sign, boundary, false, branch);
}

/// True if a direction of the given square is nearly free, or the nearer end of its range so near that earlier
/// equations may have moved it across.
static inline bool nearly_free(double square, double low, double high, double tiny,
                               const Boundary* boundary) {
  const double end = smaller(fabs(low), fabs(high));
  return square <= boundary->near * tiny || end * end <= tolerance_magnified_end * tiny;
}

/// The angle +-phi from a direction that the pose gives, low and high as for `circle_angle`. Where the
/// direction's squared length is below `tiny` the angle is free if high - low is as small.
static inline Rotor free_circle_angle(double low, double high, Rotor from, double tiny, Rotor choice,
                                      double sign, const Boundary* boundary, Branch* branch) {
  const double square = square_of(from);
  const double gap = high - low;
  const bool is_free = square <= tiny;
  Branch regular = *branch;
  const Rotor turn = circle_from(low, high, 1 / (low + high), sign, boundary,
                                 nearly_free(square, low, high, tiny, boundary), &regular);
  take(branch, is_free, gap * gap <= boundary->gap * tiny, &regular);
  if (is_free) return scaled(sign, choice);
  return product(turn, scaled(1 / sqrt(square), from));
}

/// The angle +-phi from a direction v that the pose gives, with v.u = rhs for the unit vector u; |v|^2 -
/// rhs^2 is known as the product low * high.
static Rotor factored_line_angle(Rotor v, double rhs, double low, double high, double tiny, Rotor choice,
                                 double sign, const Boundary* boundary, Branch* branch) {
  const double square = square_of(v);
  const bool is_free = square <= tiny;
  const double range = low + high;
  const double scale = 1 / range;
  const double low_share = low * scale;
  const double high_share = high * scale;
  const Limits limits = limits_of(boundary);
  Branch regular = *branch;
  admit(smaller(low_share, high_share), &limits, nearly_free(square, low, high, tiny, boundary), &regular);
  take(branch, is_free, rhs * rhs <= boundary->gap * tiny, &regular);
  if (is_free) return scaled(sign, choice);
  const double height =
      sign * fabs(range) * sqrt(larger(low_share, boundary->floor) * larger(high_share, boundary->floor));
  const double length_square = rhs * rhs + height * height;
  // If all three vanish but for rounding, Newton's steps may begin with any direction.
  if (length_square == 0) return scaled(1 / sqrt(square), v);
  const double unit = 1 / (sqrt(length_square) * sqrt(square));
  return product(rotor(rhs * unit, height * unit), v);
}

/// Returns `choice`, or a direction near it, among the directions u with inner <= |point + u offset|^2 <= outer: what a
/// free angle may be if the joints after it are to stay in reach. Such directions are one range or two, mirror images.
static Rotor reachable_direction(Rotor point, Rotor offset, double inner, double outer, Rotor choice,
                                 const Boundary* boundary) {
  const Rotor both = product(inverse(point), offset);
  const double square = square_of(both);
  if (square == 0) return choice;
  const double length = sqrt(square);
  const Rotor along = rotor(both.cosine / length, both.sine / length);
  const Rotor now = product(choice, along);
  const double sum = point.cosine * point.cosine + point.sine * point.sine + offset.cosine * offset.cosine +
                     offset.sine * offset.sine;
  const double least = (inner - sum) / (2 * length), most = (outer - sum) / (2 * length);
  const double low = larger(least, -1);
  const double high = smaller(most, 1);
  const bool crosses = boundary->opposite && least > -1 && most < 1;
  const double inside = not_negative(high - low) / 16;
  const double above = now.cosine < low ? low + inside : now.cosine;
  const double cosine = clamped(above > high ? high - inside : above, -1, 1);
  if (cosine == now.cosine && !crosses) return choice;
  const double side = crosses ? -now.sine : now.sine;
  const Rotor moved = rotor(cosine, with_sign(sqrt(not_negative((1 - cosine) * (1 + cosine))), side));
  return product(moved, inverse(along));
}

/// The direction of v, a product of two vectors that are at most unit vectors and vanish together: then it is
/// free.
static Rotor chosen_direction(Rotor v, Rotor choice, const Boundary* boundary, Branch* branch) {
  const double noise = 16 * DBL_EPSILON;
  const double little = tolerance_product_at_double_root;
  doubt(branch, square_of(v) <= little);
  return direction(false, v, boundary->choose ? little : noise * noise * noise * noise, choice, branch);
}

/// Noise in v, a product of two vectors that vanish together where an equation before has a double root; `tiny`: the
/// fourth power of what is noise for sure.
static inline double tiny_at_double_root(Rotor v, double tiny, const Boundary* boundary, Branch* branch) {
  const double little = tolerance_noise_at_double_root * tiny;
  doubt(branch, square_of(v) <= little);
  return boundary->choose ? little : tiny;
}

/// +-sqrt(square), where `square` = r^2 - m^2 may be negative by rounding, `scale` = m^2 telling how much
/// that is.
static inline double signed_root(double square, double scale, double tiny, double sign,
                                 const Boundary* boundary, Branch* branch) {
  const bool close = fabs(square) <= boundary->near * tiny;
  const Limits limits = limits_in_range(boundary, larger(scale, fabs(square)));
  admit(square, &limits, close, branch);
  return sign * sqrt(larger(square, boundary->floor * (scale + tiny)));
}

/// An equation that the pose must satisfy for the arm to reach it at all (a planar arm's plane, say).
static inline void require_zero(double residual, double scale, double tolerance, Branch* branch) {
  branch->exists = branch->exists && residual <= tolerance * scale && residual >= -tolerance * scale;
}

/// True if a `circle_angle` that comes before all other branches, or behind one of two signs, has no solution whatever
/// the sign: its share low / (low + high) is `middle` +- sqrt(`swing`). Told without a root.
static inline bool is_out_of_range(double middle, double swing, const Boundary* boundary) {
  const double off = fabs(middle - 0.5);
  const double to_end = 0.5 + boundary->beyond;
  const double same_end = off - to_end;
  const double both_ends = off + to_end;
  return (same_end > 0 && same_end * same_end > swing) || both_ends * both_ends < swing;
}
