// Arctangents, and pairs of a cosine and a sine, as arctangent.h of the C++ library has them: what blocks that are read
// from its headers are made of.

static const double pi = constant_pi;

/// Cosine and sine of an angle; solved angles stay algebraic, the arctangent is taken for the output alone.
typedef struct Rotor {
  double cosine, sine;
} Rotor;

static inline Rotor rotor(double cosine, double sine) {
  const Rotor r = {cosine, sine};
  return r;
}

static inline Rotor product(Rotor a, Rotor b) {
  return rotor(a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine);
}

static inline Rotor scaled(double factor, Rotor a) { return rotor(factor * a.cosine, factor * a.sine); }

static inline Rotor inverse(Rotor a) { return rotor(a.cosine, -a.sine); }

static inline double square_of(Rotor a) { return a.cosine * a.cosine + a.sine * a.sine; }

/// (atan(t)/t - 1) / t^2 in z = t^2 <= 0.2025, error below 2^-56 of atan(t)/t (minimax).
static inline double arctangent_series(double z) {
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double c01 = constant_arctangent_0 + z * constant_arctangent_1;
  const double c23 = constant_arctangent_2 + z * constant_arctangent_3;
  const double c45 = constant_arctangent_4 + z * constant_arctangent_5;
  const double c67 = constant_arctangent_6 + z * constant_arctangent_7;
  const double c89 = constant_arctangent_8 + z * constant_arctangent_9;
  const double low = c01 + z2 * c23;
  const double middle = c45 + z2 * c67;
  const double high = c89 + z2 * constant_arctangent_10;
  return low + z4 * (middle + z4 * high);
}

/// The angle of (width, height), neither negative, as base plus or minus atan(rise / run), |rise / run| <=
/// 0.45.
typedef struct Octant {
  double rise, run, base;
  bool steep;  // minus
} Octant;

static Octant octant(double height, double width) {
  Octant found;
  found.steep = height > width;
  const double low = smaller(height, width);
  const double high = larger(height, width);
  // Above atan(0.45) from pi/4 downwards.
  const bool near_diagonal = low > 0.45 * high;
  found.rise = near_diagonal ? low - high : low;
  found.run = larger(near_diagonal ? high + low : high, DBL_MIN);
  found.base = near_diagonal ? constant_eighth_turn : found.steep ? constant_quarter_turn : 0.0;
  return found;
}

/// base + atan(t), base a multiple of pi/4 without the digits that it has beyond a double. What the sum of
/// base and t loses is put back.
static inline double turned_by_arctangent(double base, double t) {
  const double z = t * t;
  const double sum = base + t;
  const double beyond = (constant_beyond_quarter_turn / constant_quarter_turn) * base;
  const double rest = ((base - sum) + t) + beyond;
  return sum + (rest + t * z * arctangent_series(z));
}

/// Returns the angle of a pair with no negative entry, in [0, pi/2], within 2 ulp.
static double acute_arctangent(double y, double x) {
  const Octant found = octant(y, x);
  return turned_by_arctangent(found.base, negated(found.steep, found.rise) / found.run);
}

/// In [-pi, pi], within 2 ulp; 0 for (0, 0).
static double arctangent(double y, double x) {
  const Octant found = octant(fabs(y), fabs(x));
  const bool back = x < 0;
  const double base = back ? constant_half_turn - found.base : found.base;
  const double rise = negated(back != found.steep, found.rise);
  return with_sign(turned_by_arctangent(base, rise / found.run), y);
}

static inline double angle_of(Rotor r) { return arctangent(r.sine, r.cosine); }

/// (atan(t)/t - 1) / t^2 in z = t^2 <= tan^2(pi/8), error below 2^-54 of atan(t)/t.
static inline double short_series(double z) {
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double c01 = constant_short_arctangent_0 + z * constant_short_arctangent_1;
  const double c23 = constant_short_arctangent_2 + z * constant_short_arctangent_3;
  const double c45 = constant_short_arctangent_4 + z * constant_short_arctangent_5;
  const double c67 = constant_short_arctangent_6 + z * constant_short_arctangent_7;
  const double c89 = constant_short_arctangent_8 + z * constant_short_arctangent_9;
  return ((c01 + z2 * c23) + (z4 * z4) * c89) + z4 * (c45 + z2 * c67);
}

/// The arctangent of a pair of known length: `axis` and twice the arctangent of t, |t| <= tan(pi/8), with the
/// signs that are to be, and what that is short of.
typedef struct Tangent {
  double axis, twice, rest;
} Tangent;

static inline Tangent tangent(double y, double x, double length) {
  const double height = fabs(y);
  const double width = fabs(x);
  const double steep = width - height;  // by its sign
  const double axis = signbit(steep) ? constant_quarter_turn : signbit(x) ? constant_half_turn : 0.0;
  const double t = smaller(height, width) / (length + larger(height, width));
  const double z = t * t;
  Tangent found;
  found.axis = copysign(axis, y);
  found.twice = flipped(t + t, flipped(flipped(x, y), steep));
  found.rest = found.twice * z * short_series(z);
  return found;
}

static inline double arctangent_of_length(double y, double x, double length) {
  const Tangent found = tangent(y, x, length);
  return (found.axis + found.twice) + found.rest;
}

/// Angle in (-pi, pi], rad, of a pair of the given length: -pi, which a negative zero or a rounded sine would
/// give, is pi.
static inline double output_angle(double cosine, double sine, double length) {
  const double value = arctangent_of_length(sine, cosine, length);
  return value <= -pi ? pi : value;
}

/// An angle and the one of the opposite direction.
typedef struct Opposites {
  double one, other;
} Opposites;

static inline Opposites opposite_arctangents(double y, double x, double length) {
  const Tangent found = tangent(y, x, length);
  const Opposites both = {(found.axis + found.twice) + found.rest,
                          ((found.axis - copysign(pi, y)) + found.twice) + found.rest};
  return both;
}

/// A difference of angles, rad, less the whole turns that bring it into [-pi, pi].
static inline double without_turns(double difference) {
  const double turn = constant_whole_turn;
  const double rounds = 1.5 / DBL_EPSILON;
  return difference - turn * ((difference * (1 / turn) + rounds) - rounds);
}
