// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/roots.h>
#include <qvgen/inverse/slides.h>

#include "derive/inverse/kinds/unknown.h"

/// Steps that give lengths of prismatic joints, and the condition that gives nothing.
namespace qvgen::derive::inverse::kind {

/// ±sqrt(square) from the foot of a perpendicular. Inputs: square, scale.
struct Root {
  static constexpr const char* title = "foot of the perpendicular and square root";

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"r = +-sqrt(square)", "r = \\pm\\sqrt{\\mathrm{square}}"}};
  }

  template <class Backend>
  static auto apply(const Unknown& /*of*/, Backend& b) {
    const auto solve = [](auto&&... a) { return qvgen::inverse::signed_root(a...); };
    return b.length(b.call("signed_root", solve, b.input("square"), b.input("scale"), b.tiny(1), b.sign(),
                           b.boundary(), b.branch()));
  }
};

/// One value, written out; needs no building block.
struct Linear {
  static constexpr const char* title = "linear";

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {};
  }

  template <class Backend>
  static auto apply(const Unknown& /*of*/, Backend& b) {
    return b.nothing();
  }
};

/// t divisor = rhs, or t (x, y) = (rhs_x, rhs_y) in a plane: the slide is free where what the pose gives
/// there vanishes. Inputs: divisor, rhs or x, y, rhs_x, rhs_y; and those of its reach: point_x, point_y,
/// along_x, along_y, inner and outer.
struct Line {
  static constexpr const char* title = "linear, with a divisor that may vanish";
  bool in_plane = false;
  /// Which values of a free slide the joint after it can follow: |point + t along|² from inner, to outer.
  enum class Reach { any, beyond, between };
  Reach reach = Reach::any;

  [[nodiscard]] std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) const {
    if (!in_plane) return {{"r = rhs/divisor", "r = \\frac{\\mathrm{rhs}}{\\mathrm{divisor}}"}};
    return {{"r = (x*rhs_x + y*rhs_y)/(x^2 + y^2)",
             "r = \\frac{x\\,\\mathrm{rhs}_x + y\\,\\mathrm{rhs}_y}{x^2 + y^2}"}};
  }

  template <class Backend>
  auto apply(const Unknown& of, Backend& b) const {
    const auto solve = [](auto&&... a) { return qvgen::inverse::slide_on_line(a...); };
    const auto along = in_plane ? b.pair("x", "y") : b.rotor(b.input("divisor"), b.number(0));
    const auto rhs = in_plane ? b.pair("rhs_x", "rhs_y") : b.rotor(b.input("rhs"), b.number(0));
    return b.length(
        b.call("slide_on_line", solve, along, rhs, b.tiny(1), choice(of, b), b.boundary(), b.branch()));
  }

 private:
  /// The slide's seed, or what is nearest to it with the joint after it in reach.
  template <class Backend>
  auto choice(const Unknown& of, Backend& b) const -> typename Backend::Number {
    const auto seed = b.seed_slide(of.joint);
    if (reach == Reach::any) return seed;
    const auto point = b.pair("point_x", "point_y");
    const auto along = b.pair("along_x", "along_y");
    if (reach == Reach::between)
      return b.call(
          "slide_between", [](auto&&... a) { return qvgen::inverse::slide_between(a...); }, point, along,
          b.input("inner"), b.input("outer"), seed, b.spread());
    return b.call(
        "slide_beyond", [](auto&&... a) { return qvgen::inverse::slide_beyond(a...); }, point, along,
        b.input("inner"), b.size_square(), seed, b.spread());
  }
};

/// t (x, y) + s (other_x, other_y) = (rhs_x, rhs_y) in a plane, s another slide that is found later. Inputs:
/// x, y, other_x, other_y, rhs_x, rhs_y.
struct Beside {
  static constexpr const char* title = "linear, beside another slide";

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"r = (rhs_x*other_y - rhs_y*other_x)/(x*other_y - y*other_x)",
             "r = \\frac{\\mathrm{rhs}_x\\,\\mathrm{other}_y - \\mathrm{rhs}_y\\,\\mathrm{other}_x}"
             "{x\\,\\mathrm{other}_y - y\\,\\mathrm{other}_x}"}};
  }

  template <class Backend>
  static auto apply(const Unknown& of, Backend& b) {
    const auto solve = [](auto&&... a) { return qvgen::inverse::slide_beside(a...); };
    return b.length(b.call("slide_beside", solve, b.pair("x", "y"), b.pair("other_x", "other_y"),
                           b.pair("rhs_x", "rhs_y"), b.tiny(1), b.seed_slide(of.joint), b.boundary(),
                           b.branch()));
  }
};

/// a s - b t = k, s² + 2 g s - t² - 2 f t + gap = 0: gives result_1, the step's joint, and result_2. Inputs:
/// a, b, k, g, f, gap.
struct Slides {
  static constexpr const char* title = "two slides by a linear and a quadratic equation";

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"a*r_1 - b*r_2 = k, r_1^2 + 2*g*r_1 - r_2^2 - 2*f*r_2 + gap = 0",
             "0 = a r_1 - b r_2 - k = r_1^2 + 2 g r_1 - r_2^2 - 2 f r_2 + \\mathrm{gap}"}};
  }

  template <class Backend>
  static auto apply(const Unknown& of, Backend& b) {
    const auto solve = [](auto&&... a) { return qvgen::inverse::two_slides(a...); };
    return b.two_lengths(b.call("two_slides", solve, b.pair("a", "b"), b.input("k"), b.pair("g", "f"),
                                b.input("gap"), b.tiny(1), b.size_square(), b.seed_slide(of.joint),
                                b.spread(), of.branches == 1 ? b.number(0) : b.sign(), b.boundary(),
                                b.branch()));
  }
};

/// No unknown: an equation that the pose must satisfy. Inputs: residual, scale.
struct Require {
  static constexpr const char* title = "condition";

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"|residual| <= tolerance*scale",
             "|\\mathrm{residual}| \\le \\mathrm{tolerance} \\cdot \\mathrm{scale}"}};
  }

  template <class Backend>
  static auto apply(const Unknown& /*of*/, Backend& b) {
    const auto check = [](auto&&... a) { qvgen::inverse::require_zero(a...); };
    return b.condition("require_zero", check, b.input("residual"), b.input("scale"), b.tolerance(),
                       b.branch());
  }
};

}  // namespace qvgen::derive::inverse::kind
