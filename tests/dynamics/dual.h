// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>

/// A number and its derivative along one direction (forward differentiation). Eigen's AutoDiffScalar does the
/// same with a type of its own for every expression, and the generated functions have thousands of them.
struct Dual {
  double value = 0;
  double derivative = 0;

  Dual() = default;
  Dual(double number, double slope = 0) : value(number), derivative(slope) {}  // a number is a constant

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.derivative + b.derivative};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.derivative - b.derivative};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.derivative * b.value + a.value * b.derivative};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.derivative - quotient * b.derivative) / b.value};
  }
  friend Dual operator-(const Dual& a) { return {-a.value, -a.derivative}; }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }

  friend Dual sin(const Dual& x) { return {std::sin(x.value), std::cos(x.value) * x.derivative}; }
  friend Dual cos(const Dual& x) { return {std::cos(x.value), -std::sin(x.value) * x.derivative}; }
  friend Dual sqrt(const Dual& x) {
    const double root = std::sqrt(x.value);
    return {root, x.derivative / (2 * root)};
  }
  friend Dual abs(const Dual& x) { return x.value < 0 ? -x : x; }
};

template <>
struct Eigen::NumTraits<Dual> : Eigen::NumTraits<double> {
  using Real = Dual;
  using NonInteger = Dual;
  using Nested = Dual;
  using Literal = Dual;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 2,
    MulCost = 6
  };
};
