// SPDX-License-Identifier: MIT
// Intervals enclose what exact arithmetic says, and tightly.
#include <random>

#include <cln/float.h>
#include <cln/rational.h>
#include <cln/real.h>
#include <gtest/gtest.h>
#include <qvgen/inverse/certified/sine.h>

namespace qvgen::inverse::certified {
namespace {

using Random = std::mt19937_64;

cln::cl_RA exact(double x) { return cln::rational(cln::cl_float(x)); }

/// With any exponent up to 2^60 either way, now and then a whole number or zero.
double number(Random& random) {
  const auto pick = random() % 8;
  if (pick == 0) return static_cast<double>(random() % 5) - 2;
  const double mantissa = std::uniform_real_distribution<double>(-1, 1)(random);
  return std::ldexp(mantissa, static_cast<int>(random() % 121) - 60);
}

Interval interval(Random& random) {
  const double a = number(random), b = random() % 3 == 0 ? a : number(random);
  return {std::min(a, b), std::max(a, b)};
}

/// One of its numbers, the ends often.
cln::cl_RA inside(const Interval& x, Random& random) {
  const cln::cl_RA share = cln::cl_RA(static_cast<long>(random() % 5)) / 4;
  return exact(x.lower) + share * (exact(x.upper) - exact(x.lower));
}

void expect_holds(const Interval& x, const cln::cl_R& value) {
  if (!x.is_finite()) return;
  EXPECT_LE(exact(x.lower), value);
  EXPECT_GE(exact(x.upper), value);
}

TEST(Bounds, EncloseSumsProductsQuotientsAndRoots) {
  Random random(1);
  for (int n = 0; n < 20000; ++n) {
    const Interval a = interval(random), b = interval(random);
    const cln::cl_RA x = inside(a, random), y = inside(b, random);
    expect_holds(a + b, x + y);
    expect_holds(a - b, x - y);
    expect_holds(a * b, x * y);
    if (!cln::zerop(y)) expect_holds(a / b, x / y);
    expect_holds(square(a), x * x);
    if (!cln::minusp(x)) expect_holds(sqrt(a), cln::sqrt(cln::cl_float(x, cln::float_format(60))));
    EXPECT_GE(square(a).lower, 0);
  }
}

TEST(Bounds, OfNumbersAreTight) {
  Random random(2);
  for (int n = 0; n < 1000; ++n) {
    const double x = number(random), y = number(random);
    for (const Interval& bounds : {Interval(x) + Interval(y), Interval(x) * Interval(y), next_to(x)})
      EXPECT_LE(bounds.width(), 2e-15 * bounds.magnitude() + 1e-280);
  }
}

TEST(Bounds, OfZeroTimesAnythingAreZero) {
  EXPECT_TRUE((Interval(0.0) * Interval(-1, 2)).is_zero());
  EXPECT_FALSE((Interval(1.0) / Interval(-1, 2)).is_finite());
}

cln::cl_F in_sixty_digits(const cln::cl_RA& x) { return cln::cl_float(x, cln::float_format(60)); }

void expect_sine_and_cosine(const Interval& x, const cln::cl_RA& at) {
  const SineCosine bounds = sine_cosine(x);
  expect_holds(bounds.sine, cln::sin(in_sixty_digits(at)));
  expect_holds(bounds.cosine, cln::cos(in_sixty_digits(at)));
}

TEST(Bounds, EncloseSinesOfNumbers) {
  Random random(3);
  std::uniform_real_distribution<double> angle(-60, 60);
  for (int n = 0; n < 5000; ++n) {
    // Next to a multiple of a quarter turn, every other time.
    double x = angle(random);
    if (n % 2 == 0)
      x = std::round(x * 0.6366197723675814) * 1.5707963267948966 + std::ldexp(1.0, -1 - n % 60);
    expect_sine_and_cosine(x, exact(x));
    EXPECT_LE(sine_cosine(x).sine.width(), 3e-15) << x;
  }
}

TEST(Bounds, EncloseSinesOfIntervals) {
  Random random(4);
  std::uniform_real_distribution<double> angle(-7, 7), width(0, 3.3);
  for (int n = 0; n < 5000; ++n) {
    const double from = angle(random);
    const Interval x(from, from + (n % 3 == 0 ? 1e-3 : 1) * width(random));
    for (int k = 0; k < 5; ++k) expect_sine_and_cosine(x, inside(x, random));
  }
}

}  // namespace
}  // namespace qvgen::inverse::certified
