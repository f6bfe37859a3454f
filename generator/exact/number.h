// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>

namespace qvgen::exact {

/// Exact real number of a multi-quadratic field: sum of r_d * sqrt(d) over squarefree integers d >= 1.
///
/// Closed under + - * /, so that right angles, 30, 45 and 60 degree twists (and their half angles'
/// sines) are computed with tolerance zero. Immutable value with a canonical form: equal numbers are ==.
class Number {
 public:
  /// Squarefree radicand -> rational coefficient, no zero coefficients; radicand 1 is the rational part. A
  /// product's radicand may be as long as those of its factors together.
  struct Smaller {
    bool operator()(const cln::cl_I& a, const cln::cl_I& b) const { return a < b; }
  };
  using Terms = std::map<cln::cl_I, cln::cl_RA, Smaller>;

  Number() = default;
  Number(long value) : Number(cln::cl_RA(value)) {}  // NOLINT(google-explicit-constructor)
  Number(const cln::cl_RA& value);                   // NOLINT(google-explicit-constructor)
  /// Exact square root of a rational >= 0 whose squarefree part fits 62 bits; throws std::domain_error
  /// otherwise.
  static Number root(const cln::cl_RA& radicand);

  [[nodiscard]] bool is_zero() const { return terms_.empty(); }
  [[nodiscard]] bool is_one() const;
  [[nodiscard]] bool is_rational() const;
  /// The rational part (the whole value if is_rational()).
  [[nodiscard]] cln::cl_RA rational() const;
  [[nodiscard]] int sign() const;
  [[nodiscard]] double to_double() const;
  [[nodiscard]] const Terms& terms() const { return terms_; }
  [[nodiscard]] Number inverse() const;  ///< throws std::domain_error for zero

  friend Number operator+(const Number& a, const Number& b);
  friend Number operator-(const Number& a, const Number& b);
  friend Number operator*(const Number& a, const Number& b);
  friend Number operator/(const Number& a, const Number& b) { return a * b.inverse(); }
  Number operator-() const;
  friend bool operator==(const Number& a, const Number& b);
  friend bool operator!=(const Number& a, const Number& b) { return !(a == b); }

 private:
  Terms terms_;
};

/// The value rounded to that many digits.
cln::cl_F to_float(const Number& number, cln::float_format_t digits);

/// Canonical text, e.g. "1/2*sqrt(3)"; equal numbers give equal text.
std::string to_string(const Number& number);

}  // namespace qvgen::exact
