// SPDX-License-Identifier: MIT
#pragma once

#include <cln/float.h>
#include <cln/lfloat.h>
#include <cln/real.h>
#include <qvgen/inverse/branch.h>

#include "exact/number.h"

namespace qvgen::verify {

/// A real number of sixty decimal digits that the runtime's building blocks accept as their scalar, so that a
/// plan is certified with the very code that users run.
class Real {
 public:
  Real() : Real(0) {}
  Real(int value)
      : value_(cln::cl_float(cln::cl_I(value), format())) {}  // NOLINT(google-explicit-constructor)
  explicit Real(double value) : value_(cln::cl_float(value, format())) {}
  explicit Real(const exact::Number& value) : Real(exact::to_float(value, format())) {}
  explicit Real(const cln::cl_R& value) : value_(cln::cl_float(value, format())) {}

  [[nodiscard]] const cln::cl_F& value() const { return value_; }
  [[nodiscard]] double to_double() const { return cln::double_approx(value_); }
  static Real pi() { return Real(cln::pi(format())); }

  Real operator-() const { return Real(-value_); }
  friend Real operator+(const Real& a, const Real& b) { return Real(a.value_ + b.value_); }
  friend Real operator-(const Real& a, const Real& b) { return Real(a.value_ - b.value_); }
  friend Real operator*(const Real& a, const Real& b) { return Real(a.value_ * b.value_); }
  /// Infinite quotients do not exist here: x/0 is a number that fails every test of a range.
  friend Real operator/(const Real& a, const Real& b) {
    if (cln::zerop(b.value_)) return Real(1e300);
    return Real(a.value_ / b.value_);
  }
  Real& operator+=(const Real& b) { return *this = *this + b; }
  Real& operator-=(const Real& b) { return *this = *this - b; }
  friend bool operator<(const Real& a, const Real& b) { return a.value_ < b.value_; }
  friend bool operator>(const Real& a, const Real& b) { return b < a; }
  friend bool operator<=(const Real& a, const Real& b) { return !(b < a); }
  friend bool operator>=(const Real& a, const Real& b) { return !(a < b); }
  friend bool operator==(const Real& a, const Real& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Real& a, const Real& b) { return !(a == b); }

  friend Real sqrt(const Real& x) { return Real(cln::sqrt(x.value_)); }
  friend Real abs(const Real& x) { return Real(cln::abs(x.value_)); }
  friend Real cos(const Real& x) { return Real(cln::cos(x.value_)); }
  friend Real sin(const Real& x) { return Real(cln::sin(x.value_)); }
  friend Real cbrt(const Real& x) {
    if (cln::zerop(x.value_)) return x;
    const cln::cl_R root = cln::exp(cln::ln(cln::abs(x.value_)) / 3);
    return cln::minusp(x.value_) ? Real(-root) : Real(root);
  }
  friend Real atan2(const Real& y, const Real& x) {
    if (cln::zerop(y.value_)) return cln::minusp(x.value_) ? pi() : Real(0);
    return Real(cln::atan(x.value_, y.value_));
  }

 private:
  static cln::float_format_t format() {
    static const cln::float_format_t sixty_digits = cln::float_format(60);
    return sixty_digits;
  }
  cln::cl_F value_;
};

}  // namespace qvgen::verify

template <>
struct qvgen::inverse::ScalarTraits<qvgen::verify::Real> {
  using Mask = bool;
  static verify::Real epsilon() { return verify::Real(1e-57); }
};
