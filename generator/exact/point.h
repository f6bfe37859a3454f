// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "exact/angle.h"
#include "exact/constant_angle.h"
#include "exact/number.h"

namespace qvgen::exact {

/// A random point at which every sine and cosine is rational: each symbol has a random rational value, and, where
/// it stands in an angle, a random rational point on the unit circle for the quarter of it (the rational tangent
/// of an eighth). The two are independent, since a rational function identity in both holds for all values.
///
/// Angles that are constants other than multiples of 15 degrees are random points of the circle too.
class ExactPoint {
 public:
  explicit ExactPoint(std::uint64_t seed) : seed_(seed) {}

  Number constant(const Number& value) const { return value; }
  Number symbol(const std::string& name) const;
  Number sine(const Angle& angle) const { return turn(angle).sine; }
  Number cosine(const Angle& angle) const { return turn(angle).cosine; }
  /// Roots and arctangents have no rational value: std::domain_error, except for roots of rationals.
  Number root(const Number& value) const;
  Number arctangent(const Number& y, const Number& x) const;

 private:
  CosineSine quarter_of(const std::string& name) const;
  CosineSine turn(const Angle& angle) const;

  std::uint64_t seed_;
};

}  // namespace qvgen::exact
