// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <ginac/ginac.h>

namespace qvgen::derive::inverse {

/// The angle of a revolute joint that is held, as expressions have it: quaternions by half of it, lengths and
/// directions by all of it, of which products of two half angles are polynomials.
class HeldAngle {
 public:
  explicit HeldAngle(const std::string& variable);

  /// An expanded expression of even degree in the half angle's cosine and sine, in those of the whole angle
  /// and linear in its sine: equal expressions are then the same, and constants are seen. Any other comes
  /// back as it is.
  [[nodiscard]] GiNaC::ex in_whole_angle(const GiNaC::ex& expanded) const;

  /// The expression without its sines and cosines of this angle and of half of it.
  [[nodiscard]] GiNaC::ex left_out(const GiNaC::ex& value) const;

  /// The expression where this angle is zero.
  [[nodiscard]] GiNaC::ex at_zero(const GiNaC::ex& value) const;

  GiNaC::symbol cosine, sine;          ///< cos_VARIABLE, sin_VARIABLE
  GiNaC::ex cosine_value, sine_value;  ///< what they stand for

 private:
  GiNaC::ex half_cosine_, half_sine_;
};

}  // namespace qvgen::derive::inverse
