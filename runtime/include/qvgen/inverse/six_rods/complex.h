// SPDX-License-Identifier: MIT
// Complex numbers for homotopies of platforms. Products of std::complex test for NaN and call the library;
// here a product is four multiplications, and what is not finite is found at the end of a path.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace qvgen::inverse::six_rods {

struct Complex {
  double re = 0, im = 0;
};

constexpr Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
constexpr Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
constexpr Complex operator-(Complex a) { return {-a.re, -a.im}; }
constexpr Complex operator*(Complex a, double b) { return {a.re * b, a.im * b}; }
constexpr Complex operator*(double a, Complex b) { return b * a; }
constexpr Complex operator*(Complex a, Complex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
constexpr Complex& operator+=(Complex& a, Complex b) { return a = a + b; }
constexpr Complex& operator-=(Complex& a, Complex b) { return a = a - b; }

constexpr double square(Complex a) { return a.re * a.re + a.im * a.im; }
inline double size(Complex a) { return std::sqrt(square(a)); }
constexpr Complex reciprocal(Complex a) {
  const double scale = 1 / square(a);
  return {a.re * scale, -a.im * scale};
}

/// Returns the largest absolute value.
template <std::size_t n>
double largest(const std::array<Complex, n>& values) {
  double most = 0;
  for (const Complex& each : values) most = std::max(most, square(each));
  return std::sqrt(most);
}

template <std::size_t n>
bool is_finite(const std::array<Complex, n>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](Complex each) { return std::isfinite(each.re) && std::isfinite(each.im); });
}

}  // namespace qvgen::inverse::six_rods
