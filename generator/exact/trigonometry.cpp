// SPDX-License-Identifier: MIT
#include "exact/trigonometry.h"

#include <array>

#include <cln/integer.h>

namespace qvgen::exact {

namespace {

/// sin(k * 15 degrees), k = 0 .. 6.
Number sine_of_fifteenths(long k) {
  const auto half_root = [](long n) { return Number::root(cln::cl_RA(n) / 4); };
  const auto quarter_root = [](long n) { return Number::root(cln::cl_RA(n) / 16); };
  switch (k) {
    case 0:
      return 0;
    case 1:
      return quarter_root(6) - quarter_root(2);
    case 2:
      return Number(cln::cl_RA(1) / 2);
    case 3:
      return half_root(2);
    case 4:
      return half_root(3);
    case 5:
      return quarter_root(6) + quarter_root(2);
    default:
      return 1;
  }
}

struct Reduced {
  bool mirrored;  ///< the angle's sign was changed
  long quarter;   ///< quarter turns taken out, 0 .. 3
  Angle rest;     ///< angle = (mirrored ? -1 : 1) * (rest + quarter * pi/2), canonical
};

Reduced reduce(const Angle& angle) {
  Angle rest = angle;
  bool mirrored = !rest.terms.empty() && cln::minusp(rest.terms.begin()->second);
  if (mirrored) rest = cln::cl_RA(-1) * rest;
  const cln::cl_I quarters = cln::round1(rest.pi * 2);
  rest.pi = rest.pi - cln::cl_RA(quarters) / 2;
  return {mirrored, cln::cl_I_to_long(cln::mod(quarters, 4)), rest};
}

/// sin (or cos) of the reduced angle.
TrigonometricValue value_of(bool is_sine, const Reduced& reduced) {
  // sin(x + k pi/2) = sin, cos, -sin, -cos; cos(x + k pi/2) = cos, -sin, -cos, sin
  const long phase = (reduced.quarter + (is_sine ? 0 : 1)) % 4;
  TrigonometricValue value{phase >= 2, phase % 2 == 0, reduced.rest, std::nullopt};
  if (is_sine && reduced.mirrored) value.negative = !value.negative;
  if (!value.angle.terms.empty()) return value;
  if (cln::minusp(value.angle.pi)) {
    value.angle.pi = -value.angle.pi;
    if (value.is_sine) value.negative = !value.negative;
  }
  value.number = exact_sine(value.is_sine ? value.angle.pi : cln::cl_RA(1) / 2 - value.angle.pi);
  return value;
}

}  // namespace

std::optional<Number> exact_sine(const cln::cl_RA& turns) {
  const cln::cl_RA steps = turns * 12;
  if (cln::denominator(steps) != 1) return std::nullopt;
  const long k = cln::cl_I_to_long(cln::mod(cln::numerator(steps), 24));
  const long half = k % 12;
  const Number size = sine_of_fifteenths(half <= 6 ? half : 12 - half);
  return k < 12 ? size : -size;
}

TrigonometricValue normalised_sine(const Angle& angle) { return value_of(true, reduce(angle)); }
TrigonometricValue normalised_cosine(const Angle& angle) { return value_of(false, reduce(angle)); }

}  // namespace qvgen::exact
