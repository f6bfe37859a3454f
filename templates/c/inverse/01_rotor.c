// Definitions that blocks read from headers of the C++ library need in C: a half turn, a function in the place of
// `Rotor{cosine, sine}`, whole numbers of turns. Each tolerance_NAME is the number of that name in tolerances.h; bounds of
// rounding are wider in float: single_precision.h.

static const double pi = constant_pi;

/// Cosine and sine of an angle; solved angles stay algebraic, the arctangent is taken for the output alone.
typedef struct Rotor {
  double cosine, sine;
} Rotor;

static inline Rotor rotor(double cosine, double sine) {
  const Rotor r = {cosine, sine};
  return r;
}

/// How far outside its limits a joint still counts as on them, rad or m: rounding moves a joint that stands on its
/// limit to either side. Such a joint is put on the limit itself.
static const double limit_tolerance = tolerance_on_limit;

/// The whole number next to a quotient: adding and subtracting a large number rounds.
static inline double nearest_whole(double quotient) {
  const double rounds = 1.5 / DBL_EPSILON;
  return (quotient + rounds) - rounds;
}

/// A difference of angles, rad, less the whole turns that bring it into [-pi, pi].
static inline double without_turns(double difference) {
  const double turn = constant_whole_turn;
  return difference - turn * nearest_whole(difference * (1 / turn));
}
