// Definitions that blocks read from headers of the C++ library need in C: a half turn, and a function in the place of
// `Rotor{cosine, sine}`. Each tolerance_NAME is the number of that name in tolerances.h; bounds of rounding are wider in
// float: single_precision.h.

static const double pi = constant_pi;

/// Cosine and sine of an angle; solved angles stay algebraic, the arctangent is taken for the output alone.
typedef struct Rotor {
  double cosine, sine;
} Rotor;

static inline Rotor rotor(double cosine, double sine) {
  const Rotor r = {cosine, sine};
  return r;
}
