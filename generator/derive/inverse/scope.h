// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "derive/inverse/held_angle.h"
#include "derive/inverse/sample_point.h"
#include "model/robot.h"
#include "symbolic/program.h"

namespace qvgen::derive::inverse {

/// The symbols of a derivation with sample values, and the test whether an expression in them vanishes.
///
/// Every symbol carries three random values that respect what is known of it (unit quaternions are unit,
/// cosine and sine of one angle lie on the circle). An expression is zero if it vanishes at all of them to 50
/// of 60 digits; for algebraic expressions a chance hit at rational points of this size does not occur.
class Scope {
 public:
  /// `held`: the parameter that is the angle of a held joint, if there is one.
  explicit Scope(const model::Robot& robot, const std::string& held = "");

  symbolic::Quaternion quaternion(const std::string& prefix);
  /// A quaternion that is the same but for its length, whose inverse square is the symbol `scale`.
  symbolic::Quaternion unscaled(const std::string& prefix, const std::string& scale,
                                const symbolic::Quaternion& unit);
  symbolic::Vector vector(const std::string& prefix);
  GiNaC::ex length(const std::string& name);
  struct Turn {
    GiNaC::ex cosine, sine;
  };
  Turn turn(const std::string& name);  ///< cos_name, sin_name

  [[nodiscard]] bool is_zero(const GiNaC::ex& value) const;
  [[nodiscard]] bool is_zero(const symbolic::Vector& v) const {
    return is_zero(v.x) && is_zero(v.y) && is_zero(v.z);
  }
  [[nodiscard]] const std::optional<HeldAngle>& held() const { return held_; }

  /// Expanded, with what vanishes replaced by 0 and half of a held angle by the whole where that is possible.
  [[nodiscard]] GiNaC::ex clean(const GiNaC::ex& value) const;
  [[nodiscard]] symbolic::Vector clean(const symbolic::Vector& v) const {
    return {clean(v.x), clean(v.y), clean(v.z)};
  }
  /// Cleaned, and the number that it is if nothing in it matters: what a held joint does not change, say.
  [[nodiscard]] GiNaC::ex settled(const GiNaC::ex& value) const;
  [[nodiscard]] symbolic::Vector settled(const symbolic::Vector& v) const {
    return {settled(v.x), settled(v.y), settled(v.z)};
  }
  /// A number, or made of numbers alone.
  [[nodiscard]] static bool is_number(const GiNaC::ex& value);
  /// A number, or made of numbers, named constants and what was defined by these alone.
  [[nodiscard]] bool is_known(const GiNaC::ex& value) const;
  /// Value at the first sample point, a number of 60 digits.
  [[nodiscard]] GiNaC::numeric value(const GiNaC::ex& value) const;
  /// Returns the sample of a value, rounded.
  [[nodiscard]] double sample(const GiNaC::ex& value) const;

  /// Names a value as an output of the program and returns its symbol; numbers and single symbols stay
  /// themselves.
  GiNaC::ex define(symbolic::Program& program, const std::string& name, const GiNaC::ex& value);
  /// Renames any value, symbols too: one that does not outlive its step, say.
  GiNaC::ex rename(symbolic::Program& program, const std::string& name, const GiNaC::ex& value);
  symbolic::Vector define(symbolic::Program& program, const std::string& name, const symbolic::Vector& value);
  symbolic::Quaternion define(symbolic::Program& program, const std::string& name,
                              const symbolic::Quaternion& value);

 private:
  static constexpr std::size_t points = 3;
  using Samples = std::array<SamplePoint, points>;
  GiNaC::ex add(const std::string& name, const std::array<GiNaC::ex, points>& values);
  GiNaC::numeric random();

  Samples samples_;
  std::set<std::string> known_;  ///< names of what was defined by numbers and named constants
  std::optional<HeldAngle> held_;
  unsigned long state_ = 88172645463325252UL;
};

}  // namespace qvgen::derive::inverse
