// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cln/float.h>
#include <cln/float_io.h>
#include <cln/real.h>

namespace qvgen::test {

/// A float of 60 decimal digits, so that generated functions can be differentiated by differences.
class Exact {
 public:
  Exact() : Exact(0.0) {}
  Exact(double value) : value_(cln::cl_float(value, format())) {}  // NOLINT(google-explicit-constructor)
  explicit Exact(const cln::cl_F& value) : value_(value) {}
  static cln::float_format_t format() { return cln::float_format(60); }
  static Exact power_of_ten(int exponent) {
    return Exact(cln::cl_float(cln::expt(cln::cl_RA(10), exponent), format()));
  }

  friend Exact operator+(const Exact& a, const Exact& b) { return Exact(a.value_ + b.value_); }
  friend Exact operator-(const Exact& a, const Exact& b) { return Exact(a.value_ - b.value_); }
  friend Exact operator*(const Exact& a, const Exact& b) { return Exact(a.value_ * b.value_); }
  friend Exact operator/(const Exact& a, const Exact& b) { return Exact(a.value_ / b.value_); }
  Exact operator-() const { return Exact(-value_); }
  Exact& operator+=(const Exact& other) { return *this = *this + other; }
  Exact& operator-=(const Exact& other) { return *this = *this - other; }
  Exact& operator*=(const Exact& other) { return *this = *this * other; }
  friend bool operator==(const Exact& a, const Exact& b) { return a.value_ == b.value_; }
  friend Exact sin(const Exact& a) { return Exact(cln::sin(a.value_)); }
  friend Exact cos(const Exact& a) { return Exact(cln::cos(a.value_)); }
  explicit operator double() const { return cln::double_approx(value_); }

 private:
  cln::cl_F value_;
};

}  // namespace qvgen::test

template <>
struct Eigen::NumTraits<qvgen::test::Exact> : Eigen::GenericNumTraits<qvgen::test::Exact> {
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 10,
    AddCost = 20,
    MulCost = 50
  };
};
