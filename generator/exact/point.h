// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "exact/angle.h"
#include "exact/constant_angle.h"
#include "exact/number.h"

namespace qvgen::exact {

/// A random point at which every sine and cosine is rational: each symbol has a random rational value, and,
/// where it stands in an angle, a random rational point on the unit circle for the quarter of it (the
/// rational tangent of an eighth). The two are independent, since a rational function identity in both holds
/// for all values.
///
/// Sine and cosine of constants other than multiples of 15 degrees have no exact value here: they are taken
/// to 100 digits, so that what holds between them (a double angle, a sum that is a right angle) still does,
/// to `agree`.
class ExactPoint {
 public:
  explicit ExactPoint(std::uint64_t seed) : seed_(seed) {}
  /// Symbols in `whole` stand in angles with whole coefficients only: the random point is that of the angle
  /// itself, a number of a quarter of the digits.
  ExactPoint(std::uint64_t seed, std::set<std::string> whole) : seed_(seed), whole_(std::move(whole)) {}

  Number constant(const Number& value) const { return value; }
  Number symbol(const std::string& name) const;
  Number sine(const Angle& angle) const { return turn(angle).sine; }
  Number cosine(const Angle& angle) const { return turn(angle).cosine; }
  /// Roots and arctangents have no rational value: std::domain_error, except for roots of rationals.
  Number root(const Number& value) const;
  Number arctangent(const Number& y, const Number& x) const;

 private:
  CosineSine small_turn(const std::string& name) const;
  CosineSine turn_of(const std::string& name, const cln::cl_RA& coefficient) const;
  const CosineSine& turn(const Angle& angle) const;
  CosineSine compute(const Angle& angle) const;

  std::uint64_t seed_;
  std::set<std::string> whole_;
  /// By the angle's text: functions ask for the same few angles again and again.
  mutable std::map<std::string, CosineSine> turns_;
};

/// True if two values at a point are equal: exactly, or to 40 digits where a constant angle was taken to 100.
bool agree(const Number& a, const Number& b);

}  // namespace qvgen::exact
