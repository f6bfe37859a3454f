// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <qvgen/inverse/branch.h>

namespace qvgen::inverse {

template <typename Scalar>
struct CubicRoots {
  int count = 0;
  std::array<Scalar, 3> root{};
};

/// Returns x³ + b x² + c x + d.
template <typename Scalar>
Scalar cubic(const Scalar& x, const Scalar& b, const Scalar& c, const Scalar& d) {
  return ((x + b) * x + c) * x + d;
}

/// Two Newton steps on x³ + b x² + c x + d, taken only where they help.
template <typename Scalar>
Scalar polished_cubic_root(Scalar x, const Scalar& b, const Scalar& c, const Scalar& d) {
  using std::abs;
  for (int step = 0; step < 2; ++step) {
    const Scalar slope = (Scalar(3) * x + Scalar(2) * b) * x + c;
    if (slope == Scalar(0)) return x;
    const Scalar next = x - cubic(x, b, c, d) / slope;
    if (!(abs(cubic(next, b, c, d)) < abs(cubic(x, b, c, d)))) return x;
    x = next;
  }
  return x;
}

/// Real roots of x³ + b x² + c x + d (Cardano, with the trigonometric form where all three are real).
template <typename Scalar>
CubicRoots<Scalar> real_cubic(const Scalar& b, const Scalar& c, const Scalar& d, const Scalar& pi) {
  using std::abs;
  using std::atan2;
  using std::cbrt;
  using std::cos;
  using std::sqrt;
  const Scalar shift = b / Scalar(3);
  const Scalar p = c - b * shift;
  const Scalar q = Scalar(2) * shift * shift * shift - shift * c + d;
  const Scalar middle = q / Scalar(2);
  const Scalar discriminant = middle * middle + p * p * p / Scalar(27);
  CubicRoots<Scalar> found;
  if (discriminant > Scalar(0)) {
    const Scalar u = cbrt(Scalar(-middle - with_sign(sqrt(discriminant), middle)));
    found.count = 1;
    found.root[0] = u == Scalar(0) ? u : Scalar(u - p / (Scalar(3) * u));
  } else {
    const Scalar radius = Scalar(2) * sqrt(not_negative(Scalar(-p / Scalar(3))));
    const Scalar third = atan2(sqrt(not_negative(Scalar(-discriminant))), Scalar(-middle)) / Scalar(3);
    found.count = 3;
    for (int k = 0; k < 3; ++k)
      found.root[static_cast<std::size_t>(k)] = radius * cos(Scalar(third - Scalar(2 * k) * pi / Scalar(3)));
  }
  for (int k = 0; k < found.count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    found.root[at] = polished_cubic_root(Scalar(found.root[at] - shift), b, c, d);
  }
  return found;
}

}  // namespace qvgen::inverse
