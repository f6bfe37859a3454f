// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/roots.h>

#include "derive/inverse/kinds/unknown.h"

/// Steps whose equation is a line or a circle that meets a circle: two angles ±φ from a direction.
namespace qvgen::derive::inverse::kind {

inline constexpr const char* meets_circle = "line or circle meets circle";

/// cos φ = (high - low)/(high + low), from a direction that is a constant of the arm. Inputs: low, high,
/// scale = 1/(low + high).
struct Circle {
  static constexpr const char* title = meets_circle;

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"phi = +-2*atan2(sqrt(low), sqrt(high))",
             "\\varphi = \\pm 2\\,\\mathrm{atan2}(\\sqrt{\\mathrm{low}}, \\sqrt{\\mathrm{high}})"}};
  }

  template <class Backend>
  static auto apply(const Unknown& /*of*/, Backend& b) {
    const auto solve = [](auto&&... a) { return qvgen::inverse::circle_angle(a...); };
    return b.turn(b.call("circle_angle", solve, b.input("low"), b.input("high"), b.input("scale"), b.sign(),
                         b.boundary(), b.branch()));
  }
};

/// Angle of a circle, from a direction (x, y) of the pose, which vanishes where the angle is free. Inputs:
/// low, high, x, y.
struct FreeCircle {
  static constexpr const char* title = meets_circle;
  int degree = 1;  ///< the direction's units, as in `Direction`

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& joints) {
    const Formula from = Circle::solution(joints).front();
    return {{from.text + ", from the direction (x, y)", from.latex + "\\text{ from the direction } (x, y)"}};
  }

  template <class Backend>
  auto apply(const Unknown& of, Backend& b) const {
    const auto solve = [](auto&&... a) { return qvgen::inverse::free_circle_angle(a...); };
    return b.turn(b.call("free_circle_angle", solve, b.input("low"), b.input("high"), b.pair("x", "y"),
                         b.tiny(degree), b.seed_turn(of.joint), b.sign(), b.boundary(), b.branch()));
  }
};

/// Angle of a circle whose two values are known without a root: one is a direction of its own, the other its
/// mirror image about (x, y), which vanishes where the angle is free. Four-bars with sides equal in pairs
/// (parallelograms, kites) lead to it. Inputs: straight_x, straight_y, x, y, arm_square.
struct FoldingCircle {
  static constexpr const char* title = "circle meets circle, its discriminant a square";
  int degree = 1;  ///< the direction's units, as in `Direction`

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"phi = atan2(straight_y, straight_x), or its mirror image about the direction (x, y)",
             "\\varphi = \\mathrm{atan2}(\\mathrm{straight}_y, \\mathrm{straight}_x)"
             "\\text{ or its mirror image about } (x, y)"}};
  }

  template <class Backend>
  auto apply(const Unknown& of, Backend& b) const {
    const auto solve = [](auto&&... a) { return qvgen::inverse::folding_circle_angle(a...); };
    return b.turn(b.call("folding_circle_angle", solve, b.pair("straight_x", "straight_y"), b.pair("x", "y"),
                         b.input("arm_square"), b.tiny(degree), b.seed_turn(of.joint), b.sign(), b.boundary(),
                         b.branch()));
  }
};

/// cos φ = rhs/|(x, y)| and sin² φ |(x, y)|² = low*high, which rounding does not touch. Inputs: x, y, rhs,
/// low, high.
struct FactoredCircle {
  static constexpr const char* title = "line meets circle, its discriminant in factors";
  int degree = 1;  ///< the direction's units, as in `Direction`

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"phi = +-atan2(sqrt(low*high), rhs), from the direction (x, y)",
             "\\varphi = \\pm\\mathrm{atan2}(\\sqrt{\\mathrm{low}\\,\\mathrm{high}}, "
             "\\mathrm{rhs})\\text{ from the direction } (x, y)"}};
  }

  template <class Backend>
  auto apply(const Unknown& of, Backend& b) const {
    const auto solve = [](auto&&... a) { return qvgen::inverse::factored_line_angle(a...); };
    return b.turn(b.call("factored_line_angle", solve, b.pair("x", "y"), b.input("rhs"), b.input("low"),
                         b.input("high"), b.tiny(degree), b.seed_turn(of.joint), b.sign(), b.boundary(),
                         b.branch()));
  }
};

}  // namespace qvgen::derive::inverse::kind
