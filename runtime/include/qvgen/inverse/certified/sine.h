// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/certified/interval.h>

namespace qvgen::inverse::certified {

struct SineCosine {
  Interval sine, cosine;
};

namespace sines {

/// How far the polynomials below may be from sine and cosine, with what adding it costs; u = 2^-53.
/// - Reduction: x - k pi/2 with |k| <= 41. pi/2 is first + second + a rest below 2^-66. The first two have 33
///   bits, so that their products with k are exact; two differences below 0.8 and k times the rest leave
///   less than 1.7 u. Sine and cosine pass an error of their angle on undiminished at most.
/// - Sine: r + r z q, z = r^2, |r| < 0.786. The series ends behind r^17: below 1e-19. |r z q| < 0.081, its
///   factors carry less than 8 u together: 0.65 u. The last sum is below 0.71: rounded by at most 0.5 u.
/// - Cosine: (1 - z/2) + z^2 q. Ends behind z^8: below 1e-17. z/2 < 0.31 carries 0.31 u, |z^2 q| < 0.016 with
///   its 8 u carries 0.13 u, the two sums are at most 1: 0.5 u each (below 1 their last place is half as
///   large).
/// Together below 3.3 u; moving a bound of at most 1 outward by the error rounds by at most u.
inline constexpr double error = 0x1.8p-51;  // 6 u
inline constexpr double most = 64;          // so |k| <= 41

inline constexpr double first = 0x1.921fb544p+0;
inline constexpr double second = 0x1.0b4611a6p-34;
inline constexpr double two_by_pi = 0.63661977236758134;

inline Interval enclosure(double value) {
  return {std::max(-1.0, value - error), std::min(1.0, value + error)};
}

/// Taylor's series at an angle of at most an eighth of a turn, and a little.
inline double sine_near_zero(double r) {
  const double z = r * r;
  double q = 1.0 / 355687428096000;
  q = q * z - 1.0 / 1307674368000;
  q = q * z + 1.0 / 6227020800;
  q = q * z - 1.0 / 39916800;
  q = q * z + 1.0 / 362880;
  q = q * z - 1.0 / 5040;
  q = q * z + 1.0 / 120;
  q = q * z - 1.0 / 6;
  return r + r * z * q;
}
inline double cosine_near_zero(double r) {
  const double z = r * r;
  double q = 1.0 / 20922789888000;
  q = q * z - 1.0 / 87178291200;
  q = q * z + 1.0 / 479001600;
  q = q * z - 1.0 / 3628800;
  q = q * z + 1.0 / 40320;
  q = q * z - 1.0 / 720;
  q = q * z + 1.0 / 24;
  return (1 - z / 2) + z * z * q;
}

/// The sine of an angle between two whose sines and cosines are known, less than half a turn apart. If the
/// cosines have one sign it has no zero between them: the sine is monotone. Otherwise it may pass 1 or -1,
/// whichever is on the side of the sine in the middle, which is less than a quarter of a turn from there.
inline Interval between(const Interval& at_lower, const Interval& at_upper, const Interval& slope_at_lower,
                        const Interval& slope_at_upper, const Interval& in_the_middle) {
  Interval range = hull(at_lower, at_upper);
  const bool rises = slope_at_lower.lower > 0 && slope_at_upper.lower > 0;
  const bool falls = slope_at_lower.upper < 0 && slope_at_upper.upper < 0;
  if (rises || falls) return range;
  if (!(in_the_middle.lower > 0)) range.lower = -1;
  if (!(in_the_middle.upper < 0)) range.upper = 1;
  return range;
}

}  // namespace sines

/// Encloses sine and cosine of one number. Beyond 64 rad the enclosure is [-1, 1].
inline SineCosine sine_cosine_of(double x) {
  if (x == 0) return {0.0, 1.0};
  if (!(std::abs(x) <= sines::most)) return {{-1, 1}, {-1, 1}};
  const double turns = std::floor(x * sines::two_by_pi + 0.5);
  const double r = (x - turns * sines::first) - turns * sines::second;
  const Interval s = sines::enclosure(sines::sine_near_zero(r));
  const Interval c = sines::enclosure(sines::cosine_near_zero(r));
  switch (static_cast<int>(turns) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// Encloses sine and cosine of all angles between two bounds; tight up to a width of 3 rad.
inline SineCosine sine_cosine(const Interval& x) {
  if (x.lower == x.upper) return sine_cosine_of(x.lower);
  if (!(x.width() < 3)) return {{-1, 1}, {-1, 1}};
  const SineCosine low = sine_cosine_of(x.lower), high = sine_cosine_of(x.upper);
  const SineCosine middle = sine_cosine_of(x.middle());
  return {sines::between(low.sine, high.sine, low.cosine, high.cosine, middle.sine),
          sines::between(low.cosine, high.cosine, -low.sine, -high.sine, middle.cosine)};
}

inline Interval sin(const Interval& x) { return sine_cosine(x).sine; }
inline Interval cos(const Interval& x) { return sine_cosine(x).cosine; }

}  // namespace qvgen::inverse::certified
