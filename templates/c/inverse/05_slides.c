// Lengths of slides: slides.h of the C++ library.

/// A part of a unit vector whose square is below this has no direction.
static inline double blind_square(const Boundary* boundary) {
  const double noise = tolerance_noise * DBL_EPSILON;
  return boundary->choose ? tolerance_product_at_double_root : noise * noise;
}

/// A part of a unit vector of the given square may cost digits that matter.
static inline void doubt_digits(double square, const Boundary* boundary, Branch* branch) {
  doubt(branch, square <= (boundary->doubt > 0 ? tolerance_two_digits : tolerance_product_at_double_root));
  branch->unsure = branch->unsure || square <= tolerance_two_digits;
}

/// Chord of the line point + t along in a circle about the origin: t = foot +- half, half = 0 if it does not.
typedef struct Chord {
  bool is_point;  // along = 0
  double foot, half;
} Chord;

static Chord chord(Rotor point, Rotor along, double square) {
  const double speed = square_of(along);
  Chord found;
  found.is_point = speed == 0;
  const double divisor = found.is_point ? 1 : speed;
  const double across = point.cosine * along.sine - point.sine * along.cosine;
  found.foot = -(point.cosine * along.cosine + point.sine * along.sine) / divisor;
  found.half = sqrt(not_negative((square - across * across / divisor) / divisor));
  return found;
}

/// A free slide t with inner <= |point + t along|^2 <= outer, so that the joints after it stay in reach:
/// nearest to `value`, or, if `spread` is turned, that share of the way from the foot of the perpendicular.
static double slide_between(Rotor point, Rotor along, double inner, double outer, double value,
                            Rotor spread) {
  const Chord inside = chord(point, along, inner);
  const double most = chord(point, along, outer).half;
  const double shared = inside.half + fabs(spread.cosine) * (most - inside.half);
  const double wanted = value - inside.foot;
  const double closest = clamped(fabs(wanted), inside.half, most);
  const bool is_spread = spread.sine != 0;
  const double off = with_sign(is_spread ? shared : closest, is_spread ? spread.cosine : wanted);
  return inside.is_point ? value : inside.foot + off;
}

/// Returns a place of the slide without an outer end: the turned `spread` is the direction of the slide as seen from
/// beside its foot.
static double slide_beyond(Rotor point, Rotor along, double inner, double size_square, double value,
                           Rotor spread) {
  const Chord inside = chord(point, along, inner);
  const bool is_spread = spread.sine != 0;
  const double shared = sqrt(size_square) * (spread.cosine / (is_spread ? spread.sine : 1));
  const double wanted = is_spread ? shared : value - inside.foot;
  const double off = with_sign(larger(fabs(wanted), inside.half), wanted);
  return inside.is_point ? value : inside.foot + off;
}

/// t with t along = rhs in a plane. Where the pose makes `along` vanish t is free if rhs vanishes too: then
/// it is the choice; where `along` is so small that rounding decides about t, it is as near to the choice as
/// the equation lets it.
static double slide_on_line(Rotor along, Rotor rhs, double tiny, double choice, const Boundary* boundary,
                            Branch* branch) {
  const double square = square_of(along);
  const double gap = square_of(rhs);
  const bool is_free = square <= blind_square(boundary);
  const bool is_loose = square <= tolerance_loose_slide;
  Branch regular = *branch;
  doubt_digits(square, boundary, &regular);
  take(branch, is_free, gap <= boundary->gap * tiny, &regular);
  branch->continuum = branch->continuum || (branch->exists && is_loose);
  if (is_free) return choice;
  const double middle = (along.cosine * rhs.cosine + along.sine * rhs.sine) / square;
  const double width = is_loose ? sqrt(tiny / square) : 0;
  return clamped(choice, middle - width, middle + width);
}

/// t with t along + s other = rhs in a plane, s the value of another slide, to be found later. Where the pose
/// makes `other` vanish both components are for t.
static double slide_beside(Rotor along, Rotor other, Rotor rhs, double tiny, double choice,
                           const Boundary* boundary, Branch* branch) {
  const double square = square_of(other);
  const bool is_alone = square <= blind_square(boundary);
  doubt_digits(square, boundary, branch);
  if (is_alone) return slide_on_line(along, rhs, tiny, choice, boundary, branch);
  const double scale = 1.0 / sqrt(square);
  const Rotor across_along = {(along.cosine * other.sine - along.sine * other.cosine) * scale, 0.0};
  const Rotor across_rhs = {(rhs.cosine * other.sine - rhs.sine * other.cosine) * scale, 0.0};
  return slide_on_line(across_along, across_rhs, tiny, choice, boundary, branch);
}

/// The root t of a t^2 + 2 b t + c = 0, a length, at which a t + b has the sign given. Where a vanishes one
/// root lies at infinity: there is no such branch. For sign 0 it is the root nearer to 0.
static double quadratic_root(double a, double b, double c, double tiny, double size_square, double sign,
                             const Boundary* boundary, Branch* branch) {
  const double scale = b * b + fabs(a * c);
  const double discriminant = b * b - a * c;
  const double noise = tolerance_noisy_discriminant * tiny * (b * b + a * a * size_square);
  const Limits limits = limits_in_range(boundary, scale);
  admit(discriminant, &limits, discriminant * discriminant <= noise, branch);
  const double root = sqrt(larger(discriminant, boundary->floor * scale));
  // Both summands have one sign.
  const double sum = b + with_sign(root, b);
  const bool wants_large = with_sign(sign, b) < 0;
  doubt_digits(a * a, boundary, branch);
  branch->exists = branch->exists && !(wants_large && a * a <= blind_square(boundary));
  const double divisor = wants_large ? a : sum;
  return divisor == 0 ? 0 : -(wants_large ? sum : c) / divisor;
}

/// Two slides (s, t) that an equation binds and a quadratic one: a s - b t = k, s^2 + 2 g s - t^2 - 2 f t +
/// gap = 0, (a, b) parts of unit vectors. Where both vanish one is free, if k vanishes too: s is what is
/// chosen, as far as t can follow.
static Rotor two_slides(Rotor ab, double k, Rotor gf, double gap, double tiny, double size_square,
                        double choice, Rotor spread, double sign, const Boundary* boundary, Branch* branch) {
  const double g = gf.cosine;
  const double f = gf.sine;
  const double square = square_of(ab);
  const bool is_free = square <= blind_square(boundary);
  const double scale = 1 / sqrt(is_free ? 1 : square);
  // The line of the first equation: its foot from (0, 0) and its direction.
  const double inner = g * g - gap - f * f;
  const double foot =
      is_free ? slide_beyond(rotor(g, 0), rotor(1, 0), inner, size_square, choice, spread) : k * scale;
  const Rotor normal = is_free ? rotor(1, 0) : rotor(ab.cosine * scale, -ab.sine * scale);
  const Rotor along = rotor(-normal.sine, normal.cosine);
  Branch regular = *branch;
  doubt_digits(square, boundary, &regular);
  take(branch, is_free, k * k <= boundary->gap * tiny, &regular);
  const double by = quadratic_root(
      along.cosine * along.cosine - along.sine * along.sine,
      foot * (normal.cosine * along.cosine - normal.sine * along.sine) + g * along.cosine - f * along.sine,
      foot * foot * (normal.cosine * normal.cosine - normal.sine * normal.sine) +
          2 * foot * (g * normal.cosine - f * normal.sine) + gap,
      tiny, size_square, sign, boundary, branch);
  return rotor(foot * normal.cosine + by * along.cosine, foot * normal.sine + by * along.sine);
}
