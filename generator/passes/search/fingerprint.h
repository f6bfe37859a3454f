// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "dag/angle.h"
#include "exact/number.h"
#include "passes/search/field.h"

namespace qvgen::passes::search_detail {

/// Cosine and sine in the field: (u + 1/u)/2 and (u - 1/u)/(2i) with u standing for exp(i angle).
struct CosineSine {
  Field cosine, sine;
};

/// The random point at which every expression is evaluated: a ring homomorphism from expressions to the
/// field.
///
/// A symbol takes a value from its name and the seed. In sines and cosines, exp(i symbol / N) is a unit of
/// its own and exp(i pi r) a root of unity, so c^2 + s^2 = 1, double angles, angle sums and cos(pi/4) =
/// sqrt(2)/2 hold by themselves. Square roots of integers square to them.
class Fingerprint {
 public:
  explicit Fingerprint(std::uint64_t seed);
  Field symbol(const std::string& name) const;
  Field number(const exact::Number& value);
  CosineSine circular(const dag::Angle& angle) const;
  /// Value of an operation of which no law is known: the same operands give the same value, nothing else
  /// does.
  Field opaque(const char* operation, Field a, Field b) const;

 private:
  Field root(const cln::cl_I& radicand);
  Field root_without_small_factors(const cln::cl_I& radicand) const;
  Field prime_root(const cln::cl_I& number) const;

  std::uint64_t seed_;
  Field unity_, imaginary_, half_;
  std::map<cln::cl_I, Field, exact::Number::Smaller> roots_;
};

}  // namespace qvgen::passes::search_detail
