// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <cln/rational.h>

namespace qvgen::exact {

/// Argument of a sine or cosine: a linear form of symbols plus a multiple of pi, with exact coefficients.
/// The canonical form has no zero coefficients and its first coefficient (by name) is positive; the sign
/// and whole multiples of pi/2 are taken out by Graph::sine and Graph::cosine.
struct Angle {
  std::map<std::string, cln::cl_RA> terms;
  cln::cl_RA pi = 0;  ///< multiple of pi

  friend bool operator==(const Angle& a, const Angle& b) { return a.terms == b.terms && a.pi == b.pi; }
};

Angle operator+(const Angle& a, const Angle& b);
Angle operator*(const cln::cl_RA& factor, const Angle& angle);

/// "(theta1 + theta2)/2" style text in a fixed order.
std::string to_string(const Angle& angle);

}  // namespace qvgen::exact
