// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/conic_circle.h>
#include <qvgen/inverse/slide_and_turn.h>
#include <qvgen/inverse/two_turns.h>

#include "derive/inverse/kinds/unknown.h"

/// Steps whose block gives all of its solutions at once, as many as there happen to be: roots of a quartic,
/// or of a polynomial of degree eight.
namespace qvgen::derive::inverse::kind {

struct Quartic {};

/// A conic on the unit circle: a quartic in the half-angle tangent. Inputs: xx, xy, yy, x, y, one.
struct Conic : Quartic {
  static constexpr const char* title = "conic meets circle (quartic)";

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {{"xx*cos(phi)^2 + xy*cos(phi)*sin(phi) + yy*sin(phi)^2 + x*cos(phi) + y*sin(phi) + one = 0",
             "0 = \\mathrm{xx} \\cos^2\\varphi + \\mathrm{xy} \\cos\\varphi \\sin\\varphi + "
             "\\mathrm{yy} \\sin^2\\varphi + x \\cos\\varphi + y \\sin\\varphi + \\mathrm{one}"}};
  }

  template <class Backend>
  static auto apply(const Unknown& /*of*/, Backend& b) {
    using Equation = qvgen::inverse::Conic<typename Backend::Number>;
    const auto solve = [](auto&&... a) { return qvgen::inverse::conic_circle(a...); };
    const auto conic = b.template make<Equation>("Conic", b.input("xx"), b.input("xy"), b.input("yy"),
                                                 b.input("x"), b.input("y"), b.input("one"));
    return b.roots("CircleRoots", b.call("conic_circle", solve, conic, b.boundary(), b.pi()));
  }
};

/// divisor t = l(u), t² + 2 h t + m(u) = 0 for a slide t and a unit vector u, l and m linear. Inputs:
/// divisor, h, level, l_x, l_y, mean, m_x, m_y. The step's joint is the one that turns.
struct SlideTurn : Quartic {
  static constexpr const char* title = "turn and slide by a linear equation and a distance (quartic)";
  int slide = -1;  ///< index of the joint that slides

  explicit SlideTurn(int joint) : slide(joint) {}

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {
        {"divisor*r = level + l_x*cos(phi) + l_y*sin(phi), r^2 + 2*h*r + mean + m_x*cos(phi) + "
         "m_y*sin(phi) = 0",
         "\\mathrm{divisor}\\,r - \\mathrm{level} - l_x \\cos\\varphi - l_y \\sin\\varphi = 0 = r^2 + 2 "
         "h r + \\mathrm{mean} + m_x \\cos\\varphi + m_y \\sin\\varphi"}};
  }

  template <class Backend>
  auto apply(const Unknown& /*of*/, Backend& b) const {
    using Equations = qvgen::inverse::SlideAndTurn<typename Backend::Number>;
    const auto solve = [](auto&&... a) { return qvgen::inverse::slide_and_turn(a...); };
    const auto equations = b.template make<Equations>(
        "SlideAndTurn", b.input("divisor"), b.input("h"), b.input("level"),
        b.nested(b.input("l_x"), b.input("l_y")), b.input("mean"), b.nested(b.input("m_x"), b.input("m_y")));
    return b.roots("SlideTurns", b.call("slide_and_turn", solve, equations, b.tiny(1), b.size_square(),
                                        b.seed_slide(slide), b.spread(), b.boundary(), b.pi()));
  }
};

/// Two equations that are linear in (cos u, sin u) and in (cos v, sin v): u is the step's joint, v is left as
/// result_1 and result_2. Inputs: a_00 ... a_22 and b_00 ... b_22, the coefficients of (1, cos u, sin u)
/// times (1, cos v, sin v).
struct TwoTurns : Quartic {
  static constexpr const char* title = "two equations linear in two unit vectors (degree eight)";
  bool at_most_six = false;  ///< the equations are those of a planar platform

  explicit TwoTurns(bool six) : at_most_six(six) {}

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {
        {"(1, cos(phi), sin(phi)) A (1, cos(v), sin(v))' = 0 = (1, cos(phi), sin(phi)) B (1, cos(v), "
         "sin(v))'",
         "(1, \\cos\\varphi, \\sin\\varphi)\\,A\\,(1, \\cos v, \\sin v)^T = 0 = "
         "(1, \\cos\\varphi, \\sin\\varphi)\\,B\\,(1, \\cos v, \\sin v)^T"}};
  }

  template <class Backend>
  auto apply(const Unknown& /*of*/, Backend& b) const {
    using Equation = qvgen::inverse::TwoTurnsEquation<typename Backend::Number>;
    const auto solve = [](auto&&... a) { return qvgen::inverse::two_turns(a...); };
    const auto one = b.template make<Equation>(
        "TwoTurnsEquation", b.input("a_00"), b.input("a_01"), b.input("a_02"), b.input("a_10"),
        b.input("a_11"), b.input("a_12"), b.input("a_20"), b.input("a_21"), b.input("a_22"));
    const auto other = b.template make<Equation>(
        "TwoTurnsEquation", b.input("b_00"), b.input("b_01"), b.input("b_02"), b.input("b_10"),
        b.input("b_11"), b.input("b_12"), b.input("b_20"), b.input("b_21"), b.input("b_22"));
    return b.roots("TurnPairs", b.call("two_turns", solve, one, other, b.flag(at_most_six)));
  }
};

}  // namespace qvgen::derive::inverse::kind
