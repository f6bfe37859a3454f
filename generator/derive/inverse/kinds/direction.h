// SPDX-License-Identifier: MIT
#pragma once

#include <ginac/ginac.h>
#include <qvgen/inverse/angles.h>
#include <qvgen/inverse/roots.h>

#include "derive/inverse/kinds/unknown.h"

/// Steps whose equation gives the direction (x, y) of an angle.
namespace qvgen::derive::inverse::kind {

struct Direction {
  int degree =
      1;  ///< units of (x, y): 0 none, 1 a length, 2 a length squared, 4 the square of a short length
  bool unit = true;  ///< the direction is brought to length one; otherwise it is left as long as it is
  GiNaC::ex length;  ///< the direction's length, zero if it is not known without a root
  bool length_known = false;    ///< that length is an input of the block, of a direction that is not unit
  bool at_double_root = false;  ///< (x, y) vanishes where an equation before has a double root

 protected:
  /// `opposites`: the opposite direction is another branch.
  template <class Backend>
  auto directed(const Unknown& of, bool opposites, Backend& b) const {
    using namespace qvgen::inverse;
    const auto v = b.pair("x", "y");
    const auto tiny = noise(v, b);
    if (unit)
      return b.direction(
          "direction", [](auto&&... a) { return direction(a...); }, opposites, v, tiny, b.seed_turn(of.joint),
          b.branch());
    if (length_known)
      return b.direction(
          "span_of_length", [](auto&&... a) { return span_of_length(a...); }, opposites, v, b.input("length"),
          tiny, b.seed_brief(of.joint), b.length_of(of.unknown), b.branch());
    return b.direction(
        "span", [](auto&&... a) { return span(a...); }, opposites, v, tiny, b.seed_brief(of.joint),
        b.length_of(of.unknown), b.branch());
  }

 private:
  /// Below which square a direction is noise.
  template <class V, class Backend>
  auto noise(const V& v, Backend& b) const {
    const auto solve = [](auto&&... a) { return qvgen::inverse::tiny_at_double_root(a...); };
    return at_double_root ? b.call("tiny_at_double_root", solve, v, b.tiny(degree), b.boundary(), b.branch())
                          : b.tiny(degree);
  }
};

/// ±(x, y): a·x = 0 on a circle. Inputs: x, y, and length if it is known.
struct Opposite : Direction {
  static constexpr const char* title = "two opposite directions";

  [[nodiscard]] std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) const {
    const Formula radius = {", r = +-sqrt(x^2 + y^2)", ",\\ r = \\pm\\sqrt{x^2 + y^2}"};
    return {{"phi = atan2(y, x) or atan2(-y, -x)" + (unit ? "" : radius.text),
             "\\varphi = \\mathrm{atan2}(\\pm y, \\pm x)" + (unit ? "" : radius.latex)}};
  }

  template <class Backend>
  auto apply(const Unknown& of, Backend& b) const {
    const auto found = b.scaled(b.sign(), directed(of, true, b));
    if (!unit) b.signed_length(of.unknown, b.sign());
    return b.turn(found);
  }
};

/// (x, y): the angle that turns one known vector into another. Inputs: x, y, and length if it is known.
struct Pair : Direction {
  static constexpr const char* title = "turn of one known vector into another";

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"phi = atan2(y, x)", "\\varphi = \\mathrm{atan2}(y, x)"}};
  }

  template <class Backend>
  auto apply(const Unknown& of, Backend& b) const {
    const auto found = directed(of, false, b);
    if (!unit) b.signed_length(of.unknown, b.number(1));
    return b.turn(found);
  }
};

/// Direction of a sum of joint angles, which is (choice_x, choice_y) where it is free. Inputs: x, y,
/// choice_x, choice_y.
struct ChosenPair {
  static constexpr const char* title = Pair::title;

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& joints) {
    return Pair::solution(joints);
  }

  template <class Backend>
  static auto apply(const Unknown& /*of*/, Backend& b) {
    const auto solve = [](auto&&... a) { return qvgen::inverse::chosen_direction(a...); };
    return b.turn(b.call("chosen_direction", solve, b.pair("x", "y"), b.pair("choice_x", "choice_y"),
                         b.boundary(), b.branch()));
  }
};

/// The direction of a free angle φ with inner <= |point + offset turned by φ|² <= outer, so that the joints
/// after it can follow; no unknown. Inputs: point_x, point_y, offset_x, offset_y, inner, outer.
struct Reach {
  static constexpr const char* title = "a choice within reach";
  /// A joint whose angle, with its sense, is one of those that add up to the free one.
  struct Seed {
    int joint;
    int sense;
  };
  std::vector<Seed> seeds;

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"phi: inner <= |point + offset turned by phi|^2 <= outer",
             "\\varphi:\\ \\mathrm{inner} \\le |\\mathrm{point} + e^{i\\varphi}\\,\\mathrm{offset}|^2 "
             "\\le \\mathrm{outer}"}};
  }

  template <class Backend>
  auto apply(const Unknown& /*of*/, Backend& b) const {
    const auto solve = [](auto&&... a) { return qvgen::inverse::reachable_direction(a...); };
    return b.turn(b.call("reachable_direction", solve, b.pair("point_x", "point_y"),
                         b.pair("offset_x", "offset_y"), b.input("inner"), b.input("outer"),
                         b.sum_of_seeds(seeds), b.boundary()));
  }
};

/// Cosine and sine of half an angle already known. Inputs: cosine, sine.
struct Half {
  static constexpr const char* title = "half angle";
  /// True if a direction of any length will do, as for the half angles of a wrist with right angles.
  bool of_any_length = true;
  std::vector<std::string> lengths;  ///< unknowns among the angle's terms whose direction is not unit

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {};
  }

  template <class Backend>
  auto apply(const Unknown& /*of*/, Backend& b) const {
    const auto turn = b.pair("cosine", "sine");
    if (!of_any_length)
      return b.turn(b.call(
          "half", [](auto&& t) { return qvgen::inverse::half(t); }, turn));
    const auto solve = [](auto&& t, auto&& length) { return qvgen::inverse::half_direction(t, length); };
    return b.turn(b.call("half_direction", solve, turn, b.product_of_lengths(lengths)));
  }
};

}  // namespace qvgen::derive::inverse::kind
