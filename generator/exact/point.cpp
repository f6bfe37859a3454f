// SPDX-License-Identifier: MIT
#include "exact/point.h"

#include <cmath>
#include <stdexcept>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include "exact/hash.h"
#include "exact/trigonometry.h"

namespace qvgen::exact {

namespace {

/// Non-zero rational with small numerator and denominator, so that products of many stay short.
cln::cl_RA small_rational(std::uint64_t bits) {
  const long numerator = static_cast<long>(bits % 997) - 498;
  const long denominator = static_cast<long>((bits >> 20) % 61) + 3;
  return cln::cl_RA(numerator == 0 ? 499 : numerator) / denominator;
}

}  // namespace

Number ExactPoint::symbol(const std::string& name) const {
  return small_rational(combine(seed_, hash(name)));
}

/// Between -45 and 45 degrees, and not 0, at which its sine could not be divided by.
CosineSine ExactPoint::small_turn(const std::string& name) const {
  // its half has a tangent within +-tan(pi/8)
  const std::uint64_t bits = combine(seed_, hash("tan(" + name + "/8)"));
  const long numerator = static_cast<long>(bits % 835) - 417;
  const cln::cl_RA t =
      cln::cl_RA(numerator == 0 ? 417 : numerator) / (1009 + static_cast<long>((bits >> 20) % 61));
  const cln::cl_RA n = 1 + t * t;
  return {Number((1 - t * t) / n), Number(2 * t / n)};
}

/// Four small turns cover the circle; so does a small one after a number of quarters of it.
CosineSine ExactPoint::turn_of(const std::string& name, const cln::cl_RA& coefficient) const {
  const bool whole = whole_.contains(name);
  const cln::cl_RA count = whole ? coefficient : coefficient * 4;
  if (cln::denominator(count) != 1)
    throw std::domain_error("angle of " + name + " is no multiple of " + (whole ? "the whole" : "a quarter"));
  CosineSine base = small_turn(name);
  if (whole)
    base = then(base, times({0, 1}, static_cast<long>(combine(seed_, hash("quarters of " + name)) % 4)));
  return times(base, cln::cl_I_to_long(cln::numerator(count)));
}

const CosineSine& ExactPoint::turn(const Angle& angle) const {
  const std::string key = to_string(angle);
  const auto known = turns_.find(key);
  return known != turns_.end() ? known->second : turns_.emplace(key, compute(angle)).first->second;
}

CosineSine ExactPoint::compute(const Angle& angle) const {
  CosineSine result;
  for (const auto& [name, coefficient] : angle.terms) {
    if (const auto known = constant_angle(name); known && cln::denominator(coefficient) == 1) {
      result = then(result, times(*known, cln::cl_I_to_long(cln::numerator(coefficient))));
      continue;
    }
    result = then(result, turn_of(name, coefficient));
  }
  if (const auto sine = exact_sine(angle.pi))
    return then(result, {*exact_sine(angle.pi + cln::cl_RA(1) / 2), *sine});
  const cln::float_format_t digits = cln::float_format(100);
  const cln::cl_F radians = cln::cl_float(angle.pi, digits) * cln::pi(digits);
  return then(result, {Number(cln::rational(cln::cos(radians))), Number(cln::rational(cln::sin(radians)))});
}

bool agree(const Number& a, const Number& b) {
  if (a == b) return true;
  return std::abs((a - b).to_double()) <= 1e-40 * (1 + std::abs(b.to_double()));
}

Number ExactPoint::root(const Number& value) const {
  if (!value.is_rational()) throw std::domain_error("root of an irrational number");
  return Number::root(value.rational());
}

Number ExactPoint::arctangent(const Number&, const Number&) const {
  throw std::domain_error("an arctangent has no rational value");
}

}  // namespace qvgen::exact
